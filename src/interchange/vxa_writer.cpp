#include "devo_evo/interchange/vxa.h"

#include "devo_evo/soft_body/text.h"
#include "interchange/vxa_format.h"

#include <tinyxml2.h>

#include <algorithm>

namespace devo_evo
{
namespace
{
/// Thermal actuation that multiplies to an amplitude exactly.
struct Actuation
{
  double expansion;    ///< [1 / degree]
  double temperature;  ///< its highest [degrees]
};

Actuation actuationOf(double amplitude)
{
  // As the released experiments have it if that is exact, else one degree.
  return VXA_EXPANSION * VXA_TEMPERATURE_SWING == amplitude
             ? Actuation{ VXA_EXPANSION, VXA_BASE_TEMPERATURE + VXA_TEMPERATURE_SWING }
             : Actuation{ amplitude, VXA_BASE_TEMPERATURE + 1.0 };
}

/// One of the palette, as the released experiments have it.
struct Material
{
  const char* name;
  double red, green, blue;
  double stiffness;  ///< [Pa]; 0: that of the robot
  double expansion;  ///< in units of the robot's
};

const std::vector<Material> PALETTE = {
  { "Passive_Soft", 0, 1, 1, 0, 0 }, { "Passive_Hard", 0, 0, 1, 5e8, 0 }, { "Active_+", 1, 0, 0, 0, 1 },
  { "Active_-", 0, 1, 0, 0, -1 },    { "Obstacle", 1, 0.784, 0, 5e7, 0 }, { "Head_Active_+", 1, 1, 0, 0, 1 },
  { "Food", 1, 1, 0, 0, 0 },
};

class VxaWriter
{
public:
  explicit VxaWriter(const VxaRobot& robot) : robot_(robot), settings_(robot.settings) {}

  std::string write()
  {
    xml_.PushDeclaration("xml version=\"1.0\" encoding=\"ISO-8859-1\"");
    open("VXA");
    xml_.PushAttribute("Version", "1.0");
    writeSimulator();
    writeEnvironment();
    writeObject();
    writeOwn();
    close();
    return xml_.CStr();
  }

private:
  void open(const char* tag) { xml_.OpenElement(tag); }
  void close() { xml_.CloseElement(); }

  void text(const char* tag, const std::string& content)
  {
    open(tag);
    xml_.PushText(content.c_str());
    close();
  }

  void number(const char* tag, double value) { text(tag, toText(value + 0.0)); }

  /// The tags of a group, "Simulator/Damping", that hold one number whatever the robot is, and those of parameters.
  void group(const std::string& path)
  {
    for (const VxaNumber& each : vxaNumbers())
    {
      if (parentOf(each.path) == path)
      {
        number(nameOf(each.path), settings_.*fieldOf(each.parameter));
      }
    }
    for (const VxaConstant& each : vxaConstants())
    {
      if (parentOf(each.path) == path && written(each))
      {
        number(nameOf(each.path), each.value);
      }
    }
  }

  void wholeGroup(const char* tag, const std::string& path)
  {
    open(tag);
    group(path);
    close();
  }

  /// The released experiments leave the others out.
  static bool written(const VxaConstant& constant)
  {
    static const std::vector<std::string> left_out = {
      "Simulator/Features/MaxVelLimitEnabled",
      "Simulator/Features/BlendingEnabled",
      "Simulator/Features/VolumeEffectsEnabled",
      "Simulator/ParentLifetime",
      "Environment/Boundary_Conditions/NumBCs",
      "Environment/MinGrowthTime",
      "Environment/GrowthModel",
      "Environment/OnsetRelative",
      "Environment/TerminationRelative",
    };
    return std::find(left_out.begin(), left_out.end(), constant.path) == left_out.end();
  }

  static std::string parentOf(const std::string& path)
  {
    const size_t slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
  }

  static const char* nameOf(const char* path)
  {
    const char* slash = std::char_traits<char>::find(path, std::char_traits<char>::length(path), '/');
    return slash ? nameOf(slash + 1) : path;
  }

  static double SoftBodySettings::*fieldOf(const std::string& parameter)
  {
    const auto& fields = softBodyReals();
    return std::find_if(fields.begin(), fields.end(), [&](const auto& field) { return field.name == parameter; })
        ->value;
  }

  void writeSimulator()
  {
    open("Simulator");
    wholeGroup("Integration", "Simulator/Integration");
    wholeGroup("Damping", "Simulator/Damping");
    open("Collisions");
    number("SelfColEnabled", settings_.self_collision ? 1 : 0);
    group("Simulator/Collisions");
    close();
    wholeGroup("Features", "Simulator/Features");
    open("StopCondition");
    number("StopConditionValue", settings_.lifetime + SETTLING_TIME);
    group("Simulator/StopCondition");
    close();
    wholeGroup("EquilibriumMode", "Simulator/EquilibriumMode");
    open("GA");
    number("WriteFitnessFile", 1);
    text("FitnessFileName", "fitness.xml");
    close();
    group("Simulator");
    number("MaxStiffnessChange", 10000);
    number("MinElasticMod", 5e6);
    number("MaxElasticMod", 5e8);
    close();
  }

  void writeEnvironment()
  {
    open("Environment");
    wholeGroup("Fixed_Regions", "Environment/Fixed_Regions");
    wholeGroup("Forced_Regions", "Environment/Forced_Regions");
    open("Gravity");
    number("GravEnabled", 1);
    number("GravAcc", -settings_.gravity);
    group("Environment/Gravity");
    close();
    open("Thermal");
    group("Environment/Thermal");
    number("TempAmp", actuationOf(settings_.actuation_amplitude).temperature);
    number("TempBase", VXA_BASE_TEMPERATURE);
    number("TempPeriod", 1.0 / settings_.actuation_frequency);
    close();
    group("Environment");
    number("TimeBetweenTraces", 0);
    close();
  }

  void writeObject()
  {
    open("VXC");
    xml_.PushAttribute("Version", "0.93");
    wholeGroup("Lattice", "VXC/Lattice");
    open("Voxel");
    text("Vox_Name", "BOX");
    group("VXC/Voxel");
    close();
    open("Palette");
    for (size_t i = 0; i < PALETTE.size(); ++i)
    {
      writeMaterial(PALETTE[i], static_cast<int>(i) + 1);
    }
    close();
    writeStructure();
    close();
  }

  void writeMaterial(const Material& material, int id)
  {
    open("Material");
    xml_.PushAttribute("ID", id);
    number("MatType", 0);
    text("Name", material.name);
    open("Display");
    number("Red", material.red);
    number("Green", material.green);
    number("Blue", material.blue);
    number("Alpha", 1);
    close();
    open("Mechanical");
    number("MatModel", 0);
    number("Elastic_Mod", material.stiffness > 0.0 ? material.stiffness : settings_.youngs_modulus);
    for (const char* tag : { "Plastic_Mod", "Yield_Stress", "FailModel", "Fail_Stress", "Fail_Strain" })
    {
      number(tag, 0);
    }
    number("Density", settings_.density);
    number("Poissons_Ratio", settings_.poissons_ratio);
    number("CTE", material.expansion * actuationOf(settings_.actuation_amplitude).expansion);
    number("uStatic", settings_.static_friction);
    number("uDynamic", settings_.dynamic_friction);
    close();
    close();
  }

  void writeStructure()
  {
    const DevelopmentalProgram& program = robot_.genome.program;
    open("Structure");
    xml_.PushAttribute("Compression", "ASCII_READABLE");
    number("X_Voxels", settings_.grid_x);
    number("Y_Voxels", settings_.grid_y);
    number("Z_Voxels", settings_.grid_z);
    open("Data");
    for (int z = 0; z < settings_.grid_z; ++z)
    {
      layer(std::string(layerSize(), static_cast<char>('0' + VXA_ACTIVE_MATERIAL)));
    }
    close();
    // Without development there are no final values, as in the released Evo experiments.
    const bool develops =
        program.morphology_final != program.morphology_initial || program.control_final != program.control_initial;
    layers("InitialVoxelSize", program.morphology_initial);
    if (develops)
    {
      layers("FinalVoxelSize", program.morphology_final);
    }
    layers("PhaseOffset", program.control_initial);
    if (develops)
    {
      layers("FinalPhaseOffset", program.control_final);
    }
    close();
  }

  /// What the format has no place for. Other programs do not look here.
  void writeOwn()
  {
    open("DevoEvo");
    text("Id", robot_.id);
    number("Lifetime", settings_.lifetime);
    number("ActuationFrequency", settings_.actuation_frequency);
    number("SidewaysBendTest", settings_.sideways_bend_test ? 1 : 0);
    if (!robot_.genome.mutation_rate.empty())
    {
      layers("MutationRate", robot_.genome.mutation_rate);
    }
    close();
  }

  size_t layerSize() const { return static_cast<size_t>(settings_.grid_x) * static_cast<size_t>(settings_.grid_y); }

  void layer(const std::string& content)
  {
    open("Layer");
    xml_.PushText(content.c_str(), true);
    close();
  }

  void layers(const char* tag, const std::vector<double>& values)
  {
    open(tag);
    for (size_t begin = 0; begin < values.size(); begin += layerSize())
    {
      std::string content;
      for (size_t i = begin; i < begin + layerSize(); ++i)
      {
        content += toText(values[i]) + ", ";
      }
      layer(content);
    }
    close();
  }

  const VxaRobot& robot_;
  const SoftBodySettings& settings_;
  tinyxml2::XMLPrinter xml_;
};
}  // namespace

std::string toVxa(const VxaRobot& robot)
{
  robot.settings.validate();
  validate(robot.genome.program, robot.settings);
  if (robot.settings.actuation_frequency == 0.0)
  {
    throw InvalidInput("VXA has no actuation_frequency of 0; it must be positive");
  }
  if (robot.settings.slope != 0.0)
  {
    throw InvalidInput("Voxelyze has no sloping floor; slope must be 0 for VXA, and is " +
                       toText(robot.settings.slope));
  }
  return VxaWriter(robot).write();
}
}  // namespace devo_evo
