#include "ros/text_parameters.h"

#include "devo_evo/soft_body/settings.h"
#include "devo_evo/soft_body/text.h"

#include <ros/param.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <charconv>
#include <cmath>

namespace devo_evo
{
namespace
{
std::string textOf(const std::string& name, XmlRpc::XmlRpcValue& value)
{
  switch (value.getType())
  {
    case XmlRpc::XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    case XmlRpc::XmlRpcValue::TypeInt:
      return toText(static_cast<int>(value));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return toText(static_cast<double>(value));
    default:
      throw InvalidInput("parameter " + name + " must be text or a number");
  }
}

template <class Number>
Number parse(const std::string& name, const std::string& text, Number minimum, Number maximum)
{
  Number number{};
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc() || result.ptr != end || !(number >= minimum && number <= maximum))
  {
    throw InvalidInput("parameter " + name + " is \"" + text + "\"; it must be within " + toText(minimum) + " to " +
                       toText(maximum));
  }
  return number;
}
}  // namespace

TextParameters::TextParameters(const std::string& name_space, const std::map<std::string, std::string>& defaults)
  : values_(defaults)
{
  XmlRpc::XmlRpcValue given;
  if (!ros::param::get(name_space, given) || given.getType() != XmlRpc::XmlRpcValue::TypeStruct)
  {
    return;
  }
  for (auto& [name, value] : given)
  {
    const auto known = values_.find(name);
    if (known == values_.end())
    {
      throw InvalidInput("there is no parameter " + name + " of " + name_space);
    }
    const std::string text = textOf(name, value);
    known->second = text.empty() ? known->second : text;
  }
}

int64_t TextParameters::wholeNumber(const std::string& name, int64_t minimum, int64_t maximum) const
{
  return parse(name, text(name), minimum, maximum);
}

double TextParameters::number(const std::string& name, double minimum, double maximum) const
{
  return parse(name, text(name), minimum, maximum);
}

std::string TextParameters::absolutePath(const std::string& name) const
{
  const std::string& path = text(name);
  if (path.empty() || path.front() != '/')
  {
    throw InvalidInput("parameter " + name + " is \"" + path + "\"; it must be an absolute path");
  }
  return path;
}
}  // namespace devo_evo
