#pragma once

#include "devo_evo/picture/robot_scene.h"
#include "devo_evo/picture/scene.h"
#include "devo_evo/render/appearance.h"
#include "devo_evo/render/scene.h"
#include "devo_evo/render/shown_robot.h"

#include <memory>
#include <optional>
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
  double travelled = 0.0;          ///< along the floor towards +y since birth [body lengths]
  std::optional<double> to_light;  ///< distance from the light that robots seek [m]; none: they seek none
  double slope = 0.0;              ///< by which the floor descends towards it [rad]
  double velocity = 0.0;           ///< along +y, mean over the last quarter of a second [body lengths/s]
  std::vector<double> velocities;  ///< along +y, means of consecutive windows of 0.5 s so far [body lengths/s]
};

/// A treatment as people write it: "Evo", "Evo-Devo", "Evo-Devo, control alone". @param name as toString(Treatment)
/// gives.
std::string treatmentTitle(const std::string& name);

/// What stands beside a robot under its name: treatment, trial, generation and age, if it is from an archive.
std::string descriptionOf(const ShownRobot& robot);

/// Where the camera stands, seen from the robot.
struct Viewpoint
{
  double azimuth = 0.35;        ///< [rad]
  double elevation = 0.36;      ///< [rad]
  double distance = 9.0;        ///< [body sizes]
  double field_of_view = 0.42;  ///< of the picture's height [rad]
};

/// From the side; where there is a light, low and from behind, so that it is in view.
Viewpoint viewpointFor(const Surroundings& surroundings);

/// How a life is shown.
struct ViewOptions
{
  Colouring colouring = Colouring::RESTING_LENGTH;
  double interval = 0.04;              ///< between pictures, in the robot's time [s]
  std::optional<Viewpoint> viewpoint;  ///< none: viewpointFor()
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

  /// Of all robots of this body.
  const Appearance& appearance() const { return *appearance_; }

  /// Centre of mass at birth, in the floor's frame [m]: distances count from there, and floor lines cross there.
  const Eigen::Vector3d& birthplace() const { return birthplace_; }

  /// Centre of mass now, in the floor's frame [m].
  Eigen::Vector3d place() const { return surroundings_.onFloor(frame_.center_of_mass); }

  /// Measures over the life so far; those of the individual at the end.
  Evaluation evaluation() const { return playback_.evaluation(); }

private:
  void take();

  const ShownRobot robot_;
  const ViewOptions options_;
  const std::shared_ptr<const Appearance> appearance_;
  const Surroundings surroundings_;
  const double lifetime_;
  LifePlayback playback_;
  RobotFrame frame_;
  Camera camera_;
  FollowingPoint following_;
  Eigen::Vector3d birthplace_;
  double next_time_ = 0.0;
  MotionTrace trace_;  ///< in the floor's frame
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
