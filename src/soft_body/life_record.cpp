#include "life_record.h"

#include "kernel-inl.h"

#include <cmath>

namespace devo_evo
{
namespace
{
constexpr double TWO_PI = 6.283185307179586;

// How far the body rolls forwards, towards +y, from one orientation to the next: about -x [rad]. Less than 90 degrees.
double forwardRotation(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to)
{
  // w and x of the turn, to * conjugate(from)
  const double w = to.w() * from.w() + to.x() * from.x() + to.y() * from.y() + to.z() * from.z();
  const double x = to.x() * from.w() - to.w() * from.x() + to.z() * from.y() - to.y() * from.z();
  const double sign = w < 0.0 ? -1.0 : 1.0;
  return -sign * x * exactRotationFactor(1.0 - sign * w);
}
}  // namespace

void LifeRecord::beginLife(double time, const Eigen::Vector3d& center_of_mass, const Eigen::Quaterniond& orientation)
{
  birth_center_ = center_of_mass;
  window_center_ = center_of_mass;
  window_start_ = time;
  orientation_ = orientation;
}

void LifeRecord::recordContacts(double time, int top_contacts, int other_contacts)
{
  ++steps_;
  if (top_contacts == 0 && other_contacts == 0)
  {
    ++airborne_steps_;
  }
  if (top_contacts > 0 && !first_top_contact_)
  {
    first_top_contact_ = time - SETTLING_TIME;
  }
  if (top_contacts > other_contacts && !fell_over_)
  {
    fell_over_ = time - SETTLING_TIME;
  }
}

void LifeRecord::recordOrientation(const Eigen::Quaterniond& orientation)
{
  turned_ += forwardRotation(orientation_, orientation);
  orientation_ = orientation;
}

bool LifeRecord::windowEnds(double time) const
{
  return time > SETTLING_TIME + Evaluation::VELOCITY_WINDOW * static_cast<double>(window_velocities_.size() + 1);
}

void LifeRecord::endWindow(double time, const Eigen::Vector3d& center_of_mass)
{
  window_velocities_.push_back((center_of_mass.y() - window_center_.y()) / (time - window_start_));
  window_center_ = center_of_mass;
  window_start_ = time;
}

Evaluation LifeRecord::evaluation(const SoftBodySettings& settings, const Eigen::Vector3d& center_of_mass,
                                  uint64_t state_hash) const
{
  Evaluation evaluation;
  if (divergence_)
  {
    evaluation.divergence = divergence_;
    return evaluation;
  }
  const bool born = steps_ > 0;
  const Eigen::Vector3d displacement = (center_of_mass - (born ? birth_center_ : center_of_mass)) / settings.voxel_size;
  evaluation.valid = true;
  evaluation.displacement_y_voxels = displacement.y();
  evaluation.displacement_xy_voxels =
      std::sqrt(displacement.x() * displacement.x() + displacement.y() * displacement.y());
  evaluation.fitness = displacement.y() / settings.grid_y;
  evaluation.first_top_contact_since_birth_s = first_top_contact_;
  evaluation.fell_over_since_birth_s = fell_over_;
  evaluation.turns = turned_ / TWO_PI;
  evaluation.airborne_fraction = steps_ > 0 ? static_cast<double>(airborne_steps_) / static_cast<double>(steps_) : 0.0;
  for (const double velocity : window_velocities_)
  {
    evaluation.velocity_body_lengths_per_s.push_back(velocity / (settings.voxel_size * settings.grid_y));
  }
  evaluation.state_hash = state_hash;
  return evaluation;
}
}  // namespace devo_evo
