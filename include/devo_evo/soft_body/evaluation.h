#pragma once

#include "devo_evo/soft_body/text.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
/// Why and where a simulation diverged (docs/physics.md 2.3). Deterministic, like every other result.
struct Divergence
{
  int64_t step = 0;     ///< number of the step at which it was found, counted from 1
  int bond = 0;         ///< lowest-numbered bond whose strain is not at most 100, in the order of Lattice::bonds()
  double strain = 0.0;  ///< of that bond [1]; may be NaN or infinite

  /// One sentence for people: "diverged at step 1234 (0.3074 s): bond 17 has strain 123.4".
  std::string describe(double time_step) const;
};

/// The outcome of one robot's life: a pure function of its DevelopmentalProgram and the settings, of soft bodies to the
/// last bit on every machine. What is not a soft body has its fitness in a unit of its own and none of what speaks of
/// voxels; it has body_measures instead. Body::measures() tells what there is.
struct Evaluation
{
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
  static constexpr double VELOCITY_WINDOW = 0.5;  ///< over which a velocity is averaged [s]

  bool valid = false;  ///< false if the simulation diverged; every number below is then NaN, empty or 0

  double fitness = NONE;                 ///< signed displacement along +y from birth to the end [body lengths]
  double displacement_y_voxels = NONE;   ///< the same [voxels]
  double displacement_xy_voxels = NONE;  ///< distance in the horizontal plane from birth to the end [voxels]

  std::optional<double>
      first_top_contact_since_birth_s;  ///< first touch of the floor by the top layer [s]; none: never
  std::optional<double>
      fell_over_since_birth_s;  ///< first time that more top voxels touch than others [s]; none: never

  double turns =
      NONE;  ///< accumulated rotation about the lateral axis x [full turns]; positive: rolling forwards, towards +y
  double airborne_fraction = NONE;  ///< share of the lifetime in which no voxel touches the floor [1]

  std::vector<double> velocity_body_lengths_per_s;  ///< mean along +y per VELOCITY_WINDOW from birth [body lengths / s]

  std::vector<double> body_measures;  ///< those of Body::measures() that have no name here, in their order; none of a
                                      ///< soft body

  uint64_t state_hash = 0;  ///< of the final state of every voxel (docs/physics.md, "State hash"); 0 if invalid

  std::optional<Divergence> divergence;  ///< set exactly if not valid
};
}  // namespace devo_evo
