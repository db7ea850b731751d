#include "devo_evo/experiment/parameters.h"

#include "experiment/parameter_kinds.h"
#include "experiment/study_parameters.h"

namespace devo_evo
{
namespace
{
// ---- kinds, by where the field stands ------------------------------------------------------------------------------

/// A parameter that one kind of body has.
ParameterSpec only(BodyKind kind, ParameterSpec spec)
{
  spec.body = kind;
  return spec;
}

ParameterSpec experimentCount(const std::string& name, const std::string& description)
{
  const auto section = [](auto& parameters) -> auto&
  {
    return parameters.experiment;
  };
  return boundedSpec(section, fieldNamed(name, experimentIntegers()), "experiment", "", description);
}

ParameterSpec evolutionCount(const std::string& name, const std::string& description)
{
  const auto section = [](auto& parameters) -> auto&
  {
    return parameters.experiment.evolution;
  };
  return boundedSpec(section, fieldNamed(name, evolutionIntegers()), "evolution", "", description);
}

ParameterSpec evolutionNumber(const std::string& name, const std::string& description)
{
  const auto section = [](auto& parameters) -> auto&
  {
    return parameters.experiment.evolution;
  };
  return boundedSpec(section, fieldNamed(name, evolutionReals()), "evolution", "", description);
}

ParameterSpec bodyNumber(const std::string& name, const std::string& group, const std::string& unit,
                         const std::string& description)
{
  const auto section = [](auto& parameters) -> auto&
  {
    return parameters.experiment.body.soft;
  };
  return only(BodyKind::SOFT, boundedSpec(section, fieldNamed(name, softBodyReals()), group, unit, description));
}

ParameterSpec rigidNumber(const std::string& name, const std::string& unit, const std::string& description)
{
  const auto section = [](auto& parameters) -> auto&
  {
    return parameters.experiment.body.rigid;
  };
  return only(BodyKind::RIGID,
              boundedSpec(section, fieldNamed(name, rigidBodyReals()), "rigid body", unit, description));
}

template <class Value>
ParameterSpec ownNumber(const BoundedField<Parameters, Value>& field, const std::string& group, const std::string& unit,
                        const std::string& description)
{
  return boundedSpec(
      [](auto& parameters) -> auto& { return parameters; }, field, group, unit, description);
}

ParameterSpec physicsSwitch(const std::string& name, bool SoftBodySettings::*field, const std::string& description)
{
  const auto assign = [field](Parameters& parameters, const ParameterValue& value)
  {
    const auto boolean = asBoolean(value);
    bool& present = parameters.experiment.body.soft.*field;
    present = boolean.value_or(present);
    return boolean.has_value();
  };
  const auto get = [field](const Parameters& parameters)
  { return parameters.experiment.body.soft.*field ? "true" : "false"; };
  return only(BodyKind::SOFT, makeSpec({ name, "physics", "", description }, "true or false", assign, get));
}

// ---- parameters of a kind of their own -----------------------------------------------------------------------------

ParameterSpec seedSpec()
{
  const BoundedField<EvolutionSettings, int64_t> field = { "seed", &EvolutionSettings::seed, 0, INT64_MAX };
  return boundedSpec(
      [](auto& parameters) -> auto& { return parameters.experiment.evolution; }, field, "experiment", "",
      "Seed of all random numbers: the same seed gives the same evolution.");
}

ParameterSpec mutationRateSpec()
{
  const auto assign = [](Parameters& parameters, const ParameterValue& value)
  {
    auto& rate = parameters.experiment.evolution.mutation_rate;
    if (asText(value) == "self_adaptive")
    {
      rate.reset();
      return true;
    }
    const auto number = asReal(value);
    const bool allowed = number && *number >= 0.0 && *number <= 1.0;
    if (allowed)
    {
      rate = *number + 0.0;
    }
    return allowed;
  };
  const auto get = [](const Parameters& parameters)
  {
    const auto& rate = parameters.experiment.evolution.mutation_rate;
    return rate ? toText(*rate) : "self_adaptive";
  };
  return makeSpec({ "mutation_rate", "experiment", "",
                    "Probability lambda that a voxel's value changes when its trait mutates: one rate per voxel that "
                    "evolves itself, or a fixed one for all." },
                  "self_adaptive or a number within 0 to 1", assign, get);
}

ParameterSpec pathSpec(const std::string& name, std::string ExperimentSettings::*field, const std::string& kind,
                       const std::string& description)
{
  const auto assign = [field](Parameters& parameters, const ParameterValue& value)
  {
    const auto text = asText(value);
    const bool allowed = text && text->find('~') != 0;  // nobody would expand it
    if (allowed)
    {
      parameters.experiment.*field = *text;
    }
    return allowed;
  };
  return makeSpec({ name, "experiment", "", description }, "the path of a " + kind + ", written out without ~", assign,
                  [field](const Parameters& parameters) { return parameters.experiment.*field; });
}

ParameterSpec gridSpec()
{
  const auto& fields = softBodyIntegers();
  const auto assign = [&fields](Parameters& parameters, const ParameterValue& value)
  {
    const auto sizes = asGrid(value);
    SoftBodySettings body = parameters.experiment.body.soft;
    for (size_t axis = 0; sizes && axis < fields.size(); ++axis)
    {
      if ((*sizes)[axis] < fields[axis].minimum || (*sizes)[axis] > fields[axis].maximum)
      {
        return false;
      }
      body.*fields[axis].value = static_cast<int>((*sizes)[axis]);
    }
    parameters.experiment.body.soft = body;
    return sizes.has_value();
  };
  const auto get = [](const Parameters& parameters)
  {
    const auto& body = parameters.experiment.body.soft;
    return toText(body.grid_x) + "x" + toText(body.grid_y) + "x" + toText(body.grid_z);
  };
  return makeSpec(
      { "grid", "body", "voxels",
        "Size of the body along x (lateral), y (direction of travel) and z (up); one body length is its "
        "size along y." },
      "written like 4x4x3 or [4, 4, 3], each within " + toText(fields[0].minimum) + " to " + toText(fields[0].maximum),
      assign, get);
}

ParameterSpec instructionSetSpec()
{
  const auto assign = [](Parameters& parameters, const ParameterValue& value)
  {
    const auto text = asText(value);
    const auto names = { "auto", "scalar", "avx2", "avx512" };
    const bool allowed = text && std::find(names.begin(), names.end(), *text) != names.end();
    if (allowed)
    {
      parameters.instruction_set = *text;
    }
    return allowed;
  };
  return makeSpec({ "instruction_set", "farm", "",
                    "Instructions that simulators compute with; auto: the fastest that the processor has. Results are "
                    "the same to the last bit." },
                  "auto, scalar, avx2 or avx512", assign,
                  [](const Parameters& parameters) { return parameters.instruction_set; });
}

ParameterSpec recordSpec()
{
  const auto assign = [](Parameters& parameters, const ParameterValue& value)
  {
    const auto boolean = asBoolean(value);
    parameters.record = boolean.value_or(parameters.record);
    return boolean.has_value();
  };
  return makeSpec(
      { "record", "nodes", "",
        "Whether the evolver waits for a recorder before it begins, so that nothing is missing in the bag." },
      "true or false", assign, [](const Parameters& parameters) { return parameters.record ? "true" : "false"; });
}

// ---- parameters of the player --------------------------------------------------------------------------------------

ParameterSpec playerNumber(const BoundedField<PlayerParameters, double>& field, const std::string& unit,
                           const std::string& description)
{
  return boundedSpec(
      [](auto& parameters) -> auto& { return parameters.player; }, field, "player", unit, description);
}

/// Any text that passes a test; a whole number will do, too.
ParameterSpec playerText(const std::string& name, std::string PlayerParameters::*field, const std::string& description,
                         const std::string& allowed, bool (*is_allowed)(const std::string&))
{
  const auto assign = [=](Parameters& parameters, const ParameterValue& value)
  {
    const auto* const number = std::get_if<int64_t>(&value);
    const auto text = number != nullptr ? toText(*number) : asText(value);
    const bool good = text && is_allowed(*text);
    if (good)
    {
      parameters.player.*field = *text;
    }
    return good;
  };
  return makeSpec({ name, "player", "", description }, allowed, assign,
                  [=](const Parameters& parameters) { return parameters.player.*field; });
}

bool isGiven(const std::string& text)
{
  return !text.empty();
}

bool isFileName(const std::string& text)
{
  return text.empty() || text[0] == '/';
}

bool namesColouring(const std::string& text)
{
  const auto names = { "resting_length", "remaining_development", "phase", "present_length" };
  return std::find(names.begin(), names.end(), text) != names.end();
}

std::vector<ParameterSpec> playerSpecs()
{
  return {
    playerText("individual", &PlayerParameters::individual,
               "Which robot to show: the best of all trials or the champion of a trial, both followed as they improve, "
               "or one individual; with genome_file, the name of a robot in it (best: the first).",
               "best, a trial like 3, or a trial and an id like 3/1042", isGiven),
    playerText("genome_file", &PlayerParameters::genome_file,
               "File of JSON lines (docs/tool.md, \"Genomes\") of which a robot is shown instead; empty: none.",
               "the absolute path of a file", isFileName),
    playerText("colour", &PlayerParameters::colour, "What the colours of voxels tell (docs/nodes.md, \"Colours\").",
               "resting_length, remaining_development, phase or present_length", namesColouring),
    playerNumber({ "speed", &PlayerParameters::speed, 0.001, 100.0 }, "", "Simulated time over real time."),
    playerNumber({ "loop_pause", &PlayerParameters::loop_pause, 0.0, 3600.0 }, "s",
                 "Pause between the end of a life and its next beginning."),
    playerNumber({ "frame_rate", &PlayerParameters::frame_rate, 0.1, 200.0 }, "1/s", "Pictures a second."),
    playerNumber({ "offset", &PlayerParameters::offset, -1000.0, 1000.0 }, "body lengths",
                 "How far beside its true place, along x, the robot is shown: for several players side by side."),
  };
}

// ---- the table -----------------------------------------------------------------------------------------------------

std::vector<ParameterSpec> experimentSpecs()
{
  const auto treatment = [](auto& parameters) -> auto&
  {
    return parameters.experiment.evolution.treatment;
  };
  const auto profile = [](auto& parameters) -> auto&
  {
    return parameters.experiment.evolution.profile;
  };
  return {
    choiceSpec({ "treatment", "experiment", "",
                 "What develops over a robot's life: body and control, of soft robots resting lengths and phases "
                 "(evo_devo), one of them (evo_devo_body, "
                 "evo_devo_control), or nothing (evo)." },
               treatmentNames(), treatment, parseTreatment),
    only(BodyKind::SOFT,
         choiceSpec({ "profile", "experiment", "",
                      "Which is followed where the paper's text and its released code differ (docs/evolution.md)." },
                    "paper or released_code", profile, parseProfile)),
    only(BodyKind::SOFT, mutationRateSpec()),
    experimentCount("trials", "Independent repetitions of the evolution, numbered from 1; they advance side by side."),
    experimentCount("generations", "Generations of each trial after generation 0, the founders."),
    seedSpec(),
    pathSpec(
        "founders", &ExperimentSettings::founders, "file",
        "File of robots (JSON lines, docs/tool.md) that every trial starts with; founders that it has too few of are "
        "random. Empty: all are random. The robots are kept in the archive, and must be the same when it is resumed."),
    pathSpec("output", &ExperimentSettings::output, "folder",
             "Folder for everything the experiment writes; empty: "
             "$HOME/devo_evo/<treatment>-<profile>-<mutation rate>-seed-<seed>, with rigid bodies "
             "rigid-<treatment>-seed-<seed>. An experiment in it is resumed."),
  };
}

std::vector<ParameterSpec> evolutionSpecs()
{
  const auto selection = [](auto& parameters) -> auto&
  {
    return parameters.experiment.evolution.selection;
  };
  return {
    choiceSpec({ "selection", "evolution", "",
                 "Who survives: age-fitness-Pareto optimisation (afpo); or, as baselines, everybody with equal chances "
                 "(neutral) or the fittest of random robots (random_search)." },
               "afpo, neutral or random_search", selection, parseSelection),
    evolutionCount("population", "Robots that survive each generation."),
    evolutionCount("random_injections", "Robots of age 0 made at random that join each generation."),
    only(BodyKind::SOFT,
         evolutionNumber("size_mutation_sigma",
                         "Standard deviation of a size gene's mutation; 1 is 0.75 cm of resting length at the paper's "
                         "voxel_size.")),
    only(BodyKind::SOFT,
         evolutionNumber("meta_mutation_sigma",
                         "Standard deviation of the change of a self-adaptive mutation rate at every reproduction.")),
    only(BodyKind::SOFT,
         evolutionNumber("minimum_mutation_rate", "Lower bound and start of self-adaptive mutation rates.")),
    only(BodyKind::RIGID,
         evolutionNumber("rigid_mutation_sigma",
                         "Standard deviation of a mutation of a quadruped's weight or leg length, as a share of its "
                         "range.")),
  };
}

std::vector<ParameterSpec> bodySpecs()
{
  const auto kind = [](auto& parameters) -> auto&
  {
    return parameters.experiment.body.kind;
  };
  return {
    choiceSpec({ "body", "body", "",
                 "The kind of body: voxels, or the rigid quadruped of Fig S5 (docs/bodies.md). Parameters of the other "
                 "kind must be left at their defaults, except in a study, whose body is soft and which has rigid ones "
                 "besides." },
               bodyKindNames(), kind, parseBodyKind),
    only(BodyKind::SOFT, gridSpec()),
    bodyNumber("lifetime", "body", "s",
               "Time tau from birth to the end of an evaluation; 0.5 s of settling comes before it."),
  };
}

std::vector<ParameterSpec> physicsSpecs()
{
  return {
    bodyNumber("voxel_size", "physics", "m", "Lattice pitch and nominal edge length L of a voxel."),
    bodyNumber("density", "physics", "kg/m^3", "Density rho of a voxel at its nominal size."),
    bodyNumber("youngs_modulus", "physics", "Pa", "Young's modulus E of voxels."),
    bodyNumber("poissons_ratio", "physics", "", "Poisson's ratio nu of voxels."),
    bodyNumber("static_friction", "physics", "", "Coefficient mu_s of static friction between voxels and floor."),
    bodyNumber("dynamic_friction", "physics", "", "Coefficient mu_d of dynamic friction between voxels and floor."),
    bodyNumber("gravity", "physics", "m/s^2", "Gravitational acceleration g; along -z on level ground."),
    bodyNumber("slope", "physics", "", "Rise over run of the floor along +y; positive: uphill."),
    bodyNumber("bond_damping", "physics", "", "Damping ratio zeta_b of bonds; 1 is critical."),
    bodyNumber("contact_damping", "physics", "", "Damping ratio zeta_c of floor contacts; 1 is critical."),
    bodyNumber("global_damping", "physics", "", "Damping ratio zeta_g of every voxel's motion; 1 is critical."),
    bodyNumber("time_step_fraction", "physics", "",
               "Time step dt as a fraction of 1 / (2 pi sqrt(E L / m)), with m a voxel's mass."),
    bodyNumber("actuation_frequency", "physics", "Hz", "Frequency f of actuation."),
    bodyNumber("actuation_amplitude", "physics", "", "Amplitude A of actuation over voxel_size."),
    physicsSwitch("self_collision", &SoftBodySettings::self_collision,
                  "Whether voxels far apart in the lattice push each other apart."),
    physicsSwitch("sideways_bend_test", &SoftBodySettings::sideways_bend_test,
                  "Whether sideways bending too ends a bond's small-angle regime (docs/physics.md 2.2)."),
  };
}

std::vector<ParameterSpec> rigidBodySpecs()
{
  return {
    rigidNumber("rigid_lifetime", "s", "Time from birth to the end of an evaluation."),
    rigidNumber("rigid_time_step", "s", "Time step of the simulation."),
    rigidNumber("rigid_gravity", "m/s^2", "Gravitational acceleration along -z."),
    rigidNumber("rigid_slope", "degrees", "By which the floor descends towards +y."),
    rigidNumber("rigid_friction", "", "Coulomb's coefficient of friction between robot and floor."),
    rigidNumber("rigid_contact_stiffness", "N/m", "Stiffness of the floor at each contact."),
    rigidNumber("rigid_contact_damping", "N s/m", "Damping of the floor at each contact."),
    rigidNumber("rigid_light_distance", "m", "From the place of birth to the foot of the light, along the slope."),
    rigidNumber("rigid_light_height", "m", "Height of the light above the floor, along its normal."),
    rigidNumber("rigid_abdomen_radius", "m", "Radius of the spherical abdomen; one body length is twice as much."),
    rigidNumber("rigid_abdomen_mass", "kg", "Mass of the abdomen."),
    rigidNumber("rigid_leg_radius", "m", "Radius of the rounded rods that are the legs."),
    rigidNumber("rigid_leg_mass", "kg", "Mass of each leg."),
    rigidNumber("rigid_leg_residual", "m", "How far a leg of length 0 protrudes from the abdomen."),
    rigidNumber("rigid_leg_range", "m", "How much further a leg of length 1 protrudes."),
    rigidNumber("rigid_hinge_limit", "degrees", "How far a leg swings to either side of its place at rest."),
    rigidNumber("rigid_hinge_gain", "1/s", "Speed that a hinge's motor seeks, per angle that is missing."),
    rigidNumber("rigid_hinge_damping", "N m s", "Torque of a hinge's motor, per speed that is missing."),
    rigidNumber("rigid_hinge_torque", "N m", "Torque that a hinge's motor has at most."),
    rigidNumber("rigid_actuator_gain", "1/s", "Speed that a linear actuator seeks, per length that is missing."),
    rigidNumber("rigid_actuator_damping", "N s/m", "Force of a linear actuator, per speed that is missing."),
    rigidNumber("rigid_actuator_force", "N", "Force that a linear actuator has at most."),
    rigidNumber("rigid_generator_frequency", "Hz", "Frequency of the central pattern generators."),
  };
}

std::vector<ParameterSpec> farmSpecs()
{
  return {
    ownNumber<int>({ "simulators", &Parameters::simulators, 0, 1024 }, "farm", "",
                   "Simulator nodes to start, or threads of the command-line tool; 0: one a core."),
    instructionSetSpec(),
  };
}

std::vector<ParameterSpec> nodesSpecs()
{
  return {
    ownNumber<double>(
        { "batch_timeout", &Parameters::batch_timeout, 0.1, 86400.0 }, "nodes", "s",
        "How long a simulator may take for a batch before it counts as lost and its robots go to others."),
    ownNumber<double>({ "checked_fraction", &Parameters::checked_fraction, 0.0, 1.0 }, "nodes", "",
                      "Share of robots that the evolver has evaluated twice, by different simulators, to find those "
                      "that compute wrongly. Results do not depend on it."),
    ownNumber<double>({ "announcement_period", &Parameters::announcement_period, 0.05, 60.0 }, "nodes", "s",
                      "How often a simulator announces itself."),
    recordSpec(),
  };
}

std::vector<ParameterSpec> allSpecs()
{
  std::vector<ParameterSpec> specs;
  for (const auto& group : { experimentSpecs(), evolutionSpecs(), bodySpecs(), physicsSpecs(), rigidBodySpecs(),
                             farmSpecs(), nodesSpecs(), studySpecs(), playerSpecs() })
  {
    specs.insert(specs.end(), group.begin(), group.end());
  }
  return specs;
}

}  // namespace

const std::vector<ParameterSpec>& parameterSpecs()
{
  static const std::vector<ParameterSpec> specs = allSpecs();
  return specs;
}
}  // namespace devo_evo
