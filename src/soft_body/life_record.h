#pragma once

#include "devo_evo/soft_body/evaluation.h"
#include "devo_evo/soft_body/settings.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace devo_evo
{
/// Gathers the measures of one robot's life (docs/physics.md 6) while it is simulated.
class LifeRecord
{
public:
  /// How many steps may pass between two calls of recordOrientation().
  static constexpr int64_t ORIENTATION_INTERVAL = 16;

  /// After the first step after birth. @param time of the simulator [s].
  void beginLife(double time, const Eigen::Vector3d& center_of_mass, const Eigen::Quaterniond& orientation);

  /// After every step since birth, the first included: how many voxels of the top layer, and others, touch the floor.
  void recordContacts(double time, int top_contacts, int other_contacts);

  /// Accumulates turns. Between two calls the body must turn by less than 90 degrees.
  void recordOrientation(const Eigen::Quaterniond& orientation);

  /// Whether a window of velocity telemetry ends at this time.
  bool windowEnds(double time) const;

  /// Ends a window of velocity telemetry here.
  void endWindow(double time, const Eigen::Vector3d& center_of_mass);

  /// Whether the present window has begun before this time.
  bool windowOpen(double time) const { return time > window_start_; }

  void setDivergence(const Divergence& divergence) { divergence_ = divergence; }
  bool diverged() const { return divergence_.has_value(); }

  /// The measures so far. @param center_of_mass where the robot is now.
  Evaluation evaluation(const SoftBodySettings& settings, const Eigen::Vector3d& center_of_mass,
                        uint64_t state_hash) const;

private:
  Eigen::Vector3d birth_center_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d window_center_ = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation_ = Eigen::Quaterniond::Identity();
  double window_start_ = 0.0;
  std::vector<double> window_velocities_;  ///< [m/s]
  double turned_ = 0.0;                    ///< [rad]
  int64_t steps_ = 0;
  int64_t airborne_steps_ = 0;
  std::optional<double> first_top_contact_;
  std::optional<double> fell_over_;
  std::optional<Divergence> divergence_;
};
}  // namespace devo_evo
