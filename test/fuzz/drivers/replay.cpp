// Feeds a corpus to a fuzz target, once each, without a fuzzer. What lies in its folder `valid` must be accepted, what
// lies in `invalid` refused: so a corpus that has grown old is noticed.

#include "fuzz/input.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <vector>

namespace
{
using namespace devo_evo;
namespace fs = std::filesystem;

std::vector<fs::path> filesIn(const fs::path& folder)
{
  std::vector<fs::path> files;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing))
  {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string contentOf(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// @return how many were taken for what they are not, or 1 if there are none.
int replay(const fs::path& folder, bool valid)
{
  const std::vector<fs::path> files = filesIn(folder);
  if (files.empty())
  {
    std::cerr << "there are no inputs in " << folder.string() << std::endl;
    return 1;
  }
  int wrong = 0;
  for (const fs::path& path : files)
  {
    std::cout << path.string() << ": " << std::flush;  // the last name printed is the one that failed
    const std::string bytes = contentOf(path);
    const fuzz::Refusal refusal = fuzz::handle(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
    std::cout << (refusal ? "refused: " + *refusal : "accepted") << std::endl;
    if (refusal.has_value() == valid)
    {
      std::cerr << path.string() << " must be " << (valid ? "accepted" : "refused")
                << "; if formats have changed, write the corpus anew (docs/robustness.md)" << std::endl;
      ++wrong;
    }
  }
  return wrong;
}
}  // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " FOLDER" << std::endl;
    return 2;
  }
  const fs::path corpus = argv[1];
  return replay(corpus / "valid", true) + replay(corpus / "invalid", false) == 0 ? 0 : 1;
}
