#include "devo_evo/explanation/explanation.h"
#include "devo_evo/bodies/bodies.h"

#include "archive/test_tools.h"
#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/experiment/parameters.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>

namespace devo_evo::test
{
namespace
{
/// What is said of a name under a label; "" if nothing.
std::string factOf(const std::string& name, const std::string& label)
{
  for (const Explanation& explanation : explain(name))
  {
    for (const auto& [title, text] : explanation.facts)
    {
      if (title == label)
      {
        return text;
      }
    }
  }
  return "";
}

void expectExplained(const std::string& name)
{
  try
  {
    EXPECT_NE(factOf(name, "Meaning"), "") << name;
  }
  catch (const InvalidInput& error)
  {
    ADD_FAILURE() << error.what();
  }
}

TEST(Explanation, ofFitnessTellsMeaningUnitAndFormula)
{
  EXPECT_EQ(factOf("fitness", "Unit"), "body lengths");
  EXPECT_EQ(factOf("fitness", "Formula"), "(y(T₀ + τ) − y(T₀)) / (L n_y)");
  EXPECT_GE(explain("fitness").size(), 3u);  // as a measure, as a column, in a message
}

TEST(Explanation, everyColumnOfTheArchiveHasOne)
{
  const TemporaryFolder folder;
  openArchiveForWriting(smallExperiment(folder.path()), someProvenance());
  SQLite::Database file = openFile(folder.path());
  SQLite::Statement columns(file,
                            "SELECT m.name || '.' || c.name FROM sqlite_master AS m, pragma_table_info(m.name) AS "
                            "c WHERE m.type IN ('table', 'view')");
  int count = 0;
  while (columns.executeStep())
  {
    expectExplained(columns.getColumn(0).getString());
    ++count;
  }
  EXPECT_GT(count, 50);
}

TEST(Explanation, everyParameterHasOne)
{
  for (const ParameterSpec& spec : parameterSpecs())
  {
    expectExplained(spec.name);
  }
}

TEST(Explanation, everyFieldOfMessagesAndServicesHasOne)
{
  const std::regex field(R"(^[\w/\[\]]+ +(\w+)( *=.*)?$)");
  int count = 0;
  for (const char* folder : { "/msg", "/srv" })
  {
    for (const auto& entry : std::filesystem::directory_iterator(std::string(PROJECT_DIR) + folder))
    {
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);)
      {
        std::smatch match;
        if (std::regex_match(line, match, field))
        {
          expectExplained(entry.path().stem().string() + "." + match[1].str());
          ++count;
        }
      }
    }
  }
  EXPECT_GT(count, 80);
}

TEST(Explanation, everyFieldOfAnEvaluationInJsonHasOne)
{
  Evaluation evaluation;
  evaluation.divergence = Divergence{ 1, 2, 3.0 };
  const auto json =
      nlohmann::json::parse(evaluationToJson(int64_t{ 1 }, evaluation, *makeSoftBody(SoftBodySettings())));
  for (const auto& [name, value] : json.items())
  {
    expectExplained(name);
  }
}

TEST(Explanation, ofWhatIsNotThereNamesTheMostSimilar)
{
  const std::string complaint = messageOf<InvalidInput>([] { explain("fitnes"); });
  EXPECT_NE(complaint.find("the most similar is fitness"), std::string::npos) << complaint;
}
}  // namespace
}  // namespace devo_evo::test
