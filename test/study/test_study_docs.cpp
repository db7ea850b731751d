// docs/study.md says what is true: its tables have the columns that study.db has, and its query runs.
#include "study/study_tools.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace devo_evo::test
{
namespace
{
std::string page()
{
  std::ostringstream text;
  text << std::ifstream(PROJECT_DIR "/docs/study.md").rdbuf();
  return text.str();
}

/// Names in `code` in the first column of the section's tables.
std::set<std::string> documentedColumns(const std::string& table)
{
  const std::string text = page();
  const size_t begin = text.find("\n### " + table + "\n");
  const std::string section = text.substr(begin, text.find("\n##", begin + 1) - begin);
  std::set<std::string> columns;
  std::istringstream lines(section);
  for (std::string line; std::getline(lines, line);)
  {
    const std::string first_cell = line.substr(0, line.find('|', 1));
    const std::regex code("`(\\w+)`");
    for (std::sregex_iterator name(first_cell.begin(), first_cell.end(), code); name != std::sregex_iterator(); ++name)
    {
      columns.insert((*name)[1]);
    }
  }
  return columns;
}

class StudyPageTest : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    folder = new TemporaryFolder;
    Parameters study = smallStudy(folder->path());
    study.study.only = { StudyPart::MAIN, StudyPart::REMOVED };
    runSmall(study);
  }
  static void TearDownTestSuite() { delete folder; }

  static inline TemporaryFolder* folder = nullptr;
};

TEST_F(StudyPageTest, describesEveryColumnOfEveryTable)
{
  SQLite::Database database = openStudy(folder->path());
  SQLite::Statement tables(database, "SELECT name FROM sqlite_master WHERE type = 'table'");
  int described = 0;
  while (tables.executeStep())
  {
    const std::string table = tables.getColumn(0).getString();
    if (table == "parameters" || table == "starts")  // as in docs/archive.md
    {
      continue;
    }
    std::set<std::string> columns;
    SQLite::Statement info(database, "SELECT name FROM pragma_table_info('" + table + "')");
    while (info.executeStep())
    {
      columns.insert(info.getColumn(0).getString());
    }
    EXPECT_EQ(columns, documentedColumns(table)) << table;
    ++described;
  }
  EXPECT_EQ(described, 11);
}

TEST_F(StudyPageTest, namesViewsThatCanBeRead)
{
  SQLite::Database database = openStudy(folder->path());
  SQLite::Statement views(database, "SELECT name FROM sqlite_master WHERE type = 'view'");
  const std::string text = page();
  int count = 0;
  while (views.executeStep())
  {
    const std::string view = views.getColumn(0).getString();
    EXPECT_NE(text.find("`" + view + "`"), std::string::npos) << view;
    EXPECT_NO_THROW(database.execAndGet("SELECT count(*), sum(fitness) FROM " + view)) << view;
    ++count;
  }
  EXPECT_EQ(count, 5);
}

TEST_F(StudyPageTest, hasAQueryThatFindsEveryRemovedChampion)
{
  const std::string text = page();
  const size_t begin = text.find("```sql\n") + 7;
  SQLite::Database database = openStudy(folder->path());
  SQLite::Statement rows(database, text.substr(begin, text.find("```", begin) - begin));
  int found = 0;
  while (rows.executeStep())
  {
    ++found;
  }
  EXPECT_EQ(found, 2);
}

TEST_F(StudyPageTest, describesEveryPart)
{
  for (const StudyPart part : studyParts())
  {
    EXPECT_NE(page().find("\n| `" + toString(part) + "` | "), std::string::npos) << toString(part);
  }
}
}  // namespace
}  // namespace devo_evo::test
