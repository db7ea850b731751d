#include "devo_evo/experiment/settings.h"

#include "soft_body/check_ranges.h"

#include <algorithm>
#include <cstdlib>

namespace devo_evo
{
const std::vector<BoundedField<ExperimentSettings, int64_t>>& experimentIntegers()
{
  static const std::vector<BoundedField<ExperimentSettings, int64_t>> fields = {
    { "trials", &ExperimentSettings::trials, 1, 10000 },
    { "generations", &ExperimentSettings::generations, 0, 1000000 },
  };
  return fields;
}

void ExperimentSettings::validate() const
{
  body.validate();
  evolution.validate();
  checkRanges(*this, experimentIntegers());
  if (output.empty() || output.front() != '/')
  {
    throw InvalidInput("output is \"" + output + "\"; it must be an absolute path");
  }
}

std::string defaultOutput(const ExperimentSettings& settings)
{
  const char* home = std::getenv("HOME");
  if (home == nullptr || home[0] != '/')
  {
    throw InvalidInput(
        "output is not given, and there is no home folder to fall back to (HOME is not set); "
        "it must be an absolute path");
  }
  std::string arm = settings.evolution.arm();
  std::replace(arm.begin(), arm.end(), '/', '-');
  return std::string(home) + "/devo_evo/" + arm + "-seed-" + toText(settings.evolution.seed);
}
}  // namespace devo_evo
