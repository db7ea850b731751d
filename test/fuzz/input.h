#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace devo_evo::fuzz
{
/// Why an input is refused; none if it is accepted.
using Refusal = std::optional<std::string>;

/// What every fuzz target defines: handles one input. Anything but a return is a finding.
Refusal handle(const uint8_t* data, size_t size);

/// Ends the program loudly where a promise is broken that no sanitizer knows of.
inline void require(bool promise)
{
  if (!promise)
  {
    std::abort();
  }
}

/// A folder of this process's own, gone at its end.
class ScratchFolder
{
public:
  ScratchFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "devo_evo_fuzz_XXXXXX").string();
    require(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~ScratchFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }

  /// Makes a file of the folder hold the input and nothing else. @return its path.
  std::string write(const std::string& name, const uint8_t* data, size_t size) const
  {
    const std::string path = path_ + "/" + name;
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    file.close();
    require(file.good());
    return path;
  }

private:
  std::string path_;
};
}  // namespace devo_evo::fuzz
