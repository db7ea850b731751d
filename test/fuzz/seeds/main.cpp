// Writes those inputs of the corpus that are not made by hand, or compares the corpus with them.

#include "fuzz/seeds/seeds.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

namespace
{
using namespace devo_evo::fuzz;
namespace fs = std::filesystem;

std::vector<Seed> reproducibleSeeds()
{
  std::vector<Seed> all;
  for (const auto& seeds : { evaluateRequestSeeds(), evaluateResponseSeeds(), evolvedRobotSeeds(), announcementSeeds(),
                             archiveRequestSeeds(), parameterValueSeeds() })
  {
    all.insert(all.end(), seeds.begin(), seeds.end());
  }
  return all;
}

void write(const fs::path& corpus, const std::vector<Seed>& seeds)
{
  for (const Seed& seed : seeds)
  {
    const fs::path path = corpus / seed.path();
    fs::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << seed.bytes;
    file.close();
    if (!file)
    {
      throw std::runtime_error(path.string() + " cannot be written");
    }
  }
}

/// @return whether the corpus has every seed as it is.
bool compare(const fs::path& corpus, const std::vector<Seed>& seeds)
{
  bool equal = true;
  for (const Seed& seed : seeds)
  {
    std::ifstream file(corpus / seed.path(), std::ios::binary);
    const std::string bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
    if (!file || bytes != seed.bytes)
    {
      std::cerr << (corpus / seed.path()).string() << (file ? " is not what" : " is missing;")
                << " messages and parameters give now" << std::endl;
      equal = false;
    }
  }
  return equal;
}
}  // namespace

int main(int argc, char** argv)
{
  const std::string action = argc == 3 ? argv[1] : "";
  if (action == "write")
  {
    write(argv[2], reproducibleSeeds());
    write(argv[2], archiveSeeds());
    return 0;
  }
  if (action == "compare")
  {
    const bool equal = compare(argv[2], reproducibleSeeds());
    std::cerr << (equal ? "" : "write it anew: " + std::string(argv[0]) + " write " + argv[2] + "\n");
    return equal ? 0 : 1;
  }
  std::cerr << "usage: " << argv[0] << " write|compare CORPUS" << std::endl;
  return 2;
}
