#include "experiment/study_parameters.h"

#include "experiment/parameter_kinds.h"

namespace devo_evo
{
namespace
{
constexpr size_t LONGEST_LIST = 100;

StudySettings& studyOf(Parameters& parameters)
{
  return parameters.study;
}

const StudySettings& studyOf(const Parameters& parameters)
{
  return parameters.study;
}

/// A whole number.
ParameterSpec count(const char* name, int64_t StudySettings::*field, int64_t minimum, int64_t maximum,
                    const std::string& description)
{
  const BoundedField<StudySettings, int64_t> bounded = { name, field, minimum, maximum };
  return boundedSpec(
      [](auto& parameters) -> auto& { return studyOf(parameters); }, bounded, "study", "", description);
}

ParameterSpec choice(const char* name, bool StudySettings::*field, const std::string& description)
{
  const auto assign = [field](Parameters& parameters, const ParameterValue& value)
  {
    const auto boolean = asBoolean(value);
    studyOf(parameters).*field = boolean.value_or(studyOf(parameters).*field);
    return boolean.has_value();
  };
  const auto get = [field](const Parameters& parameters) { return studyOf(parameters).*field ? "true" : "false"; };
  return makeSpec({ name, "study", "", description }, "true or false", assign, get);
}

/// A list of numbers, possibly empty.
ParameterSpec list(const char* name, std::vector<double> StudySettings::*field, double minimum, double maximum,
                   bool whole, const std::string& description)
{
  const auto assign = [=](Parameters& parameters, const ParameterValue& value)
  {
    const auto numbers = asReals(value);
    const auto allowed = [=](double number)
    { return number >= minimum && number <= maximum && (!whole || number == static_cast<int>(number)); };
    if (!numbers || numbers->size() > LONGEST_LIST || !std::all_of(numbers->begin(), numbers->end(), allowed))
    {
      return false;
    }
    studyOf(parameters).*field = *numbers;
    return true;
  };
  const auto get = [field](const Parameters& parameters)
  {
    std::string text;
    for (const double number : studyOf(parameters).*field)
    {
      text += (text.empty() ? "" : ",") + toText(number);
    }
    return text;
  };
  const std::string kind = whole ? "whole numbers" : "numbers";
  return makeSpec({ name, "study", "", description },
                  "at most " + toText(static_cast<int64_t>(LONGEST_LIST)) + " " + kind + " within " + toText(minimum) +
                      " to " + toText(maximum) + ", separated by commas",
                  assign, get);
}

ParameterSpec scaleSpec()
{
  const auto scale = [](auto& parameters) -> auto&
  {
    return studyOf(parameters).scale;
  };
  return choiceSpec({ "scale", "study", "",
                      "How large a study is: it sets trials, generations, population, lifetime and the numbers below, "
                      "as far as they are not given (docs/study.md)." },
                    "quick, overnight or paper", scale, parseScale);
}

ParameterSpec onlySpec()
{
  const auto only = [](auto& parameters) -> auto&
  {
    return studyOf(parameters).only;
  };
  return choiceSpec({ "only", "study", "", "Parts of the study to run; empty: all but partial." },
                    "of " + toString(studyParts()) + ", separated by commas", only, parseStudyParts);
}
}  // namespace

std::vector<ParameterSpec> studySpecs()
{
  using S = StudySettings;
  return {
    scaleSpec(),
    onlySpec(),
    count("baseline_trials", &S::baseline_trials, 1, 10000, "Trials of each baseline."),
    count("baseline_generations", &S::baseline_generations, 0, 1000000, "Generations of each trial of a baseline."),
    count("sweep_trials", &S::sweep_trials, 1, 10000, "Trials at each fixed mutation rate."),
    count("sweep_generations", &S::sweep_generations, 0, 1000000, "Generations of each trial of the sweep."),
    list("sweep_48ths", &S::sweep_48ths, 0, 48, true, "Fixed mutation rates of the sweep, in 48ths."),
    count("rigid_trials", &S::rigid_trials, 1, 10000, "Trials of each treatment with rigid bodies."),
    count("rigid_generations", &S::rigid_generations, 0, 1000000, "Generations of each trial with rigid bodies."),
    count("walks", &S::walks, 1, 10000, "Random walks of each kind from each run champion."),
    count("walk_steps", &S::walk_steps, 1, 1000000, "Steps of each random walk."),
    choice("walk_removed", &S::walk_removed,
           "Whether champions frozen at birth are walked, too, with the operator of treatment evo."),
    choice("walk_one_voxel", &S::walk_one_voxel, "Whether there are random walks that change one voxel a step, too."),
    count("neutral_lineages", &S::neutral_lineages, 0, 100000,
          "Lineages without selection made for the lineage of each run champion."),
    count("impact_reproductions", &S::impact_reproductions, 2, 100000000,
          "Reproductions in which changes are counted, for each mutation rate."),
    list("friction_factors", &S::friction_factors, 0, 100, false,
         "Robustness: factors of static and dynamic friction, together."),
    list("gravity_factors", &S::gravity_factors, 0, 100, false, "Robustness: factors of gravity."),
    list("amplitude_factors", &S::amplitude_factors, 0, 100, false, "Robustness: factors of actuation_amplitude."),
    list("slopes", &S::slopes, -10, 10, false, "Robustness: slopes of the floor."),
  };
}
}  // namespace devo_evo
