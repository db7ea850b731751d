#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <sys/types.h>

namespace devo_evo
{
/// A program that reads what it is given on its standard input. Its standard output is discarded; what it writes to
/// standard error is kept. It is in a process group of its own, so that Ctrl-C reaches it only through us.
class ChildProcess
{
public:
  /// @param program looked up in PATH. @throw PictureError if it cannot be started.
  ChildProcess(const std::string& program, const std::vector<std::string>& arguments);

  /// Ends it.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// @return false if it does not read any more.
  bool write(const void* data, size_t size);

  /// Tells it that this was all, and waits. @return its exit status, or 128 plus the signal that ended it.
  int finish();

  void kill();

  /// What it wrote to standard error; at most the first few lines.
  std::string complaints() const;

private:
  void closeInput();

  pid_t pid_ = -1;
  int input_ = -1, errors_ = -1;
  int status_ = 0;
};

/// Whether PATH leads to such a program.
bool isInstalled(const std::string& program);

/// Whether files can be made in a folder; errno says why not.
bool canWriteInto(const std::string& folder);
}  // namespace devo_evo
