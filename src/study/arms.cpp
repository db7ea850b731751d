#include "study/arms.h"

#include "devo_evo/archive/archive.h"
#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <iterator>

namespace devo_evo
{
namespace
{
const std::vector<Treatment> THE_PAPERS = { Treatment::EVO, Treatment::EVO_DEVO };

Arm makeArm(StudyPart part, const Parameters& parameters, Treatment treatment, const std::string& suffix = "")
{
  Arm arm;
  arm.part = part;
  arm.name = toString(part) + "/" + toString(treatment) + suffix;
  arm.settings = ofBody(part == StudyPart::RIGID ? BodyKind::RIGID : BodyKind::SOFT, parameters.experiment);
  arm.settings.evolution.treatment = treatment;
  arm.settings.output += "/" + arm.name;
  return arm;
}

std::vector<Arm> armsWith(StudyPart part, const Parameters& parameters, const std::vector<Treatment>& treatments)
{
  std::vector<Arm> arms;
  for (const Treatment treatment : treatments)
  {
    arms.push_back(makeArm(part, parameters, treatment));
  }
  return arms;
}

std::vector<Arm> baselineArms(const Parameters& parameters)
{
  std::vector<Arm> arms;
  for (const Treatment treatment : THE_PAPERS)
  {
    for (const Selection selection : { Selection::RANDOM_SEARCH, Selection::NEUTRAL })
    {
      arms.push_back(makeArm(StudyPart::BASELINES, parameters, treatment, "-" + toString(selection)));
      ExperimentSettings& settings = arms.back().settings;
      settings.evolution.selection = selection;
      settings.trials = parameters.study.baseline_trials;
      settings.generations = parameters.study.baseline_generations;
    }
  }
  return arms;
}

std::vector<Arm> sweepArms(const Parameters& parameters)
{
  std::vector<Arm> arms;
  for (const Treatment treatment : THE_PAPERS)
  {
    for (const double rate : parameters.study.sweep_48ths)
    {
      arms.push_back(makeArm(StudyPart::SWEEP, parameters, treatment, "-" + toText(rate) + "_48"));
      ExperimentSettings& settings = arms.back().settings;
      settings.evolution.mutation_rate = rate / 48.0;
      settings.trials = parameters.study.sweep_trials;
      settings.generations = parameters.study.sweep_generations;
    }
  }
  return arms;
}

/// The treatments of MAIN with rigid bodies.
std::vector<Arm> rigidArms(const Parameters& parameters)
{
  std::vector<Arm> arms = armsWith(StudyPart::RIGID, parameters, THE_PAPERS);
  for (Arm& arm : arms)
  {
    arm.settings.trials = parameters.study.rigid_trials;
    arm.settings.generations = parameters.study.rigid_generations;
  }
  return arms;
}
}  // namespace

const std::vector<BodyKind>& studiedBodies()
{
  static const std::vector<BodyKind> kinds = { BodyKind::SOFT, BodyKind::RIGID };
  return kinds;
}

ExperimentSettings ofBody(BodyKind kind, const ExperimentSettings& settings)
{
  Parameters parameters;
  parameters.experiment = settings;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (spec.body && spec.body != kind)
    {
      spec.set(parameters, spec.default_text);
    }
  }
  parameters.experiment.body.kind = kind;
  return parameters.experiment;
}

std::vector<Arm> armsOf(StudyPart part, const Parameters& parameters)
{
  switch (part)
  {
    case StudyPart::MAIN:
      return armsWith(part, parameters, THE_PAPERS);
    case StudyPart::PARTIAL:
      return armsWith(part, parameters, { Treatment::EVO_DEVO_BODY, Treatment::EVO_DEVO_CONTROL });
    case StudyPart::BASELINES:
      return baselineArms(parameters);
    case StudyPart::SWEEP:
      return sweepArms(parameters);
    case StudyPart::RIGID:
      return rigidArms(parameters);
    default:
      return {};
  }
}

std::vector<Arm> analysedArms(const Parameters& parameters)
{
  std::vector<Arm> arms = armsOf(StudyPart::MAIN, parameters);
  const std::vector<Arm> partial = armsOf(StudyPart::PARTIAL, parameters);
  std::copy_if(partial.begin(), partial.end(), std::back_inserter(arms), hasBegun);
  return arms;
}

bool hasBegun(const Arm& arm)
{
  return archiveHasBegun(arm.settings.output);
}
}  // namespace devo_evo
