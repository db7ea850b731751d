#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/evaluation.h"
#include "devo_evo/bodies/bodies.h"

#include <Eigen/Geometry>

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

namespace devo_evo
{
/// Which robot of an experiment to show.
struct RobotChoice
{
  std::optional<int64_t> trial;  ///< none: the best of all trials
  std::optional<int64_t> id;     ///< within the trial; none: its champion. Never given without trial

  /// Whether the answer can change while evolution goes on.
  bool follows() const { return !id; }
};

/// @param text "best", a trial like "3", or an individual like "3/1042". @throw InvalidInput
RobotChoice parseRobotChoice(const std::string& text);
std::string toString(const RobotChoice& choice);

/// Where an individual stands in its evolution.
struct Descent
{
  int64_t trial = 0;
  int64_t id = 0;
  int64_t generation = 0;          ///< in which it was born
  int64_t age = 0;                 ///< at birth: generations since its oldest ancestor was made at random
  std::string treatment;           ///< "evo" or "evo_devo"
  double morphology_window = 0.0;  ///< W_L
  double control_window = 0.0;     ///< W_Phi
};

/// A robot with all that it takes to simulate it again, and what is known about it.
struct ShownRobot
{
  std::string name;  ///< "3/1042", or as the file calls it
  BodySettings body;
  DevelopmentalProgram program;
  std::optional<Descent> descent;  ///< none if it comes from a file
  std::optional<Evaluation>
      recorded;  ///< what the archive says that it did, without velocity windows; none from a file
};

/// A robot of an archive, which may be written to meanwhile.
/// @return none if the choice follows a champion and there is no valid one yet.
/// @throw InvalidInput if there is no such individual, or if its genome was not kept.
std::optional<ShownRobot> findRobot(const Archive& archive, const RobotChoice& choice);

/// A robot of a file of JSON lines (docs/tool.md, "Genomes").
/// @param id of the robot in the file; empty: the first one.
/// @throw InvalidInput if the file cannot be read, has no such robot, or is malformed up to there.
ShownRobot readRobotFile(const std::string& path, const std::string& id, const BodySettings& body);

/// What one simulation of the whole life gives.
struct LifeSurvey
{
  Evaluation evaluation;
  Eigen::Vector3d birthplace = Eigen::Vector3d::Zero();  ///< centre of mass at birth, in the floor's frame [m]
  Eigen::AlignedBox2d extent;  ///< of the way of the centre of mass on the floor [m]; empty if it diverged at once
};

/// @throw EvaluationAbandoned once `stop` is true. InvalidInput if program or settings are invalid.
LifeSurvey surveyLife(const ShownRobot& robot, const std::atomic<bool>* stop = nullptr);

/// Whether this is, to the last bit, what was recorded of the robot.
/// @return empty if so, or if nothing was recorded; else a sentence that says what differs.
std::string disagreement(const ShownRobot& robot, const Evaluation& evaluation);

/// What stands beside the robot: name, treatment, generation, age, fitness and time in its life, on two lines.
std::string captionText(const ShownRobot& robot, const Evaluation& evaluation, double time_since_birth_s);
}  // namespace devo_evo
