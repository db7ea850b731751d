#include "devo_evo/experiment/settings.h"

#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/experiment/parameters.h"
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

namespace
{
/// A parameter of another kind of body would be without effect, which is not what somebody who gives it expects.
void checkForeignParameters(const ExperimentSettings& settings)
{
  Parameters parameters;
  parameters.experiment = settings;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    const std::string value = spec.get(parameters);
    if (spec.body && *spec.body != settings.body.kind && value != spec.default_text)
    {
      throw InvalidInput(spec.name + " is " + value + ", but it is a parameter of " + toString(*spec.body) +
                         " bodies, and body is " + toString(settings.body.kind) + "; leave it at " + spec.default_text);
    }
  }
}
}  // namespace

void ExperimentSettings::validateBody() const
{
  body.validate();
  checkForeignParameters(*this);
}

void ExperimentSettings::validate() const
{
  validateBody();
  evolution.validate();
  checkRanges(*this, experimentIntegers());
  if (evolution.founders)
  {
    const GenomeLayout layout = makeBody(body)->layout(evolution);
    for (const Genome& founder : *evolution.founders)
    {
      devo_evo::validate(founder, evolution, layout);
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
Genome asFounder(Genome genome, const EvolutionSettings& settings, const GenomeLayout& layout)
{
  std::vector<double>& rates = genome.mutation_rate;
  if (!layout.self_adaptive)
  {
    rates.clear();
  }
  else if (rates.empty())
  {
    rates.assign(layout.morphology.size, settings.minimum_mutation_rate);
  }
  validate(genome, settings, layout);
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
  const std::shared_ptr<const Body> body = makeBody(settings.body);
  const GenomeLayout layout = body->layout(settings.evolution);
  RobotReader reader(file, settings.founders, *body);
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
      founders->push_back(asFounder(std::move(robot->genome), settings.evolution, layout));
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
  std::string arm = makeBody(settings.body)->layout(settings.evolution).arm;
  std::replace(arm.begin(), arm.end(), '/', '-');
  return std::string(home) + "/devo_evo/" + arm + "-seed-" + toText(settings.evolution.seed);
}
}  // namespace devo_evo
