#include "ros/parameters.h"

#include <ros/master.h>
#include <ros/param.h>

#include <optional>
#include <stdexcept>
#include <vector>

namespace devo_evo
{
namespace
{
using XmlRpc::XmlRpcValue;

const char* const CONFIG = "config";

std::optional<ParameterValue> integersOf(XmlRpcValue& array)
{
  std::vector<int64_t> integers;
  for (int i = 0; i < array.size(); ++i)
  {
    if (array[i].getType() != XmlRpcValue::TypeInt)
    {
      return std::nullopt;
    }
    integers.push_back(static_cast<int>(array[i]));
  }
  return integers;
}

/// Nothing for a type that no parameter has: a group, or a list with something else than whole numbers.
std::optional<ParameterValue> valueOf(XmlRpcValue& value)
{
  switch (value.getType())
  {
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value);
    case XmlRpcValue::TypeInt:
      return static_cast<int64_t>(static_cast<int>(value));
    case XmlRpcValue::TypeDouble:
      return static_cast<double>(value);
    case XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    case XmlRpcValue::TypeArray:
      return integersOf(value);
    default:
      return std::nullopt;
  }
}
std::string configFile(XmlRpcValue& value, const std::string& source)
{
  const bool text = value.getType() == XmlRpcValue::TypeString;
  const std::string path = text ? static_cast<std::string>(value) : std::string();
  if (path.empty() || path[0] != '/')
  {
    throw InvalidInput(source + ": " + CONFIG + " is \"" + path + "\"; it must be the absolute path of a YAML file");
  }
  return path;
}
}  // namespace

Parameters parametersFrom(const XmlRpc::XmlRpcValue& value, const std::string& source, const Parameters& defaults)
{
  Parameters parameters = defaults;
  XmlRpcValue entries = value;
  if (entries.hasMember(CONFIG))
  {
    loadParameters(parameters, configFile(entries[CONFIG], source));
  }
  for (auto& [name, entry] : entries)
  {
    if (name == CONFIG)
    {
      continue;
    }
    const std::optional<ParameterValue> typed = valueOf(entry);
    if (!typed)
    {
      throw InvalidInput(source + ": " + name + " is a " +
                         (entry.getType() == XmlRpcValue::TypeArray ? "list of something else than whole numbers"
                                                                    : "group of parameters or binary data") +
                         "; it must be " + parameterSpec(name).allowed);
    }
    setParameter(parameters, name, *typed, source);
  }
  return parameters;
}

Parameters readParameters(const std::string& name_space, const Parameters& defaults)
{
  XmlRpc::XmlRpcValue group;
  if (!ros::param::get(name_space, group))
  {
    if (!ros::master::check())
    {
      throw std::runtime_error("cannot read parameters: no ROS master answers at " + ros::master::getURI());
    }
    return defaults;
  }
  return parametersFrom(group, "parameters of " + name_space, defaults);
}
}  // namespace devo_evo
