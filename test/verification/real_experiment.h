#pragma once

#include "archive/test_tools.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/farm/local_farm.h"
#include "devo_evo/soft_body/simulation.h"

#include <string>

namespace devo_evo::test
{
class NoObserver : public ExperimentObserver
{
public:
  void generationCommitted(const GenerationReport&) override {}
};

/// Evolves robots of four voxels with lives of 0.1 s: a real experiment in a fraction of a second.
inline ExperimentSettings shortLives(const std::string& output)
{
  ExperimentSettings settings = smallExperiment(output);
  settings.body.soft.lifetime = 0.1;
  settings.evolution.population = 4;
  settings.generations = 5;
  settings.trials = 2;
  return settings;
}

inline void evolveReally(const ExperimentSettings& settings)
{
  Provenance provenance = someProvenance();
  provenance.engine_fingerprint = 0;
  const auto archive = openArchiveForWriting(settings, provenance);
  const auto farm = makeLocalFarm(makeBody(settings.body), 1);
  NoObserver observer;
  Experiment(settings, *archive, *farm, observer).run();
}
}  // namespace devo_evo::test
