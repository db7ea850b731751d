#include "devo_evo/evolution/genome.h"

#include "evolution/sha256.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
void addProgram(Sha256& hash, const DevelopmentalProgram& program)
{
  hash.add(program.size_gene_initial).add(program.size_gene_final).add(program.phase_initial).add(program.phase_final);
}

Hash128 firstHalf(Sha256& hash)
{
  const std::array<uint8_t, 32> whole = hash.finish();
  Hash128 half;
  std::copy_n(whole.begin(), half.size(), half.begin());
  return half;
}
}  // namespace

bool Genome::operator==(const Genome& other) const
{
  return program == other.program && mutation_rate == other.mutation_rate;
}

std::vector<TraitSpec> evolvingTraits(const EvolutionSettings& settings)
{
  const double size_sigma = settings.size_mutation_sigma;
  const double phase_limit = settings.phaseLimit();
  std::vector<TraitSpec> traits = {
    { "size_gene_initial", &DevelopmentalProgram::size_gene_initial, 1.0, size_sigma, true },
    { "size_gene_final", &DevelopmentalProgram::size_gene_final, 1.0, size_sigma, true },
    { "phase_initial", &DevelopmentalProgram::phase_initial, phase_limit, phase_limit, false },
    { "phase_final", &DevelopmentalProgram::phase_final, phase_limit, phase_limit, false },
  };
  if (settings.treatment == Treatment::EVO)
  {
    return { traits[0], traits[2] };
  }
  return traits;
}

Hash128 phenotypeHash(const DevelopmentalProgram& program)
{
  Sha256 hash;
  addProgram(hash, program);
  return firstHalf(hash);
}

Hash128 genomeHash(const Genome& genome)
{
  Sha256 hash;
  addProgram(hash, genome.program);
  hash.add(genome.mutation_rate);
  return firstHalf(hash);
}

std::string toHex(const Hash128& hash)
{
  std::string digits;
  for (const uint8_t byte : hash)
  {
    digits += "0123456789abcdef"[byte >> 4];
    digits += "0123456789abcdef"[byte & 0xf];
  }
  return digits;
}
}  // namespace devo_evo
