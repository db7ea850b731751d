#pragma once

#include <fstream>
#include <ostream>
#include <string>

namespace devo_evo
{
/// Where results go, line by line. Whatever keeps them from being written is an error, never silent.
class ResultStream
{
public:
  /// @param path of a file, which is replaced; "-" for standard output.
  /// @param input that must not be overwritten.
  /// @throw InvalidInput if both are the same file; std::runtime_error if it cannot be written.
  ResultStream(const std::string& path, const std::string& input);

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
