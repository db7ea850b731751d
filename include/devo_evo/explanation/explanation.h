#pragma once

#include <string>
#include <utility>
#include <vector>

namespace devo_evo
{
/// What one name means in one place.
struct Explanation
{
  std::string name;   ///< "fitness"
  std::string place;  ///< where it is called that: "table individuals (docs/archive.md)"
  std::string owner;  ///< of which it is a part: "individuals", "RobotEvaluation"; "" for parameters and measures

  /// What is said of it, in order: "Meaning", "Unit", "Formula", ...
  std::vector<std::pair<std::string, std::string>> facts;
};

/// Everything that has an explanation: measures, parameters, columns of the archive, fields of files and messages. They
/// come from the table of parameters and from the documents and message definitions that this program was built with.
const std::vector<Explanation>& explanations();

/// Those of a name, "fitness" or "individuals.fitness". @throw InvalidInput if there is none; names the most similar.
std::vector<Explanation> explain(const std::string& name);
}  // namespace devo_evo
