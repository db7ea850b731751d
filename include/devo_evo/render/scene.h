#pragma once

#include "devo_evo/render/appearance.h"
#include "devo_evo/render/shown_robot.h"

#include <Eigen/Geometry>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace devo_evo
{
/// Where a robot's centre of mass has been since birth, and how fast it is, in one frame.
class MotionTrace
{
public:
  /// Time over which velocity is averaged: one cycle of actuation at the paper's 4 Hz [s].
  static constexpr double VELOCITY_WINDOW = 0.25;

  /// Time between two points of path() [s].
  static constexpr double PATH_SPACING = 0.05;

  /// @param time_since_birth not before the last one given [s]. @param center_of_mass [m].
  void add(double time_since_birth, const Eigen::Vector3d& center_of_mass);

  /// A line from birth to the present place [m].
  std::vector<Eigen::Vector3d> path() const;

  /// Mean velocity over the last VELOCITY_WINDOW, or since birth if that is less [m/s]; 0 at birth.
  Eigen::Vector3d velocity() const;

private:
  using Place = std::pair<double, Eigen::Vector3d>;

  std::vector<Eigen::Vector3d> path_;
  double next_path_point_ = 0.0;
  std::vector<Place> recent_;  ///< the last one that is older than the window, and all since
};

/// A floor with lines one body length apart, that a distance can be read from. In the floor's frame, at z = 0 [m].
struct FloorPlan
{
  using Line = std::array<Eigen::Vector3d, 2>;

  Eigen::AlignedBox2d area;
  double body_length = 0.0;
  std::vector<Line> lines;         ///< one body length from each other and from the birthplace, along x and along y
  std::vector<Line> marked_lines;  ///< across the way, at the birthplace and every five body lengths from it
  std::vector<std::pair<Eigen::Vector3d, std::string>> labels;  ///< on them, beside the way: body lengths walked there
};

/// A floor for a life: as far as the robot comes, and some more.
FloorPlan floorPlan(const LifeSurvey& life, const Surroundings& surroundings);
}  // namespace devo_evo
