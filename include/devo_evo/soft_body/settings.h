#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace devo_evo
{
/// Thrown when a parameter, genome or file holds something that cannot be used; `what()` says what, where, and what
/// would be right.
class InvalidInput : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Everything besides the genome that an evaluation depends on: body grid, material, world and lifetime.
/// SI units. The defaults are the paper's; ranges stand in softBodyIntegers() and softBodyReals(). Symbols as in
/// docs/physics.md.
struct SoftBodySettings
{
  int grid_x = 4;  ///< voxels along x, the lateral axis [1]
  int grid_y = 4;  ///< voxels along y, the travel axis; one body length is grid_y voxels [1]
  int grid_z = 3;  ///< voxels along z, up [1]

  double lifetime = 10.0;  ///< tau, time from birth to the end of the evaluation [s]

  double voxel_size = 0.01;          ///< L, lattice pitch and nominal edge length [m]
  double density = 1.0e6;            ///< rho [kg/m^3]
  double youngs_modulus = 5.0e6;     ///< E [Pa]
  double poissons_ratio = 0.35;      ///< nu [1]
  double static_friction = 1.0;      ///< mu_s, voxel against floor [1]
  double dynamic_friction = 0.5;     ///< mu_d, voxel against floor [1]
  double gravity = 9.81;             ///< g [m/s^2]; along -z on level ground
  double slope = 0.0;                ///< rise over run of the floor along +y [1]; positive: uphill
  double bond_damping = 1.0;         ///< zeta_b, ratio of critical damping [1]
  double contact_damping = 0.8;      ///< zeta_c, of floor contacts [1]
  double global_damping = 0.01;      ///< zeta_g, of every voxel's motion [1]
  double time_step_fraction = 0.35;  ///< dt times 2 pi sqrt(E L / m), the stiffest frequency [1]

  double actuation_frequency = 4.0;   ///< f [Hz]
  double actuation_amplitude = 0.14;  ///< A, in units of voxel_size [1]

  bool self_collision = true;       ///< whether voxels far apart in the lattice push each other apart
  bool sideways_bend_test = false;  ///< whether sideways bending too ends a bond's small-angle regime (physics.md 2.2)

  /// @throw InvalidInput naming the field, its value and its range.
  void validate() const;

  /// Duration of one step [s], physics.md 4.
  double timeStep() const;

  int voxelCount() const { return grid_x * grid_y * grid_z; }
};

/// A number of the settings with the range it must lie in: the one place that knows the limits.
template <class Settings, class Value>
struct BoundedField
{
  const char* name;        ///< as in YAML, launch files and on the command line
  Value Settings::*value;  ///< where it stands
  Value minimum;           ///< inclusive
  Value maximum;           ///< inclusive
};

/// The whole numbers and the real numbers of SoftBodySettings, in their order.
const std::vector<BoundedField<SoftBodySettings, int>>& softBodyIntegers();
const std::vector<BoundedField<SoftBodySettings, double>>& softBodyReals();

/// Time from the start of the simulation to birth, in which the body grows and settles without actuation [s].
constexpr double SETTLING_TIME = 0.5;
}  // namespace devo_evo
