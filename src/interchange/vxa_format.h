#pragma once

#include "devo_evo/soft_body/settings.h"

#include <vector>

namespace devo_evo
{
// What VXA writer and reader share: names, and what the released experiments set (docs/interchange.md).

constexpr double VXA_BASE_TEMPERATURE = 25.0;   ///< at which nothing is actuated [degrees]
constexpr double VXA_TEMPERATURE_SWING = 14.0;  ///< TempAmp 39 [degrees]
constexpr double VXA_EXPANSION = 0.01;          ///< of the active material [1 / degree]
constexpr int VXA_ACTIVE_MATERIAL = 3;          ///< "Active_+", which every voxel is made of
constexpr double VXA_GROWTH_AMPLITUDE = 0.75;   ///< resting length = lattice size (1 + 0.75 gene)
constexpr double VXA_SMALLEST_SIZE = 0.25;      ///< of a voxel, in lattice sizes

/// A parameter that stands in a tag as it is.
struct VxaNumber
{
  const char* path;  ///< from the root element
  const char* parameter;
};

/// The tags whose numbers are parameters, unconverted.
inline const std::vector<VxaNumber>& vxaNumbers()
{
  static const std::vector<VxaNumber> numbers = {
    { "Simulator/Integration/DtFrac", "time_step_fraction" },
    { "Simulator/Damping/BondDampingZ", "bond_damping" },
    { "Simulator/Damping/ColDampingZ", "contact_damping" },
    { "Simulator/Damping/SlowDampingZ", "global_damping" },
    { "VXC/Lattice/Lattice_Dim", "voxel_size" },
  };
  return numbers;
}

/// The same, within the material that voxels are made of.
inline const std::vector<VxaNumber>& vxaMaterialNumbers()
{
  static const std::vector<VxaNumber> numbers = {
    { "Mechanical/Elastic_Mod", "youngs_modulus" },    { "Mechanical/Density", "density" },
    { "Mechanical/Poissons_Ratio", "poissons_ratio" }, { "Mechanical/uStatic", "static_friction" },
    { "Mechanical/uDynamic", "dynamic_friction" },
  };
  return numbers;
}

/// A tag that must hold one number, since nothing else is simulated here.
struct VxaConstant
{
  const char* path;
  double value;
  bool needed;          ///< whether it must be there: without it, Voxelyze would take another value
  const char* feature;  ///< what another value asks for
};

/// Under the root element, and under the material that voxels are made of.
const std::vector<VxaConstant>& vxaConstants();
const std::vector<VxaConstant>& vxaMaterialConstants();

/// Tags, with all that is in them, that change nothing of how a robot moves.
const std::vector<const char*>& vxaIgnored();
const std::vector<const char*>& vxaMaterialIgnored();
}  // namespace devo_evo
