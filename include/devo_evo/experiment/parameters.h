#pragma once

#include "devo_evo/experiment/settings.h"
#include "devo_evo/soft_body/simulation.h"

#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace devo_evo
{
/// Every setting of the programs: the experiment and how the nodes run it. One name each in YAML, launch files and the
/// command-line tool.
struct Parameters
{
  ExperimentSettings experiment;

  std::string instruction_set = "auto";  ///< "auto", "scalar", "avx2" or "avx512"
  double batch_timeout = 60.0;           ///< how long a simulator may take for a batch before it counts as lost [s]
  double announcement_period = 0.5;      ///< how often a simulator announces itself [s]
};

/// A value as a source gives it: YAML and the parameter server have types, launch arguments and command lines are text.
using ParameterValue = std::variant<bool, int64_t, double, std::string, std::vector<int64_t>>;

/// Description of one parameter: the single source of checks, documentation and `--help`.
struct ParameterSpec
{
  std::string name;
  std::string group;        ///< "experiment", "evolution", "body", "physics" or "nodes"
  std::string description;  ///< one sentence, with the symbol and the source in the paper where it has one
  std::string unit;         ///< "" if it has none
  std::string allowed;      ///< for people: "0.001 to 1000", "evo or evo_devo"
  std::string default_text; ///< as one would write it

  /// Checks and sets. @throw InvalidInput naming parameter, value and what is allowed.
  std::function<void(Parameters&, const ParameterValue&)> set;

  /// The present value as one would write it (17 digits, never by locale).
  std::function<std::string(const Parameters&)> get;
};

/// All parameters, in the order of the documentation.
const std::vector<ParameterSpec>& parameterSpecs();

/// @throw InvalidInput if there is none of this name; the message names the closest one.
const ParameterSpec& parameterSpec(const std::string& name);

/// Sets one parameter. @param source where the value comes from, for the message: "experiment.yaml", "--seed".
void setParameter(Parameters& parameters, const std::string& name, const ParameterValue& value,
                  const std::string& source);

/// Sets what a YAML file holds. @throw InvalidInput with file and line for malformed YAML, unknown keys, wrong types and
/// values out of range.
void loadParameters(Parameters& parameters, const std::string& yaml_file);
}  // namespace devo_evo
