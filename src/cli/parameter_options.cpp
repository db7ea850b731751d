#include "cli/parameter_options.h"

#include <algorithm>
#include <filesystem>
#include <thread>
#include <utility>

namespace devo_evo
{
ParameterOptions::ParameterOptions(CLI::App& app, const std::vector<std::string>& groups)
{
  app.add_option("--config", given_->config, "YAML file with parameters, see \"devo_evo parameters --yaml\"")
      ->type_name("FILE");
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (std::find(groups.begin(), groups.end(), spec.group) == groups.end())
    {
      continue;
    }
    const std::string names = spec.name == "simulators" ? "--simulators,--threads" : "--" + spec.name;
    const std::string unit = spec.unit.empty() ? "" : " " + spec.unit;
    const std::string value = spec.default_text.empty() ? "" : " (" + spec.default_text + unit + ")";
    given_->options[spec.name] = app.add_option(names, given_->values[spec.name], spec.description + value)
                                     ->type_name("VALUE")
                                     ->group("Parameters, " + spec.group);
  }
}

Parameters ParameterOptions::read(Parameters defaults) const
{
  Parameters parameters = std::move(defaults);
  if (!given_->config.empty())
  {
    loadParameters(parameters, given_->config);
  }
  for (const auto& [name, option] : given_->options)
  {
    if (option->count() > 0)
    {
      setParameter(parameters, name, given_->values.at(name), "--" + name);
    }
  }
  return parameters;
}

std::string absoluteFolder(const std::string& folder)
{
  const auto path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).string();  // without a slash at the end
}

int threadCount(const Parameters& parameters)
{
  const auto cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return parameters.simulators > 0 ? parameters.simulators : cores;
}
}  // namespace devo_evo
