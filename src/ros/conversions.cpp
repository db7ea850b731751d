#include "ros/conversions.h"

#include "devo_evo/soft_body/lattice.h"
#include "devo_evo/soft_body/text.h"

#include <ros/names.h>

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr double WINDOW = 0.5;  // of velocity telemetry [s]

void require(bool condition, const std::string& what)
{
  if (!condition)
  {
    throw InvalidInput(what);
  }
}

double orNone(const std::optional<double>& value)
{
  return value.value_or(Evaluation::NONE);
}

std::optional<double> noneIfNan(double value)
{
  return std::isnan(value) ? std::nullopt : std::optional<double>(value);
}

void requireFinite(const char* name, double value)
{
  require(std::isfinite(value), std::string(name) + " is " + toText(value) + "; it must be finite");
}

void requireWithin(const char* name, double value, double low, double high)
{
  require(value >= low && value <= high,
          std::string(name) + " is " + toText(value) + "; it must lie within " + toText(low) + " to " + toText(high));
}

/// A time since birth that may never have come.
std::optional<double> eventTime(const char* name, double value, const SoftBodySettings& settings)
{
  if (!std::isnan(value))
  {
    requireWithin(name, value, 0.0, settings.lifetime + 2.0 * settings.timeStep());
  }
  return noneIfNan(value);
}

Evaluation validEvaluation(const RobotEvaluation& message, const SoftBodySettings& settings)
{
  requireFinite("fitness", message.fitness);
  requireFinite("displacement_y_voxels", message.displacement_y_voxels);
  requireFinite("displacement_xy_voxels", message.displacement_xy_voxels);
  requireFinite("turns", message.turns);
  requireWithin("airborne_fraction", message.airborne_fraction, 0.0, 1.0);
  const double travelled = message.fitness * settings.grid_y;
  require(std::abs(travelled - message.displacement_y_voxels) <= 1e-9 * (1.0 + std::abs(travelled)),
          "fitness and displacement_y_voxels contradict each other");
  requireWithin("the number of velocity windows", static_cast<double>(message.velocity.size()),
                std::floor(settings.lifetime / WINDOW), std::ceil(settings.lifetime / WINDOW));
  for (const double velocity : message.velocity)
  {
    requireFinite("velocity", velocity);
  }
  require(message.divergence_step == 0 && message.divergence_bond == 0 && message.divergence_strain == 0.0,
          "a valid evaluation has a divergence");

  Evaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = message.fitness;
  evaluation.displacement_y_voxels = message.displacement_y_voxels;
  evaluation.displacement_xy_voxels = message.displacement_xy_voxels;
  evaluation.first_top_contact_since_birth_s =
      eventTime("first_top_contact_since_birth", message.first_top_contact_since_birth, settings);
  evaluation.fell_over_since_birth_s = eventTime("fell_over_since_birth", message.fell_over_since_birth, settings);
  evaluation.turns = message.turns;
  evaluation.airborne_fraction = message.airborne_fraction;
  evaluation.velocity_body_lengths_per_s = message.velocity;
  evaluation.state_hash = message.state_hash;
  return evaluation;
}

Evaluation divergedEvaluation(const RobotEvaluation& message, const SoftBodySettings& settings)
{
  for (const double measure : { message.fitness, message.displacement_y_voxels, message.displacement_xy_voxels,
                                message.first_top_contact_since_birth, message.fell_over_since_birth, message.turns,
                                message.airborne_fraction })
  {
    require(std::isnan(measure), "an invalid evaluation has measures");
  }
  require(message.velocity.empty() && message.state_hash == 0, "an invalid evaluation has velocities or a hash");
  requireWithin("divergence_step", static_cast<double>(message.divergence_step), 1.0,
                (SETTLING_TIME + settings.lifetime) / settings.timeStep() + 2.0);
  requireWithin("divergence_bond", message.divergence_bond, 0.0,
                static_cast<double>(Lattice(settings).bonds().size()) - 1.0);
  require(!(message.divergence_strain <= 100.0),
          "divergence_strain is " + toText(message.divergence_strain) + "; it must not be at most 100");

  Evaluation evaluation;
  evaluation.divergence = Divergence{ message.divergence_step, message.divergence_bond, message.divergence_strain };
  return evaluation;
}

void requireLabel(const char* field, const std::string& text)
{
  constexpr size_t longest = 255;
  const bool printable = std::all_of(text.begin(), text.end(), [](unsigned char c) { return c >= ' ' && c < 127; });
  require(printable && text.size() <= longest, std::string(field) + " must be at most 255 printable ASCII characters");
}

void requireResolvedName(const char* field, const std::string& name)
{
  requireLabel(field, name);
  std::string error;
  require(!name.empty() && name[0] == '/' && ros::names::validate(name, error),
          std::string(field) + " must be a resolved name, starting with '/'");
}

std::string individualOf(const EvaluationRequest& robot)
{
  return "robot " + individualName(robot.trial, robot.id);
}
}  // namespace

ros::Time wallStamp()
{
  const ros::WallTime now = ros::WallTime::now();
  return ros::Time(now.sec, now.nsec);
}

EvaluationSettings toMsg(const SoftBodySettings& settings)
{
  EvaluationSettings message;
  message.grid_x = settings.grid_x;
  message.grid_y = settings.grid_y;
  message.grid_z = settings.grid_z;
  message.lifetime = settings.lifetime;
  message.voxel_size = settings.voxel_size;
  message.density = settings.density;
  message.youngs_modulus = settings.youngs_modulus;
  message.poissons_ratio = settings.poissons_ratio;
  message.static_friction = settings.static_friction;
  message.dynamic_friction = settings.dynamic_friction;
  message.gravity = settings.gravity;
  message.slope = settings.slope;
  message.bond_damping = settings.bond_damping;
  message.contact_damping = settings.contact_damping;
  message.global_damping = settings.global_damping;
  message.time_step_fraction = settings.time_step_fraction;
  message.actuation_frequency = settings.actuation_frequency;
  message.actuation_amplitude = settings.actuation_amplitude;
  message.self_collision = settings.self_collision;
  message.sideways_bend_test = settings.sideways_bend_test;
  return message;
}

SoftBodySettings fromMsg(const EvaluationSettings& message)
{
  SoftBodySettings settings;
  settings.grid_x = message.grid_x;
  settings.grid_y = message.grid_y;
  settings.grid_z = message.grid_z;
  settings.lifetime = message.lifetime;
  settings.voxel_size = message.voxel_size;
  settings.density = message.density;
  settings.youngs_modulus = message.youngs_modulus;
  settings.poissons_ratio = message.poissons_ratio;
  settings.static_friction = message.static_friction;
  settings.dynamic_friction = message.dynamic_friction;
  settings.gravity = message.gravity;
  settings.slope = message.slope;
  settings.bond_damping = message.bond_damping;
  settings.contact_damping = message.contact_damping;
  settings.global_damping = message.global_damping;
  settings.time_step_fraction = message.time_step_fraction;
  settings.actuation_frequency = message.actuation_frequency;
  settings.actuation_amplitude = message.actuation_amplitude;
  settings.self_collision = message.self_collision;
  settings.sideways_bend_test = message.sideways_bend_test;
  settings.validate();
  return settings;
}

RobotGenome toMsg(const Genome& genome)
{
  RobotGenome message;
  message.size_gene_initial = genome.program.size_gene_initial;
  message.size_gene_final = genome.program.size_gene_final;
  message.phase_initial = genome.program.phase_initial;
  message.phase_final = genome.program.phase_final;
  message.mutation_rate = genome.mutation_rate;
  return message;
}

Genome fromMsg(const RobotGenome& message, const SoftBodySettings& settings)
{
  Genome genome;
  genome.program.size_gene_initial = message.size_gene_initial;
  genome.program.size_gene_final = message.size_gene_final;
  genome.program.phase_initial = message.phase_initial;
  genome.program.phase_final = message.phase_final;
  validate(genome.program, settings);
  require(message.mutation_rate.empty() || message.mutation_rate.size() == genome.program.phase_initial.size(),
          "mutation_rate must have no values or one per voxel");
  for (const double rate : message.mutation_rate)
  {
    requireWithin("mutation_rate", rate, 0.0, 1.0);
  }
  genome.mutation_rate = message.mutation_rate;
  return genome;
}

RobotEvaluation toMsg(const Evaluation& evaluation, int64_t trial, int64_t id)
{
  RobotEvaluation message;
  message.trial = trial;
  message.id = id;
  message.valid = evaluation.valid;
  message.fitness = evaluation.fitness;
  message.displacement_y_voxels = evaluation.displacement_y_voxels;
  message.displacement_xy_voxels = evaluation.displacement_xy_voxels;
  message.first_top_contact_since_birth = orNone(evaluation.first_top_contact_since_birth_s);
  message.fell_over_since_birth = orNone(evaluation.fell_over_since_birth_s);
  message.turns = evaluation.turns;
  message.airborne_fraction = evaluation.airborne_fraction;
  message.velocity = evaluation.velocity_body_lengths_per_s;
  message.state_hash = evaluation.state_hash;
  const Divergence divergence = evaluation.divergence.value_or(Divergence());
  message.divergence_step = divergence.step;
  message.divergence_bond = divergence.bond;
  message.divergence_strain = divergence.strain;
  return message;
}

Evaluation fromMsg(const RobotEvaluation& message, const SoftBodySettings& settings)
{
  return message.valid ? validEvaluation(message, settings) : divergedEvaluation(message, settings);
}

EvolvedRobot toMsg(const Individual& champion, int64_t generation, const EvolutionSettings& settings)
{
  EvolvedRobot message;
  message.trial = champion.trial;
  message.id = champion.id;
  message.parent = champion.parent;
  message.born = champion.generation;
  message.generation = generation;
  message.age = champion.age;
  message.treatment = toString(settings.treatment);
  message.morphology_window = morphologyWindow(champion.genome.program);
  message.control_window = controlWindow(champion.genome.program, settings.phaseLimit());
  message.genome = toMsg(champion.genome);
  message.evaluation = toMsg(champion.evaluation.value_or(Evaluation()), champion.trial, champion.id);
  return message;
}

EvolvedRobot toMsg(const ArchivedIndividual& archived, const EvolutionSettings& settings)
{
  EvolvedRobot message = toMsg(archived.individual, archived.individual.generation, settings);
  // The archive knows the windows also of genomes that it does not keep.
  message.morphology_window = archived.morphology_window;
  message.control_window = archived.control_window;
  return message;
}

GenerationSummary toMsg(const GenerationReport& report, const ExperimentSettings& settings)
{
  const GenerationRecord& record = report.record;
  const DevelopmentalProgram& program = report.champion.genome.program;
  GenerationSummary message;
  message.header.stamp = wallStamp();
  message.trial = record.trial;
  message.trials = settings.trials;
  message.generation = record.generation;
  message.generations = settings.generations;
  message.best_fitness = record.best_fitness;
  message.median_fitness = record.median_fitness;
  message.champion = record.champion;
  message.champion_age = report.champion.age;
  message.champion_morphology_window = morphologyWindow(program);
  message.champion_control_window = controlWindow(program, settings.evolution.phaseLimit());
  message.newcomers = static_cast<int64_t>(record.newcomers.size());
  message.evaluations = report.evaluations;
  message.invalid =
      std::count_if(record.newcomers.begin(), record.newcomers.end(),
                    [](const Individual& newcomer) { return !newcomer.evaluation || !newcomer.evaluation->valid; });
  message.total_evaluations = report.total_evaluations;
  message.evaluations_per_second = report.evaluations_per_s;
  message.remaining = report.remaining_s;
  return message;
}

EvaluateGenomes::Request toRequest(const std::vector<EvaluationRequest>& robots, const SoftBodySettings& settings,
                                   uint64_t engine_fingerprint)
{
  EvaluateGenomes::Request request;
  request.engine_fingerprint = engine_fingerprint;
  request.settings = toMsg(settings);
  for (const EvaluationRequest& robot : robots)
  {
    request.trial.push_back(robot.trial);
    request.id.push_back(robot.id);
    request.genomes.push_back(toMsg(Genome{ robot.program, {} }));
  }
  return request;
}

std::optional<std::string> quarantineOf(const EvaluateGenomes::Request& request)
{
  if (request.quarantine.empty())
  {
    return std::nullopt;
  }
  requireLabel("quarantine", request.quarantine);
  require(request.genomes.empty(), "a request with robots for a simulator that is to be quarantined");
  return request.quarantine;
}

std::vector<EvaluationRequest> robotsOf(const EvaluateGenomes::Request& request, const SoftBodySettings& settings)
{
  const size_t count = request.genomes.size();
  require(count <= EvaluateGenomes::Request::MAX_GENOMES,
          toText(static_cast<int64_t>(count)) + " genomes in one request; at most " +
              toText(EvaluateGenomes::Request::MAX_GENOMES) + " are allowed");
  require(request.trial.size() == count && request.id.size() == count, "trial, id and genomes must have the same size");
  std::vector<EvaluationRequest> robots(count);
  for (size_t i = 0; i < count; ++i)
  {
    robots[i].trial = request.trial[i];
    robots[i].id = request.id[i];
    try
    {
      robots[i].program = fromMsg(request.genomes[i], settings).program;
    }
    catch (const InvalidInput& e)
    {
      throw InvalidInput(individualOf(robots[i]) + ": " + e.what());
    }
  }
  return robots;
}

std::vector<Evaluation> evaluationsOf(const EvaluateGenomes::Response& response,
                                      const std::vector<EvaluationRequest>& robots, const SoftBodySettings& settings)
{
  require(response.error.empty(), "the request was refused: " + response.error.substr(0, 255));
  require(response.evaluations.size() == robots.size(), toText(static_cast<int64_t>(response.evaluations.size())) +
                                                            " evaluations for " +
                                                            toText(static_cast<int64_t>(robots.size())) + " robots");
  std::vector<Evaluation> evaluations;
  for (size_t i = 0; i < robots.size(); ++i)
  {
    const RobotEvaluation& message = response.evaluations[i];
    require(message.trial == robots[i].trial && message.id == robots[i].id,
            "an evaluation of " + individualName(message.trial, message.id) + " where that of " +
                individualName(robots[i].trial, robots[i].id) + " was expected");
    try
    {
      evaluations.push_back(fromMsg(message, settings));
    }
    catch (const InvalidInput& e)
    {
      throw InvalidInput(individualOf(robots[i]) + ": " + e.what());
    }
  }
  return evaluations;
}

VelocityTelemetry telemetryOf(const EvaluationRequest& robot, const Evaluation& evaluation,
                              const SoftBodySettings& settings, const std::string& simulator)
{
  VelocityTelemetry telemetry;
  telemetry.header.stamp = wallStamp();
  telemetry.header.frame_id = "world";
  telemetry.trial = robot.trial;
  telemetry.id = robot.id;
  telemetry.simulator = simulator;
  telemetry.valid = evaluation.valid;
  telemetry.velocity = evaluation.velocity_body_lengths_per_s;
  for (size_t window = 1; window <= telemetry.velocity.size(); ++window)
  {
    telemetry.window_end.push_back(std::min(window * WINDOW, settings.lifetime));
  }
  telemetry.mean_velocity = evaluation.valid ? evaluation.fitness / settings.lifetime : Evaluation::NONE;
  return telemetry;
}

void validate(const SimulatorAnnouncement& announcement)
{
  requireResolvedName("name", announcement.name);
  requireResolvedName("service", announcement.service);
  requireLabel("host", announcement.host);
  requireLabel("version", announcement.version);
  requireLabel("instruction_set", announcement.instruction_set);
  requireLabel("processor", announcement.processor);
  requireWithin("lanes", announcement.lanes, 1, EvaluateGenomes::Request::MAX_GENOMES);
  requireWithin("period", announcement.period, 0.01, 60.0);
  require(announcement.evaluations >= 0, "evaluations must not be negative");
}
}  // namespace devo_evo
