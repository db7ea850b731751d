#pragma once

#include "devo_evo/experiment/settings.h"
#include "devo_evo/experiment/study_settings.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace devo_evo
{
/// What a player shows, and how.
struct PlayerParameters
{
  std::string individual = "best";        ///< "best", a trial like "3" (its champion), or an individual like "3/1042"
  std::string genome_file;                ///< file of JSON lines to show a robot of instead; "": none
  std::string colour = "resting_length";  ///< name of a Colouring
  double speed = 1.0;                     ///< simulated time over real time [1]
  double loop_pause = 1.0;                ///< between the end of a life and its next beginning [s]
  double frame_rate = 25.0;               ///< of what is published [1/s]
  double offset = 0.0;                    ///< how far beside its true place, along x, it is shown [body lengths]
};

/// Every setting of the programs: the experiment, how the farm runs it, and what a study makes of it. One name each in
/// YAML, launch files and the command-line tool.
struct Parameters
{
  ExperimentSettings experiment;  ///< output: "" until somebody asks for defaultOutput()

  StudySettings study;

  int simulators = 0;                    ///< simulator nodes, or threads of the tool; 0: one a core [1]
  std::string instruction_set = "auto";  ///< "auto", "scalar", "avx2" or "avx512"
  double batch_timeout = 60.0;           ///< how long a simulator may take for a batch before it counts as lost [s]
  double checked_fraction = 0.005;       ///< of evaluations that the evolver has made twice [1]
  double announcement_period = 0.5;      ///< how often a simulator announces itself [s]
  bool record = false;                   ///< whether the evolver waits for a recorder before it begins

  PlayerParameters player;
};

/// A value as a source gives it. Text is taken for every type, since launch arguments, command lines and YAML scalars
/// are text; the parameter server has types.
using ParameterValue = std::variant<bool, int64_t, double, std::string, std::vector<int64_t>>;

/// Description of one parameter: the single source of checks, documentation and `--help`.
struct ParameterSpec
{
  std::string name;
  std::string group;         ///< "experiment", "evolution", "body", "physics", "rigid body", "farm", "nodes",
                             ///< "study" or "player"
  std::string unit;          ///< "" if it has none
  std::string description;   ///< one sentence, with the symbol in docs/physics.md where it has one
  std::string allowed;       ///< completes "it must be": "a whole number within 1 to 64", "true or false"
  std::string default_text;  ///< as one would write it

  /// The kind of body that it is of; none: of all.
  std::optional<BodyKind> body;

  /// Checks and sets. @throw InvalidInput naming parameter, value and what is allowed.
  std::function<void(Parameters&, const ParameterValue&)> set;

  /// The present value as one would write it: reads back as the same value, whatever the locale.
  std::function<std::string(const Parameters&)> get;
};

/// All parameters, group by group, in the order of the documentation.
const std::vector<ParameterSpec>& parameterSpecs();

/// Whether a parameter says what an experiment with this kind of body is, not where its files lie or what it runs on.
/// Those are archived.
bool describesExperiment(const ParameterSpec& spec, BodyKind kind);

/// Whether evaluations of this kind of body depend on it: kind, world and lifetime.
bool describesBody(const ParameterSpec& spec, BodyKind kind);

/// @throw InvalidInput if there is none of this name; the message names the closest one.
const ParameterSpec& parameterSpec(const std::string& name);

/// Sets one parameter. @param source where the value comes from, for the message: "experiment.yaml:12", "--seed".
/// @throw InvalidInput if there is none of this name or the value is not allowed.
void setParameter(Parameters& parameters, const std::string& name, const ParameterValue& value,
                  const std::string& source);

/// Sets what a YAML file holds. @throw InvalidInput with file and line for malformed YAML, unknown or repeated keys,
/// wrong types and values out of range; with the file if it cannot be read.
void loadParameters(Parameters& parameters, const std::string& yaml_file);

/// A YAML file with every parameter at its default, documented: config/experiment.yaml.
std::string parametersAsYaml();

/// A YAML file with the parameters of one experiment: whatever describes it.
std::string parametersAsYaml(const ExperimentSettings& settings);

/// A page of documentation on every parameter: docs/parameters.md.
std::string parametersAsMarkdown();
}  // namespace devo_evo
