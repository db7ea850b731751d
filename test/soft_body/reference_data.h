#pragma once

#include "devo_evo/soft_body/developmental_program.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace devo_evo
{
/// The JSON lines of a file of test/data (described in test/data/README.md).
inline std::vector<nlohmann::json> referenceLines(const std::string& file)
{
  std::ifstream stream(std::string(TEST_DATA_DIR) + "/" + file);
  if (!stream)
  {
    throw std::runtime_error("cannot read " + std::string(TEST_DATA_DIR) + "/" + file);
  }
  std::vector<nlohmann::json> lines;
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(nlohmann::json::parse(line));
  }
  return lines;
}

struct ReferenceGenome
{
  std::string id;
  DevelopmentalProgram program;
};

inline std::vector<ReferenceGenome> referenceGenomes()
{
  std::vector<ReferenceGenome> genomes;
  for (const nlohmann::json& line : referenceLines("genomes.jsonl"))
  {
    genomes.push_back({ line["id"],
                        { line["size_gene_initial"], line["size_gene_final"], line["phase_initial_cycles"],
                          line["phase_final_cycles"] } });
  }
  return genomes;
}
}  // namespace devo_evo
