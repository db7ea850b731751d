#pragma once

#include "devo_evo/soft_body/settings.h"

#include <cstdint>
#include <vector>

namespace devo_evo
{
/// The world of the rigid quadruped, besides its genome (docs/rigid_body.md, which gives the reason of each value). SI
/// units. The paper states none of the numbers; ranges stand in rigidBodyReals().
struct RigidBodySettings
{
  double lifetime = 10.0;     ///< from birth to the end of the evaluation [s]
  double time_step = 0.0025;  ///< of the simulation [s]

  double gravity = 9.81;               ///< along -z of the world [m/s^2]
  double slope = 3.0;                  ///< by which the floor descends towards +y [degrees]
  double friction = 1.0;               ///< Coulomb's coefficient, robot against floor [1]
  double contact_stiffness = 10000.0;  ///< of the floor at each contact [N/m]
  double contact_damping = 200.0;      ///< of the floor at each contact [N s/m]

  double light_distance = 30.0;  ///< from the place of birth to the foot of the light, along the slope [m]
  double light_height = 1.0;     ///< of the light above the floor, along its normal [m]

  double abdomen_radius = 0.25;  ///< of the spherical abdomen [m]
  double abdomen_mass = 1.0;     ///< homogeneous [kg]
  double leg_radius = 0.025;     ///< of the rounded rods that are the legs [m]
  double leg_mass = 0.01;        ///< of each leg [kg]
  double leg_residual = 0.04;    ///< how far a leg of length 0 protrudes from the abdomen [m]
  double leg_range = 0.3;        ///< how much further a leg of length 1 protrudes [m]

  double hinge_limit = 45.0;         ///< how far a leg swings to either side of its place at rest [degrees]
  double hinge_gain = 20.0;          ///< speed that the hinge's motor seeks, per angle that is missing [1/s]
  double hinge_damping = 0.5;        ///< torque of the hinge's motor, per speed that is missing [N m s]
  double hinge_torque = 5.0;         ///< that the hinge's motor has at most [N m]
  double actuator_gain = 20.0;       ///< speed that the linear actuator seeks, per length that is missing [1/s]
  double actuator_damping = 100.0;   ///< force of the linear actuator, per speed that is missing [N s/m]
  double actuator_force = 100.0;     ///< that the linear actuator has at most [N]
  double generator_frequency = 1.0;  ///< of the central pattern generators [Hz]

  /// @throw InvalidInput naming the field, its value and its range, or how fields contradict each other.
  void validate() const;

  /// Steps from birth to the end of life [1].
  int64_t stepCount() const;
};

/// The numbers of RigidBodySettings, in their order.
const std::vector<BoundedField<RigidBodySettings, double>>& rigidBodyReals();
}  // namespace devo_evo
