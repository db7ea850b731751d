#pragma once

#include <tinyxml2.h>

#include <cstdint>
#include <optional>
#include <string>

namespace devo_evo
{
/// An element of an XML file, which knows where it stands: complaints name file, line and tag.
class VxaTag
{
public:
  VxaTag(const std::string& file, const tinyxml2::XMLElement& element) : file_(file), element_(&element) {}

  std::string name() const { return element_->Name(); }
  const tinyxml2::XMLElement& element() const { return *element_; }

  /// The only child of this name. @throw InvalidInput if it is missing or given twice.
  VxaTag child(const char* name) const;
  std::optional<VxaTag> optionalChild(const char* name) const;  ///< @throw InvalidInput if it is given twice

  /// A descendant, "Damping/BondDampingZ". @throw InvalidInput if a tag on the way is missing or given twice.
  VxaTag descendant(const std::string& path) const;

  /// The content, without white space around it. @throw InvalidInput if there are tags in it.
  std::string text() const;

  double number() const;                                ///< @throw InvalidInput unless it is a finite number
  double number(double minimum, double maximum) const;  ///< @throw InvalidInput also if it is out of range
  int whole(int minimum, int maximum) const;            ///< @throw InvalidInput unless a whole one in range
  bool flag() const;                                    ///< @throw InvalidInput unless it is 0 or 1

  /// "robot.vxa, line 12, <BondDampingZ>: " and what is wrong with it.
  [[noreturn]] void refuse(const std::string& what) const;

private:
  std::string file_;
  const tinyxml2::XMLElement* element_;
};

/// The number that a text is, and nothing else; none if it is not one, or not finite.
std::optional<double> finiteNumber(const std::string& text);

/// Text as complaints show it: its beginning, without what is not printable.
std::string quoted(const std::string& text);
}  // namespace devo_evo
