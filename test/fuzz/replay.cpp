// Feeds the files of a corpus to a fuzz target, once each, without a fuzzer.

#include "fuzz/input.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <vector>

int main(int argc, char** argv)
{
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i)
  {
    for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& path : files)
  {
    std::cout << path.filename().string() << std::endl;  // flushed: the last name printed is the one that failed
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
    LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
  }
  if (files.empty())
  {
    std::cerr << "there are no inputs to replay" << std::endl;
    return 1;
  }
  return 0;
}
