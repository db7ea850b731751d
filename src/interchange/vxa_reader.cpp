#include "devo_evo/interchange/vxa.h"

#include "devo_evo/soft_body/text.h"
#include "interchange/vxa_format.h"
#include "interchange/vxa_tags.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <set>

namespace devo_evo
{
namespace
{
/// Tags that are read one by one, below.
const std::set<std::string> READ = {
  "Simulator/Collisions/SelfColEnabled",
  "Simulator/StopCondition/StopConditionValue",
  "Environment/Gravity/GravEnabled",
  "Environment/Gravity/GravAcc",
  "Environment/Thermal/TempAmp",
  "Environment/Thermal/TempAmplitude",
  "Environment/Thermal/TempBase",
  "Environment/Thermal/TempPeriod",
  "VXC/Voxel/Vox_Name",
  "VXC/Palette",
  "VXC/Structure",
  "DevoEvo",
};

/// What is known of tags, by their paths.
struct Knowledge
{
  std::set<std::string> leaves;      ///< taken with all that is in them
  std::set<std::string> containers;  ///< looked into
  const std::vector<VxaConstant>& constants;

  Knowledge(const std::vector<VxaConstant>& a_constants, const std::vector<VxaNumber>& numbers,
            const std::vector<const char*>& ignored, const std::set<std::string>& read)
    : leaves(read), constants(a_constants)
  {
    for (const VxaConstant& each : constants)
    {
      leaves.insert(each.path);
    }
    for (const VxaNumber& each : numbers)
    {
      leaves.insert(each.path);
    }
    leaves.insert(ignored.begin(), ignored.end());
    for (const std::string& path : leaves)
    {
      for (size_t slash = path.find('/'); slash != std::string::npos; slash = path.find('/', slash + 1))
      {
        containers.insert(path.substr(0, slash));
      }
    }
  }
};

/// Refuses what is not known, by name. The depth is that of the known paths.
void checkKnown(const VxaTag& tag, const Knowledge& knowledge, const std::string& path, const std::string& file)
{
  for (const auto* child = tag.element().FirstChildElement(); child; child = child->NextSiblingElement())
  {
    const std::string child_path = (path.empty() ? "" : path + "/") + child->Name();
    const VxaTag inner(file, *child);
    if (knowledge.containers.count(child_path) != 0)
    {
      checkKnown(inner, knowledge, child_path, file);
    }
    else if (knowledge.leaves.count(child_path) == 0)
    {
      inner.refuse("this is not simulated here, and would change the robot's life; remove it if it does not matter");
    }
  }
}

/// The descendant, if all tags on the way are there.
std::optional<VxaTag> find(const VxaTag& root, const std::string& path)
{
  std::optional<VxaTag> tag = root;
  for (size_t begin = 0, end = 0; tag && end != std::string::npos; begin = end + 1)
  {
    end = path.find('/', begin);
    tag = tag->optionalChild(path.substr(begin, end - begin).c_str());
  }
  return tag;
}

void checkConstants(const VxaTag& root, const std::vector<VxaConstant>& constants)
{
  for (const VxaConstant& constant : constants)
  {
    const auto tag = constant.needed ? root.descendant(constant.path) : find(root, constant.path);
    if (tag && tag->number() != constant.value)
    {
      tag->refuse("it is " + toText(tag->number()) + ": " + constant.feature + " is not simulated here; it must be " +
                  toText(constant.value));
    }
  }
}

void readNumbers(SoftBodySettings& settings, const VxaTag& root, const std::vector<VxaNumber>& numbers)
{
  const auto& fields = softBodyReals();
  for (const VxaNumber& number : numbers)
  {
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&](const auto& each) { return each.name == std::string(number.parameter); });
    settings.*field->value = root.descendant(number.path).number(field->minimum, field->maximum) + 0.0;
  }
}

double boundedReal(const VxaTag& tag, const std::string& parameter, double value)
{
  const auto& fields = softBodyReals();
  const auto field =
      std::find_if(fields.begin(), fields.end(), [&](const auto& each) { return each.name == parameter; });
  if (!(value >= field->minimum && value <= field->maximum))
  {
    tag.refuse("it makes " + parameter + " " + toText(value) + "; it must lie within " + toText(field->minimum) +
               " to " + toText(field->maximum));
  }
  return value + 0.0;
}

/// The number with the fewest digits near `guess` that the writer would turn into `written`; else the guess.
double original(double guess, double written, const std::function<double(double)>& write)
{
  for (int digits = 0; digits < 17; ++digits)
  {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, guess, std::chars_format::scientific, digits).ptr;
    const auto candidate = finiteNumber(std::string(text, end));
    if (candidate && write(*candidate) == written)
    {
      return *candidate;
    }
  }
  return guess;
}

class VxaReader
{
public:
  VxaReader(const std::string& text, const std::string& file) : file_(file)
  {
    if (text.size() > LARGEST_VXA_FILE)
    {
      throw InvalidInput(file + ": it has more than " + toText(static_cast<int64_t>(LARGEST_VXA_FILE)) +
                         " bytes, more than any robot needs");
    }
    refuseDocumentTypes(text);
    if (document_.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
    {
      throw InvalidInput(file + ", line " + toText(document_.ErrorLineNum()) + ": malformed XML (" +
                         document_.ErrorName() + ")");
    }
  }

  VxaRobot read()
  {
    const VxaTag root = rootTag();
    checkKnown(root, Knowledge(vxaConstants(), vxaNumbers(), vxaIgnored(), READ), "", file_);
    checkConstants(root, vxaConstants());
    readNumbers(robot_.settings, root, vxaNumbers());
    readWorld(root);
    readStructure(root.descendant("VXC/Structure"));
    readMaterial(root.descendant("VXC/Palette"));
    readActuation(root);
    robot_.id = file_;
    if (const auto own = root.optionalChild("DevoEvo"))
    {
      readOwn(*own);
    }
    robot_.settings.validate();
    validate(robot_.genome.program, robot_.settings);
    return robot_;
  }

private:
  void refuseDocumentTypes(const std::string& text) const
  {
    for (const char* const opening : { "<!DOCTYPE", "<!ENTITY" })
    {
      if (text.find(opening) != std::string::npos)
      {
        throw InvalidInput(file_ + ": it has a document type or entities (" + opening +
                           " ...>), which VXA files do not have; remove them");
      }
    }
  }

  VxaTag rootTag() const
  {
    const tinyxml2::XMLElement* root = document_.RootElement();
    if (!root || std::string(root->Name()) != "VXA" || root->NextSiblingElement())
    {
      throw InvalidInput(file_ + ": it is not a VXA file, whose only outermost tag is <VXA>");
    }
    return VxaTag(file_, *root);
  }

  void readWorld(const VxaTag& root)
  {
    SoftBodySettings& settings = robot_.settings;
    settings.self_collision = root.descendant("Simulator/Collisions/SelfColEnabled").flag();
    const VxaTag end = root.descendant("Simulator/StopCondition/StopConditionValue");
    const auto written = [](double lifetime) { return lifetime + SETTLING_TIME; };
    settings.lifetime = boundedReal(end, "lifetime", original(end.number() - SETTLING_TIME, end.number(), written));
    const VxaTag gravity = root.descendant("Environment/Gravity");
    const VxaTag acceleration = gravity.child("GravAcc");
    const bool enabled = gravity.child("GravEnabled").flag();
    settings.gravity = boundedReal(acceleration, "gravity", enabled ? -acceleration.number() : 0.0);
    const VxaTag shape = root.descendant("VXC/Voxel/Vox_Name");
    if (shape.text() != "BOX")
    {
      shape.refuse("it is " + quoted(shape.text()) + "; voxels must be BOX");
    }
  }

  void readActuation(const VxaTag& root)
  {
    const VxaTag thermal = root.descendant("Environment/Thermal");
    const double base = thermal.child("TempBase").number();
    const auto amplitude = thermal.optionalChild("TempAmplitude");
    const double swing = amplitude ? amplitude->number() : thermal.child("TempAmp").number() - base;
    robot_.settings.actuation_amplitude = boundedReal(thermal, "actuation_amplitude", expansion_ * swing);
    const VxaTag period = thermal.child("TempPeriod");
    const auto written = [](double frequency) { return 1.0 / frequency; };
    robot_.settings.actuation_frequency =
        boundedReal(period, "actuation_frequency", original(1.0 / period.number(), period.number(), written));
  }

  void readMaterial(const VxaTag& palette)
  {
    const tinyxml2::XMLElement* found = nullptr;
    for (const auto* each = palette.element().FirstChildElement(); each; each = each->NextSiblingElement())
    {
      const VxaTag tag(file_, *each);
      if (tag.name() != "Material")
      {
        tag.refuse("a palette holds materials only");
      }
      if (each->IntAttribute("ID") == material_)
      {
        if (found)
        {
          tag.refuse("material " + toText(material_) + " is given twice");
        }
        found = each;
      }
    }
    if (!found)
    {
      palette.refuse("there is no <Material ID=\"" + toText(material_) + "\">, which the voxels are made of");
    }
    const VxaTag material(file_, *found);
    const Knowledge knowledge(vxaMaterialConstants(), vxaMaterialNumbers(), vxaMaterialIgnored(), { "Mechanical/CTE" });
    checkKnown(material, knowledge, "", file_);
    checkConstants(material, vxaMaterialConstants());
    readNumbers(robot_.settings, material, vxaMaterialNumbers());
    expansion_ = material.descendant("Mechanical/CTE").number();
  }

  void readStructure(const VxaTag& structure)
  {
    const char* compression = structure.element().Attribute("Compression");
    if (!compression || std::string(compression) != "ASCII_READABLE")
    {
      structure.refuse("its compression is " + quoted(compression ? compression : "") + "; it must be ASCII_READABLE");
    }
    static const std::set<std::string> known = {
      "X_Voxels",         "Y_Voxels",       "Z_Voxels",    "Data",
      "InitialVoxelSize", "FinalVoxelSize", "PhaseOffset", "FinalPhaseOffset"
    };
    for (const auto* each = structure.element().FirstChildElement(); each; each = each->NextSiblingElement())
    {
      if (known.count(each->Name()) == 0)
      {
        VxaTag(file_, *each).refuse("this is not simulated here, and would change the robot's life");
      }
    }
    SoftBodySettings& settings = robot_.settings;
    settings.grid_x = structure.child("X_Voxels").whole(1, 64);
    settings.grid_y = structure.child("Y_Voxels").whole(1, 64);
    settings.grid_z = structure.child("Z_Voxels").whole(1, 64);
    constexpr int most_voxels = 32768;
    if (settings.voxelCount() > most_voxels)
    {
      structure.refuse("it has " + toText(settings.voxelCount()) + " voxels; it must have at most " +
                       toText(most_voxels));
    }
    readData(structure.child("Data"));
    readProgram(structure);
  }

  void readProgram(const VxaTag& structure)
  {
    DevelopmentalProgram& program = robot_.genome.program;
    program.morphology_initial = readLayers(structure.child("InitialVoxelSize"), -1.0, 1.0);
    program.control_initial = readLayers(structure.child("PhaseOffset"), -1.0, 1.0);
    program.morphology_final = program.morphology_initial;
    program.control_final = program.control_initial;
    const auto final_size = structure.optionalChild("FinalVoxelSize");
    const auto final_phase = structure.optionalChild("FinalPhaseOffset");
    if (final_phase && !final_size)
    {
      final_phase->refuse("Voxelyze lets phases develop only where there is a <FinalVoxelSize> too; add that");
    }
    if (final_size)
    {
      program.morphology_final = readLayers(*final_size, -1.0, 1.0);
    }
    if (final_phase)
    {
      program.control_final = readLayers(*final_phase, -1.0, 1.0);
    }
  }

  /// Contents of the layers, one per voxel along z.
  std::vector<std::string> layersOf(const VxaTag& tag) const
  {
    std::vector<std::string> layers;
    for (const auto* each = tag.element().FirstChildElement(); each; each = each->NextSiblingElement())
    {
      const VxaTag layer(file_, *each);
      if (layer.name() != "Layer")
      {
        layer.refuse("there must be nothing but <Layer> here");
      }
      layers.push_back(layer.text());
    }
    if (layers.size() != static_cast<size_t>(robot_.settings.grid_z))
    {
      tag.refuse("it has " + toText(static_cast<int64_t>(layers.size())) + " layers; <Z_Voxels> asks for " +
                 toText(robot_.settings.grid_z));
    }
    return layers;
  }

  size_t layerSize() const
  {
    return static_cast<size_t>(robot_.settings.grid_x) * static_cast<size_t>(robot_.settings.grid_y);
  }

  /// Every voxel must be there, and of the same material.
  void readData(const VxaTag& data)
  {
    std::string voxels;
    for (const std::string& layer : layersOf(data))
    {
      if (layer.size() != layerSize())
      {
        data.refuse("a layer has " + toText(static_cast<int64_t>(layer.size())) +
                    " voxels; <X_Voxels> and <Y_Voxels> ask for " + toText(static_cast<int64_t>(layerSize())));
      }
      voxels += layer;
    }
    const char first = voxels.front();
    const size_t other = voxels.find_first_not_of(first);
    const size_t place = other == std::string::npos ? 0 : other;
    const std::string voxel = "voxel " + toText(static_cast<int64_t>(place)) + " is " + quoted(voxels.substr(place, 1));
    if (voxels[place] == '0')
    {
      data.refuse(voxel + ", empty: bodies with missing voxels are not simulated here");
    }
    if (other != std::string::npos || first < '1' || first > '9')
    {
      data.refuse(voxel +
                  ": bodies of several materials (obstacles, food, bone) are not simulated here; every voxel "
                  "must be of the same");
    }
    if (first >= '5' && first <= '7')
    {
      data.refuse(voxel + ", which Voxelyze takes for an obstacle, a head or food; a body must be of another material");
    }
    material_ = first - '0';
  }

  std::vector<double> readLayers(const VxaTag& tag, double minimum, double maximum) const
  {
    std::vector<double> values;
    for (const std::string& layer : layersOf(tag))
    {
      const size_t before = values.size();
      for (size_t begin = 0, end = 0; end != std::string::npos && begin < layer.size(); begin = end + 1)
      {
        end = layer.find(',', begin);
        values.push_back(readValue(tag, layer.substr(begin, end - begin), values.size(), minimum, maximum));
        if (values.size() - before > layerSize())
        {
          break;
        }
      }
      if (values.size() - before != layerSize())
      {
        tag.refuse("a layer has " + std::string(values.size() - before > layerSize() ? "more than " : "only ") +
                   toText(static_cast<int64_t>(std::min(values.size() - before, layerSize()))) +
                   " values; <X_Voxels> and <Y_Voxels> ask for " + toText(static_cast<int64_t>(layerSize())));
      }
    }
    return values;
  }

  static double readValue(const VxaTag& tag, const std::string& text, size_t voxel, double minimum, double maximum)
  {
    const size_t begin = text.find_first_not_of(" \t\r\n");
    const size_t end = text.find_last_not_of(" \t\r\n");
    const auto value = begin == std::string::npos ? std::nullopt : finiteNumber(text.substr(begin, end - begin + 1));
    if (!value || !(*value >= minimum - GENE_TOLERANCE && *value <= maximum + GENE_TOLERANCE))
    {
      tag.refuse("the value of voxel " + toText(static_cast<int64_t>(voxel)) + " is " + quoted(text) +
                 "; it must be a number within " + toText(minimum) + " to " + toText(maximum));
    }
    return *value;
  }

  /// What our writer adds must agree with what is written for others.
  void readOwn(const VxaTag& own)
  {
    static const std::set<std::string> known = { "Id", "Lifetime", "ActuationFrequency", "SidewaysBendTest",
                                                 "MutationRate" };
    for (const auto* each = own.element().FirstChildElement(); each; each = each->NextSiblingElement())
    {
      if (known.count(each->Name()) == 0)
      {
        VxaTag(file_, *each).refuse("it is of no known meaning");
      }
    }
    SoftBodySettings& settings = robot_.settings;
    if (const auto id = own.optionalChild("Id"))
    {
      robot_.id = id->text();
    }
    if (const auto lifetime = own.optionalChild("Lifetime"))
    {
      readExact(*lifetime, settings.lifetime, "StopConditionValue", [](double value) { return value + SETTLING_TIME; });
    }
    if (const auto frequency = own.optionalChild("ActuationFrequency"))
    {
      readExact(*frequency, settings.actuation_frequency, "TempPeriod", [](double value) { return 1.0 / value; });
    }
    if (const auto test = own.optionalChild("SidewaysBendTest"))
    {
      settings.sideways_bend_test = test->flag();
    }
    if (const auto rates = own.optionalChild("MutationRate"))
    {
      robot_.genome.mutation_rate = readLayers(*rates, 0.0, 1.0);
    }
  }

  /// A number that the tag for others holds converted, with a loss in the last digit. @param value as read from there.
  static void readExact(const VxaTag& tag, double& value, const char* other, const std::function<double(double)>& write)
  {
    const double exact = tag.number();
    if (write(exact) != write(value))
    {
      tag.refuse("it is " + toText(exact) + ", which contradicts <" + other + ">; change both, or remove this one");
    }
    value = exact;
  }

  const std::string file_;
  tinyxml2::XMLDocument document_;
  VxaRobot robot_;
  int material_ = VXA_ACTIVE_MATERIAL;
  double expansion_ = 0.0;  // of the material [1 / degree]
};
}  // namespace

VxaRobot readVxa(const std::string& text, const std::string& name)
{
  return VxaReader(text, name).read();
}

bool looksLikeVxa(const std::string& text)
{
  const size_t mark = text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
  const size_t first = text.find_first_not_of(" \t\r\n", mark);
  return first != std::string::npos && text[first] == '<';
}
}  // namespace devo_evo
