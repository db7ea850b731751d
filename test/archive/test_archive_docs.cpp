// docs/archive.md says what is true: its queries run, its columns exist, its digest is ours.

#include "devo_evo/archive/archive.h"

#include "archive/test_tools.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace devo_evo::test
{
namespace
{
std::string page()
{
  std::ostringstream text;
  text << std::ifstream(PROJECT_DIR "/docs/archive.md").rdbuf();
  return text.str();
}

/// The blocks of code in a language.
std::vector<std::string> blocks(const std::string& language)
{
  const std::string text = page();
  const std::string opening = "\n```" + language + "\n";
  std::vector<std::string> found;
  for (size_t begin = text.find(opening); begin != std::string::npos; begin = text.find(opening, begin))
  {
    begin += opening.size();
    found.push_back(text.substr(begin, text.find("```", begin) - begin));
  }
  return found;
}

std::string outputOf(const std::string& command)
{
  std::string output;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 256> part;
  while (pipe && fgets(part.data(), part.size(), pipe))
  {
    output += part.data();
  }
  return pipe && pclose(pipe) == 0 ? output : "failed: " + command;
}

class ArchivePageTest : public testing::Test
{
protected:
  ArchivePageTest()
  {
    const auto archive = openArchiveForWriting(settings_, someProvenance());
    evolve(*archive, settings_, 1, 20);
    evolve(*archive, settings_, 2, 20);
    digest_ = archive->digest();
  }

  TemporaryFolder folder_;
  ExperimentSettings settings_ = smallExperiment(folder_.path());
  std::string digest_;
};

TEST_F(ArchivePageTest, everyQueryRunsAndFindsSomething)
{
  const std::vector<std::string> queries = blocks("sql");
  EXPECT_GE(queries.size(), 5u);
  SQLite::Database file = openFile(settings_.output);
  for (const std::string& query : queries)
  {
    SQLite::Statement statement(file, query);
    EXPECT_TRUE(statement.executeStep()) << query;
  }
}

TEST_F(ArchivePageTest, everyTableAndColumnIsDescribed)
{
  const std::string text = page();
  SQLite::Database file = openFile(settings_.output);
  SQLite::Statement columns(file,
                            "SELECT m.name, c.name FROM sqlite_master AS m, pragma_table_info(m.name) AS c "
                            "WHERE m.type IN ('table', 'view')");
  int count = 0;
  while (columns.executeStep())
  {
    const std::string table = columns.getColumn(0).getString();
    const size_t section = text.find("\n### " + table + "\n");
    ASSERT_NE(section, std::string::npos) << table;
    const std::string description = text.substr(section, text.find("\n### ", section + 1) - section);
    EXPECT_NE(description.find("`" + columns.getColumn(1).getString() + "`"), std::string::npos)
        << table << "." << columns.getColumn(1).getString();
    ++count;
  }
  EXPECT_GT(count, 40);
}

TEST_F(ArchivePageTest, theDigestInPythonIsOurs)
{
  const std::vector<std::string> scripts = blocks("python");
  ASSERT_EQ(scripts.size(), 1u);
  const std::string script = settings_.output + "/digest.py";
  std::ofstream(script) << scripts.front();
  EXPECT_EQ(outputOf("/usr/bin/python3 " + script + " " + settings_.output), digest_ + "\n");
}
}  // namespace
}  // namespace devo_evo::test
