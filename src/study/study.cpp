#include "devo_evo/study/study.h"

#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/text.h"
#include "study/analyses.h"
#include "study/arms.h"

#include <cstdlib>

namespace devo_evo
{
namespace
{
/// Shows an arm's progress, and stops its experiment when the study is to stop.
class ArmObserver : public ExperimentObserver
{
public:
  ArmObserver(const Arm& arm, StudyObserver& observer) : arm_(arm), observer_(observer) {}

  void watch(Experiment& experiment) { experiment_ = &experiment; }

  void generationCommitted(const GenerationReport& report) override
  {
    observer_.showProgress(arm_.name + ": " + progressText(report, arm_.settings));
  }

  void tick() override
  {
    if (observer_.stopRequested())
    {
      experiment_->stopNow();
    }
  }

private:
  const Arm& arm_;
  StudyObserver& observer_;
  Experiment* experiment_ = nullptr;
};

/// Whether every trial is as long as wanted.
bool isFinished(const Arm& arm)
{
  if (!hasBegun(arm))
  {
    return false;
  }
  const auto states = openArchiveForReading(arm.settings.output)->trialStates();
  for (int64_t trial = 1; trial <= arm.settings.trials; ++trial)
  {
    const auto state = states.find(trial);
    if (state == states.end() || state->second.generation < arm.settings.generations)
    {
      return false;
    }
  }
  return true;
}

/// One call of runStudy().
class Run
{
public:
  Run(const Parameters& parameters, const Provenance& provenance, const FarmFactory& make_farm, StudyObserver& observer)
    : parameters_(parameters)
    , provenance_(provenance)
    , make_farm_(make_farm)
    , observer_(observer)
    , database_(parameters, provenance)
  {
  }

  RunOutcome run()
  {
    const std::vector<StudyPart> parts = partsOf(parameters_.study);
    size_t number = 0;
    for (const StudyPart part : parts)
    {
      observer_.partBegun(part, ++number, parts.size());
      if (!(armsOf(part, parameters_).empty() ? analyse(part) : evolve(part)))
      {
        return RunOutcome::STOPPED;
      }
      observer_.say(toString(part) + ": done");
    }
    return RunOutcome::FINISHED;
  }

private:
  bool evolve(StudyPart part)
  {
    for (const Arm& arm : armsOf(part, parameters_))
    {
      database_.putArm(arm);
      if (!isFinished(arm) && evolve(arm) == RunOutcome::STOPPED)
      {
        return false;
      }
    }
    return true;
  }

  RunOutcome evolve(const Arm& arm)
  {
    Provenance provenance = provenance_;
    if (arm.settings.body.kind != parameters_.experiment.body.kind)
    {
      provenance.engine_fingerprint = makeBody(arm.settings.body)->engineFingerprint(bestInstructionSet());
    }
    const auto archive = openArchiveForWriting(arm.settings, provenance);
    const auto farm = make_farm_(arm.settings.body);
    ArmObserver observer(arm, observer_);
    Experiment experiment(arm.settings, *archive, *farm, observer);
    observer.watch(experiment);
    const RunOutcome outcome = experiment.run();
    if (outcome == RunOutcome::FINISHED)
    {
      observer_.say(arm.name + ": digest " + archive->digest());
    }
    return outcome;
  }

  bool analyse(StudyPart part)
  {
    const bool of_champions = part != StudyPart::IMPACT;
    const std::vector<RunChampion> champions = of_champions ? runChampions(parameters_) : std::vector<RunChampion>();
    for (const RunChampion& champion : champions)
    {
      database_.putChampion(champion.arm, champion.individual, champion.generation);
    }
    for (const Analysis& analysis : analysesOf(part, parameters_, champions, database_))
    {
      const std::string title =
          toString(part) + (analysis.world.name == "as_evolved" ? "" : ", " + analysis.world.name);
      if (!doWork(title, analysis.world, analysis.keep_velocities, analysis.work, database_, make_farm_, observer_))
      {
        return false;
      }
    }
    return true;
  }

  const Parameters& parameters_;
  const Provenance& provenance_;
  const FarmFactory& make_farm_;
  StudyObserver& observer_;
  StudyDatabase database_;
};
}  // namespace

std::string defaultStudyOutput(const Parameters& parameters)
{
  const std::string experiment = defaultOutput(parameters.experiment);
  const EvolutionSettings& evolution = parameters.experiment.evolution;
  return experiment.substr(0, experiment.rfind('/')) + "/study-" + toString(parameters.study.scale) + "-" +
         toString(evolution.profile) + "-seed-" + toText(evolution.seed);
}

void validateStudy(const Parameters& parameters)
{
  const SoftBodySettings& voxels = softSettings(parameters.experiment.body, "a study");
  for (const BodyKind kind : studiedBodies())
  {
    ofBody(kind, parameters.experiment).validate();
  }
  const EvolutionSettings defaults;
  const EvolutionSettings& evolution = parameters.experiment.evolution;
  if (evolution.treatment != defaults.treatment || evolution.selection != defaults.selection)
  {
    throw InvalidInput("a study chooses treatments and selection itself; leave treatment and selection out");
  }
  if (!parameters.experiment.founders.empty())
  {
    throw InvalidInput("the founders of a study are random; leave founders out");
  }
  robustnessWorlds(voxels, parameters.study);
}

RunOutcome runStudy(const Parameters& parameters, const Provenance& provenance, const FarmFactory& make_farm,
                    StudyObserver& observer)
{
  validateStudy(parameters);
  return Run(parameters, provenance, make_farm, observer).run();
}
}  // namespace devo_evo
