#include "devo_evo/experiment/settings.h"

#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/soft_body/text.h"
#include "soft_body/check_ranges.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

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
  if (evolution.founders)
  {
    for (const Genome& founder : *evolution.founders)
    {
      devo_evo::validate(founder, evolution, body);
    }
  }
  if (output.empty() || output.front() != '/')
  {
    throw InvalidInput("output is \"" + output + "\"; it must be an absolute path");
  }
}

namespace
{
/// What an experiment can go on with: with mutation rates exactly if they evolve.
Genome asFounder(Genome genome, const ExperimentSettings& settings)
{
  std::vector<double>& rates = genome.mutation_rate;
  if (settings.evolution.mutation_rate)
  {
    rates.clear();
  }
  else if (rates.empty())
  {
    rates.assign(static_cast<size_t>(settings.body.voxelCount()), settings.evolution.minimum_mutation_rate);
  }
  validate(genome, settings.evolution, settings.body);
  return genome;
}

std::ifstream openFounders(const std::string& path)
{
  std::error_code ignored;
  if (path.front() != '/')
  {
    throw InvalidInput("founders is \"" + path + "\"; it must be the absolute path of a file");
  }
  if (std::filesystem::is_directory(path, ignored))
  {
    throw InvalidInput("founders: " + path + " is a folder; a file of JSON lines is needed");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw InvalidInput("founders: " + path + " cannot be read: " + std::strerror(errno));
  }
  return file;
}
}  // namespace

void loadFounders(ExperimentSettings& settings)
{
  settings.evolution.founders.reset();
  if (settings.founders.empty())
  {
    return;
  }
  std::ifstream file = openFounders(settings.founders);
  RobotReader reader(file, settings.founders, settings.body);
  auto founders = std::make_shared<std::vector<Genome>>();
  while (auto robot = reader.next())
  {
    const std::string place = settings.founders + ", line " + toText(robot->line) + ", robot " + toJson(robot->id);
    if (founders->size() == static_cast<size_t>(settings.evolution.population))
    {
      throw InvalidInput(place + ": it is one founder more than the population has; give fewer, or set population");
    }
    try
    {
      founders->push_back(asFounder(std::move(robot->genome), settings));
    }
    catch (const InvalidInput& error)
    {
      throw InvalidInput(place + ": " + error.what());
    }
  }
  if (founders->empty())
  {
    throw InvalidInput("founders: there is no robot in " + settings.founders);
  }
  settings.evolution.founders = std::move(founders);
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
