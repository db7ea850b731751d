#include "benchmark/known_results.h"

#include "devo_evo/soft_body/text.h"

#include "soft_body/state_hash.h"

#include <fstream>
#include <stdexcept>

namespace devo_evo
{
namespace
{
const std::string FILE_NAME = BENCHMARK_DIR "/known_results.txt";

/// What the file says of a scene; empty if nothing. Each line: scene and hash.
std::string knownHash(const std::string& scene)
{
  std::ifstream file(FILE_NAME);
  if (!file)
  {
    throw std::runtime_error("cannot read " + FILE_NAME);
  }
  std::string name;
  std::string hash;
  while (file >> name >> hash)
  {
    if (name == scene)
    {
      return hash;
    }
  }
  return "";
}
}  // namespace

uint64_t combinedHash(const std::vector<Evaluation>& evaluations)
{
  StateHash hash;
  for (const Evaluation& evaluation : evaluations)
  {
    hash.add(evaluation.valid);
    if (evaluation.valid)
    {
      hash.add(evaluation.fitness);
      hash.add(evaluation.state_hash);
    }
  }
  return hash.finish();
}

void verifyResults(const std::string& scene, uint64_t hash)
{
  const std::string found = hashToString(hash);
  const std::string expected = knownHash(scene);
  if (found != expected)
  {
    throw std::runtime_error("scene " + scene + " gave results with the hash " + found + ", expected was " +
                             (expected.empty() ? "none" : expected) + " (" + FILE_NAME +
                             "); if results changed on purpose: devo_evo_benchmark --print-hashes > known_results.txt");
  }
}
}  // namespace devo_evo
