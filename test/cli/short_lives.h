#pragma once

#include "archive/test_tools.h"
#include "cli/tool_process.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace devo_evo
{
/// Has the tool evolve robots of four voxels that live for 0.1 s: two trials of five generations in a fraction of a
/// second. @param changed options instead of these, or besides.
inline void evolveShortLives(const std::string& output, const std::map<std::string, std::string>& changed = {})
{
  std::map<std::string, std::string> options = { { "grid", "2x2x1" }, { "lifetime", "0.1" }, { "population", "4" },
                                                 { "trials", "2" },   { "seed", "3" },       { "generations", "5" },
                                                 { "output", output } };
  for (const auto& [name, value] : changed)
  {
    options[name] = value;
  }
  std::vector<std::string> words = { "evolve" };
  for (const auto& [name, value] : options)
  {
    words.insert(words.end(), { "--" + name, value });
  }
  const ToolResult result = runTool(words);
  ASSERT_EQ(result.status, 0) << result.err;
}

/// A test with a copy of one experiment of short lives, to do with as it likes.
class ShortLives : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    const TemporaryFolder folder;
    ASSERT_NO_FATAL_FAILURE(evolveShortLives(folder.file("original")));
    original = contentOf(archivePath(folder.file("original")));
  }

  ShortLives() { restore(output_); }

  static void restore(const std::string& output)
  {
    std::filesystem::create_directory(output);
    std::ofstream(archivePath(output), std::ios::binary | std::ios::trunc) << original;
  }

  static void edit(const std::string& output, const std::string& sql)
  {
    test::openFile(output, SQLite::OPEN_READWRITE).exec(sql);
  }

  static int64_t numberIn(const std::string& output, const std::string& sql)
  {
    return test::openFile(output).execAndGet(sql).getInt64();
  }

  static std::string textIn(const std::string& output, const std::string& sql)
  {
    return test::openFile(output).execAndGet(sql).getString();
  }

  static inline std::string original;
  const TemporaryFolder folder_;
  const std::string output_ = folder_.file("experiment");
};

inline ::testing::AssertionResult contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << text;
}
}  // namespace devo_evo
