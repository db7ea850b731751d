#include "devo_evo/soft_body/simulation.h"

#include "state_hash.h"

namespace devo_evo
{
namespace
{
constexpr int ROBOTS = 8;  // fills the lanes of every kernel

/// Numbers in [-1, 1) that look random (SplitMix64), the same everywhere.
std::vector<double> scrambledGenes(uint64_t& state, int count)
{
  std::vector<double> genes;
  for (int i = 0; i < count; ++i)
  {
    uint64_t bits = state += 0x9E3779B97F4A7C15u;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
    bits ^= bits >> 31;
    genes.push_back(static_cast<double>(bits >> 11) * 0x1p-52 - 1.0);
  }
  return genes;
}
}  // namespace

uint64_t engineFingerprint(InstructionSet instruction_set)
{
  SoftBodySettings settings;
  settings.lifetime = 0.25;
  uint64_t state = 0;
  std::vector<DevelopmentalProgram> robots;
  for (int robot = 0; robot < ROBOTS; ++robot)
  {
    DevelopmentalProgram program;
    program.size_gene_initial = scrambledGenes(state, settings.voxelCount());
    program.size_gene_final = scrambledGenes(state, settings.voxelCount());
    program.phase_initial = scrambledGenes(state, settings.voxelCount());
    program.phase_final = scrambledGenes(state, settings.voxelCount());
    robots.push_back(program);
  }
  StateHash hash;
  for (const Evaluation& evaluation : evaluate(settings, robots, instruction_set))
  {
    hash.add(evaluation.fitness);
    hash.add(evaluation.state_hash);
  }
  return hash.finish();
}
}  // namespace devo_evo
