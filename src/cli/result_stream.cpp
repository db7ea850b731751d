#include "cli/result_stream.h"

#include "devo_evo/soft_body/settings.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace devo_evo
{
ResultStream::ResultStream(const std::string& path, const std::vector<std::string>& others)
  : path_(path), stream_(path == "-" ? std::cout : file_)
{
  if (path == "-")
  {
    return;
  }
  for (const std::string& other : others)
  {
    std::error_code ignored;
    if (std::filesystem::equivalent(path, other, ignored))
    {
      throw InvalidInput(path + " is read or written by this command already; another file is needed");
    }
  }
  file_.open(path, std::ios::binary | std::ios::trunc);
  check("opened");
}

void ResultStream::writeLine(const std::string& line)
{
  stream_ << line << '\n';
  check("written");
}

void ResultStream::flush()
{
  stream_.flush();
  check("written");
}

void ResultStream::close()
{
  flush();
  if (path_ != "-")
  {
    file_.close();
    check("written");
  }
}

void ResultStream::check(const char* what_failed) const
{
  if (!stream_)
  {
    throw std::runtime_error((path_ == "-" ? "standard output" : path_) + " cannot be " + what_failed + ": " +
                             std::strerror(errno));
  }
}
}  // namespace devo_evo
