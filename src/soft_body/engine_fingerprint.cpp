#include "devo_evo/soft_body/simulation.h"

#include "soft_body/scrambled_genes.h"
#include "state_hash.h"

namespace devo_evo
{
namespace
{
constexpr int ROBOTS = 8;  // fills the lanes of every kernel
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
    program.morphology_initial = scrambledGenes(state, settings.voxelCount());
    program.morphology_final = scrambledGenes(state, settings.voxelCount());
    program.control_initial = scrambledGenes(state, settings.voxelCount());
    program.control_final = scrambledGenes(state, settings.voxelCount());
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
