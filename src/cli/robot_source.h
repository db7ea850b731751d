#pragma once

#include "devo_evo/experiment/json_lines.h"

#include <istream>
#include <memory>
#include <string>

namespace devo_evo
{
/// A file with robots that is read twice: first to check all of it, then to simulate. What cannot be read twice
/// (standard input, a pipe) is kept in memory.
class RobotSource
{
public:
  /// @param path of a file; "-" for standard input. @throw InvalidInput if it cannot be read.
  explicit RobotSource(const std::string& path);

  /// Warns, on standard error, if ids come twice or there is no robot. @throw InvalidInput if a robot cannot be used.
  void check(const Body& body);

  /// From the beginning. The source must outlive the reader.
  RobotReader read(const Body& body);

private:
  const std::string name_;
  std::unique_ptr<std::istream> input_;
};
}  // namespace devo_evo
