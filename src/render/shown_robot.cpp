#include "devo_evo/render/shown_robot.h"

#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/experiment/report_text.h"
#include "devo_evo/render/appearance.h"
#include "devo_evo/soft_body/text.h"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace devo_evo
{
namespace
{
constexpr double SURVEY_SPACING = 0.05;  // between looks at where the robot is [s]

std::optional<int64_t> wholeNumber(const std::string& text)
{
  int64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  const bool whole = result.ec == std::errc() && result.ptr == end && number >= 0;
  return whole ? std::optional<int64_t>(number) : std::nullopt;
}

ShownRobot toShow(const ArchivedIndividual& archived, const ExperimentSettings& settings)
{
  const Individual& individual = archived.individual;
  ShownRobot robot;
  robot.name = individualName(individual.trial, individual.id);
  if (!archived.has_genome)
  {
    throw InvalidInput("the genome of individual " + robot.name + " was not kept and cannot be had again");
  }
  robot.body = settings.body;
  robot.program = individual.genome.program;
  robot.descent = Descent{ individual.trial,
                           individual.id,
                           individual.generation,
                           individual.age,
                           toString(settings.evolution.treatment),
                           archived.morphology_window,
                           archived.control_window };
  robot.recorded = individual.evaluation;
  return robot;
}

std::ifstream openFile(const std::string& path)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
  {
    throw InvalidInput(path + ": it is a folder; a file of JSON lines is needed");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw InvalidInput(path + ": it cannot be read: " + std::strerror(errno));
  }
  return file;
}

std::string textOf(const RobotId& id)
{
  const auto* const number = std::get_if<int64_t>(&id);
  return number != nullptr ? toText(*number) : std::get<std::string>(id);
}
}  // namespace

RobotChoice parseRobotChoice(const std::string& text)
{
  RobotChoice choice;
  if (text == "best")
  {
    return choice;
  }
  const size_t slash = text.find('/');
  choice.trial = wholeNumber(text.substr(0, slash));
  choice.id = slash == std::string::npos ? std::nullopt : wholeNumber(text.substr(slash + 1));
  if (!choice.trial || *choice.trial < 1 || (slash != std::string::npos && !choice.id))
  {
    throw InvalidInput("individual is \"" + text +
                       "\"; it must be best, a trial like 3, or a trial and an id like 3/1042");
  }
  return choice;
}

std::string toString(const RobotChoice& choice)
{
  if (!choice.trial)
  {
    return "best";
  }
  return choice.id ? individualName(*choice.trial, *choice.id) : toText(*choice.trial);
}

std::optional<ShownRobot> findRobot(const Archive& archive, const RobotChoice& choice)
{
  if (choice.id)
  {
    return toShow(archive.readIndividual(*choice.trial, *choice.id), archive.settings());
  }
  if (choice.trial)
  {
    const std::vector<int64_t> trials = archive.trials();
    if (std::find(trials.begin(), trials.end(), *choice.trial) == trials.end())
    {
      return std::nullopt;
    }
    return toShow(archive.readIndividual(*choice.trial, archive.championOf(*choice.trial)), archive.settings());
  }
  const std::optional<ArchivedIndividual> best = bestChampion(archive);
  return best ? std::optional<ShownRobot>(toShow(*best, archive.settings())) : std::nullopt;
}

ShownRobot readRobotFile(const std::string& path, const std::string& id, const BodySettings& body)
{
  std::ifstream file = openFile(path);
  const std::shared_ptr<const Body> kind = makeBody(body);
  RobotReader reader(file, path, *kind);
  while (const std::optional<RobotRecord> record = reader.next())
  {
    if (id.empty() || textOf(record->id) == id)
    {
      ShownRobot robot;
      robot.name = textOf(record->id);
      robot.body = body;
      robot.program = record->genome.program;
      return robot;
    }
  }
  throw InvalidInput(path + ": there is no robot" + (id.empty() ? " in it" : " called " + id));
}

LifeSurvey surveyLife(const ShownRobot& robot, const std::atomic<bool>* stop)
{
  LifeSurvey survey;
  const Surroundings surroundings = makeAppearance(robot.body)->surroundings();
  LifePlayback playback(robot.body, robot.program);
  bool first = true;
  for (int64_t look = 0; playback.advanceTo(static_cast<double>(look) * SURVEY_SPACING, stop); ++look)
  {
    const Eigen::Vector3d place = surroundings.onFloor(playback.centerOfMass());
    survey.birthplace = first ? place : survey.birthplace;
    survey.extent.extend(Eigen::Vector2d(place.head<2>()));
    first = false;
  }
  survey.evaluation = playback.evaluation();
  return survey;
}

std::string disagreement(const ShownRobot& robot, const Evaluation& evaluation)
{
  if (!robot.recorded)
  {
    return "";
  }
  const Evaluation& recorded = *robot.recorded;
  const bool same = recorded.valid == evaluation.valid && recorded.state_hash == evaluation.state_hash &&
                    (!recorded.valid || recorded.fitness == evaluation.fitness);
  if (same)
  {
    return "";
  }
  const auto described = [](const Evaluation& life)
  {
    return life.valid ? "fitness " + toText(life.fitness) + " and state hash " + hashToString(life.state_hash)
                      : std::string("a simulation that diverged");
  };
  return "individual " + robot.name + " is not what was recorded: simulated again it has " + described(evaluation) +
         ", recorded is " + described(recorded);
}

std::string captionText(const ShownRobot& robot, const Evaluation& evaluation, double time_since_birth_s)
{
  const std::shared_ptr<const Body> body = makeBody(robot.body);
  std::string first = robot.name;
  if (robot.descent)
  {
    first += ", " + robot.descent->treatment + ", generation " + toText(robot.descent->generation) + ", age " +
             toText(robot.descent->age);
  }
  const std::string fitness =
      evaluation.valid ? "fitness " + body->fitnessText(evaluation.fitness) + " " + body->fitnessUnit() : "diverges";
  return first + "\n" + fitness + ", " + fixedText(time_since_birth_s, 2) + " s";
}
}  // namespace devo_evo
