#pragma once

#include "devo_evo/evolution/genome.h"

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <variant>

namespace devo_evo
{
/// What a file calls a robot: a whole number or any text.
using RobotId = std::variant<int64_t, std::string>;

/// One robot of a file.
struct RobotRecord
{
  int64_t line = 0;  ///< where it stands, counted from 1
  RobotId id;
  Genome genome;
};

/// Reads robots from JSON lines, one object a line (docs/tool.md, "Genomes"). Empty lines, a byte-order mark, Windows
/// line ends and fields it does not know are let pass.
class RobotReader
{
public:
  /// @param input must outlive the reader.
  /// @param name  of the input, for messages.
  /// @param body  of the robots: those of another kind are refused.
  RobotReader(std::istream& input, std::string name, const Body& body);

  /// The next robot, checked; none at the end of the input.
  /// @throw InvalidInput with the line for malformed JSON (and the column), a missing or wrong field, a genome that
  /// does not
  ///        fit the settings; std::runtime_error if the input cannot be read.
  std::optional<RobotRecord> next();

private:
  bool readLine();
  std::string position() const;

  std::istream& input_;
  const std::string name_;
  const std::string kind_;
  const GenomeLayout layout_;
  const size_t longest_line_;
  std::string text_;
  int64_t line_ = 0;
};

/// A robot as a line of JSON that RobotReader reads back as the same, without the line's end.
std::string robotToJson(const RobotId& id, const Genome& genome, const Body& body);

/// An evaluation as a line of JSON (docs/tool.md, "Evaluations"), without the line's end. Numbers read back as the
/// same; null where there is none.
std::string evaluationToJson(const RobotId& id, const Evaluation& evaluation, const Body& body);

/// An id as JSON has it: 17 or "golden-000".
std::string toJson(const RobotId& id);
}  // namespace devo_evo
