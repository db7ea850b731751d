#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace devo_evo
{
/// The private parameters of a node that has a few of its own: all text, as launch files give them.
class TextParameters
{
public:
  /// Reads them from the parameter server. @param defaults all that there are, with the values they have if not given
  /// or empty. @throw InvalidInput if there is another parameter, or one that is no text or number.
  TextParameters(const std::string& name_space, const std::map<std::string, std::string>& defaults);

  const std::string& text(const std::string& name) const { return values_.at(name); }

  // Each throws InvalidInput naming the parameter and what it must be.
  int64_t wholeNumber(const std::string& name, int64_t minimum, int64_t maximum) const;
  double number(const std::string& name, double minimum, double maximum) const;

  /// A path that is not relative: nodes do not run where roslaunch was called.
  std::string absolutePath(const std::string& name) const;

private:
  std::map<std::string, std::string> values_;
};
}  // namespace devo_evo
