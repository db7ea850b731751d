#pragma once

#include <fstream>
#include <ostream>
#include <string>
#include <vector>

namespace devo_evo
{
/// Where results go, line by line. Whatever keeps them from being written is an error, never silent.
class ResultStream
{
public:
  /// @param path of a file, which is replaced; "-" for standard output.
  /// @param others files that the command reads or writes, too: they must not be overwritten.
  /// @throw InvalidInput if it is one of them; std::runtime_error if it cannot be written.
  ResultStream(const std::string& path, const std::vector<std::string>& others);

  // Each throws std::runtime_error if not everything could be written.
  void writeLine(const std::string& line);
  void flush();
  void close();

private:
  void check(const char* what_failed) const;

  const std::string path_;
  std::ofstream file_;
  std::ostream& stream_;
};
}  // namespace devo_evo
