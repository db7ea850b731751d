#include "ros/conversions.h"

#include "devo_evo/experiment/parameters.h"
#include "devo_evo/soft_body/text.h"
#include "soft_body/check_ranges.h"

#include <ros/names.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace devo_evo
{
namespace
{
void require(bool condition, const std::string& what)
{
  if (!condition)
  {
    throw InvalidInput(what);
  }
}

std::vector<NamedNumber> toMsg(const std::vector<Measure>& measures, const Evaluation& evaluation)
{
  std::vector<NamedNumber> numbers;
  for (const Measure& measure : measures)
  {
    NamedNumber number;
    number.name = measure.name;
    number.value = measure.get(evaluation);
    numbers.push_back(number);
  }
  return numbers;
}

/// Sets what was measured. @param field of the message, for errors.
void read(const std::vector<NamedNumber>& numbers, const std::vector<Measure>& measures, const char* field,
          Evaluation& evaluation)
{
  require(numbers.size() == measures.size(),
          std::string(field) + " has " + toText(static_cast<int64_t>(numbers.size())) +
              " numbers where there must be " + toText(static_cast<int64_t>(measures.size())));
  for (size_t i = 0; i < measures.size(); ++i)
  {
    const Measure& measure = measures[i];
    const double value = numbers[i].value;
    require(numbers[i].name == measure.name,
            std::string(field) + " has \"" + numbers[i].name.substr(0, 80) + "\" where there must be " + measure.name);
    require(!measure.whole || (value >= measure.minimum && value <= measure.maximum && value == std::floor(value)),
            measure.name + " is " + toText(value) + "; it must be a whole number within " + toText(measure.minimum) +
                " to " + toText(measure.maximum));
    measure.set(evaluation, value);
  }
}

/// The values of an array that a genome must have once.
const std::vector<double>& arrayNamed(const std::string& name, const RobotGenome& message)
{
  const std::vector<double>* values = nullptr;
  for (const NamedArray& array : message.arrays)
  {
    if (array.name == name)
    {
      require(values == nullptr, "the genome has " + name + " twice");
      values = &array.values;
    }
  }
  require(values != nullptr, "the genome has no " + name);
  return *values;
}

NamedArray named(const std::string& name, const std::vector<double>& values)
{
  NamedArray array;
  array.name = name;
  array.values = values;
  return array;
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

EvaluationSettings toMsg(const BodySettings& settings)
{
  Parameters parameters;
  parameters.experiment.body = settings;
  EvaluationSettings message;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (describesBody(spec, settings.kind))
    {
      message.names.push_back(spec.name);
      message.values.push_back(spec.get(parameters));
    }
  }
  return message;
}

BodySettings fromMsg(const EvaluationSettings& message)
{
  require(message.names.size() == message.values.size(), "names and values of the settings must have the same size");
  std::map<std::string, std::string> given;
  for (size_t i = 0; i < message.names.size(); ++i)
  {
    require(given.emplace(message.names[i], message.values[i]).second,
            "the settings have " + message.names[i].substr(0, 80) + " twice");
  }
  require(given.count("body") != 0, "the settings have no body");
  const BodyKind kind = parseBodyKind(given.at("body"));
  Parameters parameters;
  size_t taken = 0;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (describesBody(spec, kind))
    {
      require(given.count(spec.name) != 0, "the settings have no " + spec.name);
      spec.set(parameters, given.at(spec.name));
      ++taken;
    }
  }
  require(taken == given.size(), "the settings have parameters that a " + toString(kind) + " body has not");
  parameters.experiment.body.validate();
  return parameters.experiment.body;
}

RobotGenome toMsg(const Genome& genome, const Body& body)
{
  const GenomeLayout layout = body.layout(EvolutionSettings());
  RobotGenome message;
  message.body = body.kind();
  message.arrays = { named(layout.morphology.initialName(), genome.program.morphology_initial),
                     named(layout.morphology.finalName(), genome.program.morphology_final),
                     named(layout.control.initialName(), genome.program.control_initial),
                     named(layout.control.finalName(), genome.program.control_final) };
  message.mutation_rate = genome.mutation_rate;
  return message;
}

Genome fromMsg(const RobotGenome& message, const Body& body)
{
  require(message.body == body.kind(), "the genome is one of a \"" + message.body.substr(0, 80) +
                                           "\" body where one of a " + body.kind() + " body is needed");
  const GenomeLayout layout = body.layout(EvolutionSettings());
  Genome genome;
  genome.program.morphology_initial = arrayNamed(layout.morphology.initialName(), message);
  genome.program.morphology_final = arrayNamed(layout.morphology.finalName(), message);
  genome.program.control_initial = arrayNamed(layout.control.initialName(), message);
  genome.program.control_final = arrayNamed(layout.control.finalName(), message);
  require(message.arrays.size() == 4, "the genome has arrays that a " + body.kind() + " body has not");
  body.validate(genome.program);
  require(message.mutation_rate.empty() || message.mutation_rate.size() == layout.morphology.size,
          "mutation_rate must have no values or one per " + layout.morphology.place);
  for (const double rate : message.mutation_rate)
  {
    requireWithin("mutation_rate", rate, 0.0, 1.0);
  }
  genome.mutation_rate = message.mutation_rate;
  return genome;
}

RobotEvaluation toMsg(const Evaluation& evaluation, int64_t trial, int64_t id, const Body& body)
{
  RobotEvaluation message;
  message.trial = trial;
  message.id = id;
  message.valid = evaluation.valid;
  message.fitness = evaluation.fitness;
  message.velocity = evaluation.velocity_body_lengths_per_s;
  message.state_hash = evaluation.state_hash;
  if (evaluation.valid)
  {
    message.measures = toMsg(body.measures(), evaluation);
  }
  else
  {
    message.failure = toMsg(body.failureMeasures(), evaluation);
  }
  return message;
}

Evaluation fromMsg(const RobotEvaluation& message, const Body& body)
{
  Evaluation evaluation;
  evaluation.valid = message.valid;
  evaluation.fitness = message.fitness;
  evaluation.velocity_body_lengths_per_s = message.velocity;
  evaluation.state_hash = message.state_hash;
  read(message.measures, message.valid ? body.measures() : std::vector<Measure>(), "measures", evaluation);
  read(message.failure, message.valid ? std::vector<Measure>() : body.failureMeasures(), "failure", evaluation);
  body.validate(evaluation);
  return evaluation;
}

EvolvedRobot toMsg(const Individual& champion, int64_t generation, const ExperimentSettings& settings)
{
  const std::shared_ptr<const Body> body = makeBody(settings.body);
  const GenomeLayout layout = body->layout(settings.evolution);
  EvolvedRobot message;
  message.trial = champion.trial;
  message.id = champion.id;
  message.parent = champion.parent;
  message.born = champion.generation;
  message.generation = generation;
  message.age = champion.age;
  message.treatment = toString(settings.evolution.treatment);
  message.morphology_window = morphologyWindow(champion.genome.program, layout);
  message.control_window = controlWindow(champion.genome.program, layout);
  message.genome = toMsg(champion.genome, *body);
  message.evaluation = toMsg(champion.evaluation.value_or(Evaluation()), champion.trial, champion.id, *body);
  return message;
}

EvolvedRobot toMsg(const ArchivedIndividual& archived, const ExperimentSettings& settings)
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
  const std::shared_ptr<const Body> body = makeBody(settings.body);
  const GenomeLayout layout = body->layout(settings.evolution);
  GenerationSummary message;
  message.header.stamp = wallStamp();
  message.trial = record.trial;
  message.trials = settings.trials;
  message.generation = record.generation;
  message.generations = settings.generations;
  message.best_fitness = record.best_fitness;
  message.median_fitness = record.median_fitness;
  message.fitness_unit = body->fitnessUnit();
  message.champion = record.champion;
  message.champion_age = report.champion.age;
  message.champion_morphology_window = morphologyWindow(program, layout);
  message.champion_control_window = controlWindow(program, layout);
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

EvaluateGenomes::Request toRequest(const std::vector<EvaluationRequest>& robots, const BodySettings& settings,
                                   const Body& body, uint64_t engine_fingerprint)
{
  EvaluateGenomes::Request request;
  request.engine_fingerprint = engine_fingerprint;
  request.settings = toMsg(settings);
  for (const EvaluationRequest& robot : robots)
  {
    request.trial.push_back(robot.trial);
    request.id.push_back(robot.id);
    request.genomes.push_back(toMsg(Genome{ robot.program, {} }, body));
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

std::vector<EvaluationRequest> robotsOf(const EvaluateGenomes::Request& request, const Body& body)
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
      robots[i].program = fromMsg(request.genomes[i], body).program;
    }
    catch (const InvalidInput& e)
    {
      throw InvalidInput(individualOf(robots[i]) + ": " + e.what());
    }
  }
  return robots;
}

std::vector<Evaluation> evaluationsOf(const EvaluateGenomes::Response& response,
                                      const std::vector<EvaluationRequest>& robots, const Body& body)
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
      evaluations.push_back(fromMsg(message, body));
      require(!message.valid || !message.velocity.empty() || body.lifetime() < Evaluation::VELOCITY_WINDOW,
              "the velocities are missing");
    }
    catch (const InvalidInput& e)
    {
      throw InvalidInput(individualOf(robots[i]) + ": " + e.what());
    }
  }
  return evaluations;
}

VelocityTelemetry telemetryOf(const EvaluationRequest& robot, const Evaluation& evaluation, const Body& body,
                              const std::string& simulator)
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
    telemetry.window_end.push_back(
        std::min(static_cast<double>(window) * Evaluation::VELOCITY_WINDOW, body.lifetime()));
  }
  telemetry.mean_velocity = body.meanVelocity(evaluation);
  return telemetry;
}

uint64_t fingerprintFor(const std::string& kind, const SimulatorAnnouncement& announcement)
{
  for (const BodyEngine& engine : announcement.engines)
  {
    if (engine.body == kind)
    {
      return engine.fingerprint;
    }
  }
  return 0;
}

void validate(const SimulatorAnnouncement& announcement)
{
  requireResolvedName("name", announcement.name);
  requireResolvedName("service", announcement.service);
  requireLabel("host", announcement.host);
  requireLabel("version", announcement.version);
  requireLabel("instruction_set", announcement.instruction_set);
  requireLabel("processor", announcement.processor);
  require(announcement.engines.size() <= 16, "there must be at most 16 engines");
  for (const BodyEngine& engine : announcement.engines)
  {
    requireLabel("engines", engine.body);
  }
  requireWithin<double>("lanes", announcement.lanes, 1, EvaluateGenomes::Request::MAX_GENOMES);
  requireWithin("period", announcement.period, 0.01, 60.0);
  require(announcement.evaluations >= 0, "evaluations must not be negative");
}
}  // namespace devo_evo
