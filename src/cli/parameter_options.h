#pragma once

#include "devo_evo/experiment/parameters.h"

#include <CLI/CLI.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace devo_evo
{
/// Parameters as options of a subcommand: --config FILE, and --NAME VALUE for every one of some groups.
class ParameterOptions
{
public:
  ParameterOptions(CLI::App& app, const std::vector<std::string>& groups);

  /// The defaults, changed by the file and then by the options. @throw InvalidInput
  Parameters read() const { return read(Parameters()); }

  /// The same with other defaults.
  Parameters read(Parameters defaults) const;

private:
  struct Given
  {
    std::string config;
    std::map<std::string, std::string> values;  ///< by name of the parameter, as written
    std::map<std::string, const CLI::Option*> options;
  };

  std::shared_ptr<Given> given_ = std::make_shared<Given>();  // CLI11 keeps references to what it sets
};

/// A folder as an absolute path, from one relative to the working folder.
std::string absoluteFolder(const std::string& folder);

/// The number of threads that the parameter `simulators` asks for: 0 means one a core.
int threadCount(const Parameters& parameters);
}  // namespace devo_evo
