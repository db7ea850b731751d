#include "devo_evo/soft_body/settings.h"

#include "devo_evo/soft_body/text.h"
#include "soft_body/check_ranges.h"

#include <cmath>

namespace devo_evo
{
const std::vector<BoundedField<SoftBodySettings, int>>& softBodyIntegers()
{
  static const std::vector<BoundedField<SoftBodySettings, int>> fields = {
    { "grid_x", &SoftBodySettings::grid_x, 1, 64 },
    { "grid_y", &SoftBodySettings::grid_y, 1, 64 },
    { "grid_z", &SoftBodySettings::grid_z, 1, 64 },
  };
  return fields;
}

const std::vector<BoundedField<SoftBodySettings, double>>& softBodyReals()
{
  static const std::vector<BoundedField<SoftBodySettings, double>> fields = {
    { "lifetime", &SoftBodySettings::lifetime, 0.001, 1000.0 },
    { "voxel_size", &SoftBodySettings::voxel_size, 1e-4, 10.0 },
    { "density", &SoftBodySettings::density, 1.0, 1e9 },
    { "youngs_modulus", &SoftBodySettings::youngs_modulus, 1.0, 1e12 },
    { "poissons_ratio", &SoftBodySettings::poissons_ratio, 0.0, 0.499 },
    { "static_friction", &SoftBodySettings::static_friction, 0.0, 100.0 },
    { "dynamic_friction", &SoftBodySettings::dynamic_friction, 0.0, 100.0 },
    { "gravity", &SoftBodySettings::gravity, 0.0, 1000.0 },
    { "slope", &SoftBodySettings::slope, -10.0, 10.0 },
    { "bond_damping", &SoftBodySettings::bond_damping, 0.0, 10.0 },
    { "contact_damping", &SoftBodySettings::contact_damping, 0.0, 10.0 },
    { "global_damping", &SoftBodySettings::global_damping, 0.0, 10.0 },
    { "time_step_fraction", &SoftBodySettings::time_step_fraction, 0.001, 1.0 },
    { "actuation_frequency", &SoftBodySettings::actuation_frequency, 0.0, 1000.0 },
    { "actuation_amplitude", &SoftBodySettings::actuation_amplitude, 0.0, 0.5 },
  };
  return fields;
}

void SoftBodySettings::validate() const
{
  checkRanges(*this, softBodyIntegers());
  checkRanges(*this, softBodyReals());
  constexpr int64_t most_voxels = 32768;
  if (int64_t{ 1 } * grid_x * grid_y * grid_z > most_voxels)
  {
    throw InvalidInput("grid is " + toText(grid_x) + "x" + toText(grid_y) + "x" + toText(grid_z) +
                       "; it must have at most " + toText(most_voxels) + " voxels");
  }
  constexpr double most_drag = 6.28;  // from 2 pi on, drag would reverse a voxel's motion with growing speed
  if (!(global_damping * time_step_fraction <= most_drag))
  {
    throw InvalidInput("global_damping times time_step_fraction is " + toText(global_damping * time_step_fraction) +
                       "; it must be at most " + toText(most_drag));
  }
  constexpr double most_steps = 1e9;
  if (!((SETTLING_TIME + lifetime) / timeStep() <= most_steps))
  {
    throw InvalidInput("lifetime, voxel_size, density, youngs_modulus and time_step_fraction ask for more than " +
                       toText(most_steps) + " steps of " + toText(timeStep()) +
                       " s; a longer time step or a shorter lifetime is needed");
  }
}

double SoftBodySettings::timeStep() const
{
  constexpr double reference_pi = 3.1415926;  // the reference program's value
  const double axial_stiffness = youngs_modulus * voxel_size;
  const double mass = density * voxel_size * voxel_size * voxel_size;
  return time_step_fraction / (2.0 * reference_pi * std::sqrt(axial_stiffness / mass));
}
}  // namespace devo_evo
