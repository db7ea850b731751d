#include "interchange/vxa_format.h"

namespace devo_evo
{
const std::vector<VxaConstant>& vxaConstants()
{
  static const std::vector<VxaConstant> constants = {
    { "Simulator/Integration/Integrator", 0, false, "an integrator other than Euler's" },
    { "Simulator/Collisions/ColSystem", 3, false, "a collision system other than surface voxels within a horizon" },
    { "Simulator/Collisions/CollisionHorizon", 2, false, "another collision horizon" },
    { "Simulator/Features/MaxVelLimitEnabled", 0, false, "a limit of velocity" },
    { "Simulator/Features/BlendingEnabled", 0, false, "blending of materials" },
    { "Simulator/Features/FluidDampEnabled", 0, false, "fluid" },
    { "Simulator/Features/VolumeEffectsEnabled", 0, false, "volume effects" },
    { "Simulator/Features/PoissonKickBackEnabled", 0, false, "Poisson's kick-back" },
    { "Simulator/Features/EnforceLatticeEnabled", 0, false, "an enforced lattice" },
    { "Simulator/StopCondition/StopConditionType", 2, true, "a stop condition other than simulated time" },
    { "Simulator/StopCondition/AfterlifeTime", 0, false, "time after the end of life" },
    { "Simulator/StopCondition/MidLifeFreezeTime", 0, false, "freezing in the middle of life" },
    { "Simulator/StopCondition/InitCmTime", SETTLING_TIME, true, "another time from start to birth" },
    { "Simulator/EquilibriumMode/EquilibriumModeEnabled", 0, false, "equilibrium mode" },
    { "Simulator/MinTempFact", VXA_SMALLEST_SIZE, true, "another smallest size" },
    { "Simulator/MaxTempFactChange", 1e-5, false, "another speed limit of temperature" },
    { "Simulator/ErrorThreshold", 0, false, "adaptation to stress" },
    { "Simulator/ThresholdTime", 0, false, "adaptation to stress" },
    { "Simulator/MaxKP", 0, false, "adaptation to stress" },
    { "Simulator/MaxKI", 0, false, "adaptation to stress" },
    { "Simulator/MaxANTIWINDUP", 0, false, "adaptation to stress" },
    { "Simulator/ParentLifetime", 0, false, "a life that goes on from a parent's" },
    { "Environment/Fixed_Regions/NumFixed", 0, false, "fixed regions (obstacles)" },
    { "Environment/Forced_Regions/NumForced", 0, false, "forced regions" },
    { "Environment/Boundary_Conditions/NumBCs", 0, false, "boundary conditions (obstacles, forces)" },
    { "Environment/Gravity/FloorEnabled", 1, true, "a world without floor" },
    { "Environment/Gravity/FloorSlope", 0, false, "a sloping floor" },
    { "Environment/Thermal/TempEnabled", 1, true, "a robot without actuation" },
    { "Environment/Thermal/VaryTempEnabled", 1, true, "a robot without actuation" },
    { "Environment/GrowthAmplitude", VXA_GROWTH_AMPLITUDE, true, "another range of sizes" },
    { "Environment/MinGrowthTime", 0, false, "a least time of growth" },
    { "Environment/GrowthModel", 0, false, "another model of growth" },
    { "Environment/StickyFloor", 0, false, "a sticky floor" },
    { "Environment/NeedleInHaystack", 0, false, "a needle in a haystack" },
    { "Environment/KramerFabric", 0, false, "passive fabric" },
    { "Environment/FallingProhibited", 0, false, "an end by falling" },
    { "Environment/OnsetRelative", 0, false, "an onset of growth" },
    { "Environment/TerminationRelative", 0, false, "an end of growth" },
    { "Environment/BallisticSlowdownFact", 0.01, false, "another ballistic slowdown" },
    { "Environment/MaxSlowdownPermitted", 0.1, false, "another ballistic slowdown" },
    { "VXC/Lattice/X_Dim_Adj", 1, false, "a lattice that is not cubic" },
    { "VXC/Lattice/Y_Dim_Adj", 1, false, "a lattice that is not cubic" },
    { "VXC/Lattice/Z_Dim_Adj", 1, false, "a lattice that is not cubic" },
    { "VXC/Lattice/X_Line_Offset", 0, false, "a lattice that is not cubic" },
    { "VXC/Lattice/Y_Line_Offset", 0, false, "a lattice that is not cubic" },
    { "VXC/Lattice/X_Layer_Offset", 0, false, "a lattice that is not cubic" },
    { "VXC/Lattice/Y_Layer_Offset", 0, false, "a lattice that is not cubic" },
    { "VXC/Voxel/X_Squeeze", 1, false, "voxels that are no cubes" },
    { "VXC/Voxel/Y_Squeeze", 1, false, "voxels that are no cubes" },
    { "VXC/Voxel/Z_Squeeze", 1, false, "voxels that are no cubes" },
  };
  return constants;
}

const std::vector<VxaConstant>& vxaMaterialConstants()
{
  static const std::vector<VxaConstant> constants = {
    { "MatType", 0, false, "a composite material" },
    { "Mechanical/MatModel", 0, true, "a material that is not linear (plasticity, failure)" },
    { "Mechanical/Plastic_Mod", 0, false, "plasticity" },
    { "Mechanical/Yield_Stress", 0, false, "plasticity" },
    { "Mechanical/FailModel", 0, false, "failure" },
    { "Mechanical/Fail_Stress", 0, false, "failure" },
    { "Mechanical/Fail_Strain", 0, false, "failure" },
    { "Mechanical/MaterialTempPhase", 0, false, "a phase of the material" },
  };
  return constants;
}

const std::vector<const char*>& vxaIgnored()
{
  static const std::vector<const char*> tags = {
    "Simulator/SurfMesh",
    "Simulator/GA",
    "Simulator/Features/MaxVoxVelLimit",
    "Simulator/Features/MixRadius",
    "Simulator/Features/BlendModel",
    "Simulator/Features/PolyExp",
    "Simulator/MaxStiffnessChange",
    "Simulator/MinElasticMod",
    "Simulator/MaxElasticMod",
    "Environment/TimeBetweenTraces",
    "Environment/SaveTraces",
    "Environment/NormDistByVol",
    "Environment/NormalizationExponent",
    "Environment/NumTimeStepsInWindow",
  };
  return tags;
}

const std::vector<const char*>& vxaMaterialIgnored()
{
  static const std::vector<const char*> tags = { "Name", "Display" };
  return tags;
}
}  // namespace devo_evo
