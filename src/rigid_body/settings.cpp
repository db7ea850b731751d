#include "devo_evo/rigid_body/settings.h"

#include "devo_evo/soft_body/text.h"
#include "rigid_body/cycle_functions.h"
#include "soft_body/check_ranges.h"

#include <cmath>

namespace devo_evo
{
const std::vector<BoundedField<RigidBodySettings, double>>& rigidBodyReals()
{
  static const std::vector<BoundedField<RigidBodySettings, double>> fields = {
    { "rigid_lifetime", &RigidBodySettings::lifetime, 0.001, 1000.0 },
    { "rigid_time_step", &RigidBodySettings::time_step, 1e-5, 0.05 },
    { "rigid_gravity", &RigidBodySettings::gravity, 0.0, 100.0 },
    { "rigid_slope", &RigidBodySettings::slope, 0.0, 45.0 },
    { "rigid_friction", &RigidBodySettings::friction, 0.0, 100.0 },
    { "rigid_contact_stiffness", &RigidBodySettings::contact_stiffness, 100.0, 1e7 },
    { "rigid_contact_damping", &RigidBodySettings::contact_damping, 0.0, 1e5 },
    { "rigid_light_distance", &RigidBodySettings::light_distance, 0.0, 1000.0 },
    { "rigid_light_height", &RigidBodySettings::light_height, 0.0, 1000.0 },
    { "rigid_abdomen_radius", &RigidBodySettings::abdomen_radius, 0.01, 10.0 },
    { "rigid_abdomen_mass", &RigidBodySettings::abdomen_mass, 0.001, 1000.0 },
    { "rigid_leg_radius", &RigidBodySettings::leg_radius, 0.001, 1.0 },
    { "rigid_leg_mass", &RigidBodySettings::leg_mass, 0.0001, 100.0 },
    { "rigid_leg_residual", &RigidBodySettings::leg_residual, 0.0, 10.0 },
    { "rigid_leg_range", &RigidBodySettings::leg_range, 0.0, 10.0 },
    { "rigid_hinge_limit", &RigidBodySettings::hinge_limit, 0.0, 90.0 },
    { "rigid_hinge_gain", &RigidBodySettings::hinge_gain, 0.0, 1000.0 },
    { "rigid_hinge_damping", &RigidBodySettings::hinge_damping, 1e-6, 1000.0 },
    { "rigid_hinge_torque", &RigidBodySettings::hinge_torque, 0.0, 1000.0 },
    { "rigid_actuator_gain", &RigidBodySettings::actuator_gain, 0.0, 1000.0 },
    { "rigid_actuator_damping", &RigidBodySettings::actuator_damping, 1e-6, 1e5 },
    { "rigid_actuator_force", &RigidBodySettings::actuator_force, 0.0, 10000.0 },
    { "rigid_generator_frequency", &RigidBodySettings::generator_frequency, 0.0, 100.0 },
  };
  return fields;
}

void RigidBodySettings::validate() const
{
  checkRanges(*this, rigidBodyReals());
  if (leg_residual + leg_range < 2.0 * leg_radius)
  {
    throw InvalidInput("rigid_leg_residual + rigid_leg_range is " + toText(leg_residual + leg_range) +
                       "; a leg with its rounded ends needs at least twice rigid_leg_radius, " +
                       toText(2.0 * leg_radius));
  }
  // Drawn in, a leg must end inside the abdomen however far it has swung.
  const double room = 2.0 * abdomen_radius * cosineOfCycles(hinge_limit / 360.0);
  if (leg_range > room)
  {
    throw InvalidInput("rigid_leg_range is " + toText(leg_range) +
                       "; with this rigid_abdomen_radius and rigid_hinge_limit, a leg can be drawn in by at most " +
                       toText(room));
  }
  constexpr double most_steps = 1e7;
  if (!(lifetime / time_step <= most_steps))
  {
    throw InvalidInput("rigid_lifetime and rigid_time_step ask for more than " + toText(most_steps) +
                       " steps; a longer time step or a shorter lifetime is needed");
  }
}

int64_t RigidBodySettings::stepCount() const
{
  return std::max<int64_t>(1, std::llround(lifetime / time_step));
}
}  // namespace devo_evo
