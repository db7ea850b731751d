#include "interchange/vxa_tags.h"

#include "devo_evo/soft_body/settings.h"
#include "devo_evo/soft_body/text.h"

#include <charconv>
#include <cmath>

namespace devo_evo
{
VxaTag VxaTag::child(const char* name) const
{
  const auto found = optionalChild(name);
  if (!found)
  {
    refuse(std::string("<") + name + "> is missing in it");
  }
  return *found;
}

std::optional<VxaTag> VxaTag::optionalChild(const char* name) const
{
  const tinyxml2::XMLElement* first = element_->FirstChildElement(name);
  if (!first)
  {
    return std::nullopt;
  }
  if (const tinyxml2::XMLElement* second = first->NextSiblingElement(name))
  {
    VxaTag(file_, *second).refuse("it is given twice, first in line " + toText(first->GetLineNum()));
  }
  return VxaTag(file_, *first);
}

VxaTag VxaTag::descendant(const std::string& path) const
{
  const size_t slash = path.find('/');
  const VxaTag next = child(path.substr(0, slash).c_str());
  return slash == std::string::npos ? next : next.descendant(path.substr(slash + 1));
}

std::string VxaTag::text() const
{
  if (const tinyxml2::XMLElement* inner = element_->FirstChildElement())
  {
    refuse("there is a tag in it, " + quoted(inner->Name()) + "; it must hold text");
  }
  if (element_->FirstChild() != element_->LastChild())
  {
    refuse("its text is in several pieces (a comment in it?); it must be in one");
  }
  const char* content = element_->GetText();
  const std::string text = content ? content : "";
  const size_t begin = text.find_first_not_of(" \t\r\n");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

double VxaTag::number() const
{
  const auto value = finiteNumber(text());
  if (!value)
  {
    refuse("it is " + quoted(text()) + "; it must be a finite number");
  }
  return *value;
}

double VxaTag::number(double minimum, double maximum) const
{
  const double value = number();
  if (!(value >= minimum && value <= maximum))
  {
    refuse("it is " + toText(value) + "; it must lie within " + toText(minimum) + " to " + toText(maximum));
  }
  return value;
}

int VxaTag::whole(int minimum, int maximum) const
{
  const double value = number(minimum, maximum);  // the released experiments write 4.0
  if (value != std::floor(value))
  {
    refuse("it is " + toText(value) + "; it must be a whole number");
  }
  return static_cast<int>(value);
}

bool VxaTag::flag() const
{
  return whole(0, 1) == 1;
}

void VxaTag::refuse(const std::string& what) const
{
  throw InvalidInput(file_ + ", line " + toText(element_->GetLineNum()) + ", <" + element_->Name() + ">: " + what);
}

std::optional<double> finiteNumber(const std::string& text)
{
  double number = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end && std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
}

std::string quoted(const std::string& text)
{
  constexpr size_t longest = 60;
  std::string shown;
  for (const char character : text.substr(0, longest))
  {
    const auto code = static_cast<unsigned char>(character);
    shown += code < 0x20 || code >= 0x7f ? '?' : character;
  }
  return "\"" + shown + (text.size() > longest ? "...\"" : "\"");
}
}  // namespace devo_evo
