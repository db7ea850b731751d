#pragma once

#include <cstdint>

namespace devo_evo
{
/// Most robots that any kernel simulates in lock-step.
constexpr int MAX_LANES = 8;

/// A spring with a damper: it bears `present` times its deformation now, minus `past` times that of the last step.
struct DampedSpring
{
  double present;  ///< stiffness, and damping constant over dt
  double past;     ///< damping constant over dt
};

/// What a batch of robots has in common: lattice and material. Symbols as in docs/physics.md; SI units.
struct BodyModel
{
  int voxel_count;
  int bond_count;
  int stride[3];                    ///< from a voxel to its upper neighbour along x, y, z
  const uint8_t* upper_neighbours;  ///< (voxel_count), bit a: has an upper neighbour along axis a
  const uint8_t* in_top_layer;      ///< (voxel_count), 1 in the top layer

  double dt;
  double nominal_size;        ///< L
  double inverse_mass;        ///< 1 / m
  double inverse_inertia;     ///< 1 / I
  double weight;              ///< of a voxel, along -z: m g cos(slope)
  double weight_along_slope;  ///< along -y: m g sin(slope); never -0.0, so that on level ground it changes no bit
  double axial_stiffness;     ///< a1 = E A / L
  // Stiffness; damping constant times damping ratio.
  DampedSpring tension;              ///< a1; zeta_b c_a1 / 2
  DampedSpring torsion;              ///< a2 = G J / L; zeta_b c_a2 / 4
  DampedSpring shear;                ///< b1 = 12 E J2 / L^3; zeta_b c_b1 / 2
  DampedSpring coupling;             ///< b2 = 6 E J2 / L^2; zeta_b c_b2 / 2: of forces
  DampedSpring coupling_of_moments;  ///< b2; zeta_b c_b2 / 4
  DampedSpring bending;              ///< b3 = 2 E J2 / L; zeta_b c_b3 / 4
  double translation_drag;           ///< zeta_g 2 sqrt(m E L)
  double rotation_decay;             ///< factor on H in every step
  double floor_stiffness;            ///< 2 E L
  double floor_damping;              ///< zeta_c 2 sqrt(m E L)
  double static_friction;            ///< mu_s
  double dynamic_friction;           ///< mu_d
  double actuation_amplitude;        ///< A L
  bool sideways_bend_test;
};

/// What changes with time and is the same for all robots of a batch in one step.
struct StepClock
{
  bool first_step;         ///< of the simulation
  bool born;               ///< whether development and actuation have begun
  double prenatal_growth;  ///< b
  double life_fraction;    ///< k
  double cycles;           ///< f t
};

/// A pair of voxels that may touch, in the robots whose bit is set.
struct CollisionPair
{
  int32_t voxel_a;
  int32_t voxel_b;
  uint32_t robots;
};

/// Offsets of a voxel's quantities in its state; each stands for one number per lane.
enum VoxelField : int
{
  POSITION = 0,           ///< x, y, z
  ORIENTATION = 3,        ///< w, x, y, z: body to world
  MOMENTUM = 7,           ///< x, y, z
  ANGULAR_MOMENTUM = 10,  ///< x, y, z
  SCALE = 13,             ///< present resting edge length
  SIZE_AT_BIRTH = 14,     ///< resting length at birth
  SIZE_CHANGE = 15,       ///< from birth to the end of life
  PHASE_AT_BIRTH = 16,    ///< [cycles]
  PHASE_CHANGE = 17,      ///< [cycles]
  VOXEL_FIELDS = 18
};

/// Offsets of what a bond remembers from the last step that was not a switch step.
enum BondField : int
{
  STRETCH = 0,  ///< d: x
  TWIST = 1,    ///< alpha_2: x (that of alpha_1 is always 0)
  SUM = 2,      ///< alpha_1 and alpha_2 together: y, z
  ANGLE_1 = 4,  ///< alpha_1: y, z
  BOND_FIELDS = 6
};

/// Numbers that a bond remembers besides: d: y, z. They are 0 in the large-angle regime, so almost never used.
constexpr int SIDEWAYS_FIELDS = 2;

/// Numbers of a sum of loads on a voxel within a step: force and moment, each x, y, z.
constexpr int LOAD_FIELDS = 6;

/// Numbers of a sum of collision forces on a voxel: x, y, z.
constexpr int COLLISION_FIELDS = 3;

/// How many voxels go through the stages of a step together: enough independent work to hide the latency of each
/// operation, little enough to stay in the first-level cache.
constexpr int VOXEL_GROUP = 4;

/// Of how many voxels at most loads are being added up at a time: from the first of a group to the upper neighbour
/// along z of the last.
inline int loadWindow(const BodyModel& model)
{
  return model.stride[2] + VOXEL_GROUP;
}

/// The state of a batch of robots, one a lane.
struct BatchState
{
  double* voxels;            ///< (voxel_count x VOXEL_FIELDS x lanes), aligned to 64 bytes
  double* bonds;             ///< (bond_count x BOND_FIELDS x lanes), aligned to 64 bytes
  double* sideways;          ///< (bond_count x SIDEWAYS_FIELDS x lanes), aligned to 64 bytes
  double* loads;             ///< (loadWindow() x LOAD_FIELDS x lanes), aligned to 64 bytes: the kernel's to use
  double* collision_forces;  ///< (voxel_count x COLLISION_FIELDS x lanes), aligned to 64 bytes: likewise
  uint8_t* collided;         ///< (voxel_count): likewise; 0 between steps
  uint8_t* small_angle;      ///< (bond_count), bit l: lane l's bond is in the small-angle regime
  uint8_t* was_sideways;     ///< (bond_count), bit l: what lane l's bond remembers is from the small-angle regime
  uint8_t* static_friction;  ///< (voxel_count), bit l: the floor holds lane l's voxel

  const CollisionPair* collision_pairs;  ///< in ascending order of (voxel_a, voxel_b)
  int collision_pair_count;

  // What a step reports, one entry per lane.
  double max_speed_squared[MAX_LANES];  ///< of the fastest voxel [m^2/s^2]
  double top_contacts[MAX_LANES];       ///< number of top-layer voxels on the floor
  double other_contacts[MAX_LANES];     ///< number of other voxels on the floor
  uint32_t diverged;                    ///< bit l: lane l has a bond with a strain that is not at most 100
  int diverged_bond[MAX_LANES];         ///< the lowest such bond
  double diverged_strain[MAX_LANES];    ///< and its strain
};

/// The kernel for one instruction set.
struct Kernel
{
  int lanes;

  /// Advances a batch by one time step (docs/physics.md 2 to 5).
  void (*step)(const BodyModel& model, const StepClock& clock, BatchState& state);
};

/// The kernels in this program; null where the compiler's target has none.
const Kernel* scalarKernel();
const Kernel* scalarFmaKernel();  ///< the scalar one for x86-64 processors that fuse multiply and add: faster, as equal
const Kernel* avx2Kernel();
const Kernel* avx512Kernel();
}  // namespace devo_evo
