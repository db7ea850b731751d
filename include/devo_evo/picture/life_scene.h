#pragma once

#include "devo_evo/picture/robot_scene.h"
#include "devo_evo/picture/scene.h"
#include "devo_evo/render/colouring.h"
#include "devo_evo/render/life_playback.h"
#include "devo_evo/render/scene.h"
#include "devo_evo/render/shown_robot.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// What the instruments beside a picture show.
struct Readings
{
  std::string name, description;
  double time_since_birth = 0.0;   ///< [s]
  double lifetime = 0.0;           ///< [s]
  double travelled = 0.0;          ///< along +y since birth [body lengths]
  double velocity = 0.0;           ///< along +y, mean over the last quarter of a second [body lengths/s]
  std::vector<double> velocities;  ///< along +y, means of consecutive windows of 0.5 s so far [body lengths/s]
};

/// A treatment as people write it: "Evo", "Evo-Devo", "Evo-Devo, control alone". @param name as toString(Treatment)
/// gives.
std::string treatmentTitle(const std::string& name);

/// What stands beside a robot under its name: treatment, trial, generation and age, if it is from an archive.
std::string descriptionOf(const ShownRobot& robot);

/// How a life is shown.
struct ViewOptions
{
  Colouring colouring = Colouring::RESTING_LENGTH;
  double interval = 0.04;   ///< between pictures, in the robot's time [s]
  double azimuth = 0.35;    ///< of the camera [rad]
  double elevation = 0.36;  ///< of the camera [rad]
  double distance = 9.0;    ///< of the camera [body sizes]
};

/// One life, picture by picture, with a camera that follows the robot. Simulates as it goes: memory does not grow with
/// the lifetime but for a few numbers per picture.
class LifeScene
{
public:
  /// At birth. @throw InvalidInput if program or settings are invalid; PictureError if the robot's simulation diverges
  /// before birth.
  LifeScene(const ShownRobot& robot, const ViewOptions& options);

  /// Goes on by an interval, or to the end of life. @return false if it was at the end already, or if the simulation
  /// diverged: the last picture stays then.
  bool next();

  const ShownRobot& robot() const { return robot_; }
  const RobotFrame& frame() const { return frame_; }
  const Camera& camera() const { return camera_; }
  Scene scene() const;
  Readings readings() const;

  /// Centre of mass at birth [m]: distances count from there, and floor lines cross there.
  const Eigen::Vector3d& birthplace() const { return birthplace_; }

  /// Measures over the life so far; those of the individual at the end.
  Evaluation evaluation() const { return playback_.evaluation(); }

private:
  void take();

  const ShownRobot robot_;
  const ViewOptions options_;
  const RobotMesh mesh_;
  LifePlayback playback_;
  RobotFrame frame_;
  Camera camera_;
  FollowingPoint following_;
  Eigen::Vector3d birthplace_;
  double next_time_ = 0.0;
  MotionTrace trace_;
};

/// Marks of the distance travelled, to be written on the floor.
struct FloorMark
{
  Eigen::Vector3d place;  ///< [m]
  int body_lengths;
};

/// Those within a distance of the camera's target, at the robot's side that faces the camera.
std::vector<FloorMark> floorMarks(const Eigen::Vector3d& birthplace, const Camera& camera, double body_length,
                                  double body_size);
}  // namespace devo_evo
