#include "devo_evo/experiment/scale.h"

namespace devo_evo
{
namespace
{
// What is not set here is the paper's at every scale. docs/study.md has the same as a table; a test compares them.

void makeQuick(Parameters& parameters)
{
  parameters.experiment.trials = 3;
  parameters.experiment.generations = 20;
  parameters.experiment.evolution.population = 10;
  parameters.experiment.body.soft.lifetime = 2.0;
  StudySettings& study = parameters.study;
  study.baseline_trials = 3;
  study.baseline_generations = 20;
  study.sweep_trials = 2;
  study.sweep_generations = 10;
  study.rigid_trials = 2;
  study.rigid_generations = 2;
  study.walks = 3;
  study.walk_steps = 20;
  study.neutral_lineages = 20;
  study.impact_reproductions = 2000;
}

void makeOvernight(Parameters& parameters)
{
  parameters.experiment.trials = 8;
  parameters.experiment.generations = 500;
  StudySettings& study = parameters.study;
  study.baseline_trials = 3;
  study.baseline_generations = 500;
  study.sweep_trials = 2;
  study.sweep_generations = 150;
  study.rigid_trials = 8;
  study.rigid_generations = 100;
  study.walks = 3;
  study.walk_steps = 100;
}

void makeThePapers(Parameters& parameters)
{
  parameters.experiment.trials = 30;
  parameters.experiment.generations = 10000;
}
}  // namespace

Parameters parametersAtScale(Scale scale)
{
  Parameters parameters;
  switch (scale)
  {
    case Scale::QUICK:
      makeQuick(parameters);
      break;
    case Scale::OVERNIGHT:
      makeOvernight(parameters);
      break;
    case Scale::PAPER:
      makeThePapers(parameters);
      break;
  }
  parameters.study.scale = scale;
  return parameters;
}
}  // namespace devo_evo
