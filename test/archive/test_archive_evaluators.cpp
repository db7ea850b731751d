#include "archive/test_tools.h"

#include <gtest/gtest.h>

namespace devo_evo::test
{
namespace
{
const Evaluator FIRST = { "laboratory", "Analytical Engine", "scalar", "1.2.3", 12 };
const Evaluator SECOND = { "library", "", "avx2", "1.2.3", 30 };

std::vector<Evaluator> evaluatorsOf(const std::string& output, size_t start)
{
  return openArchiveForReading(output)->starts().at(start).evaluators;
}

std::string describe(const std::vector<Evaluator>& evaluators)
{
  std::string text;
  for (const Evaluator& each : evaluators)
  {
    text += each.host + "|" + each.processor + "|" + each.instruction_set + "|" + each.version + "|" +
            std::to_string(each.evaluations) + "\n";
  }
  return text;
}

TEST(ArchiveEvaluators, areKeptByStartFromTheNextCommitOn)
{
  const TemporaryFolder folder;
  const ExperimentSettings settings = smallExperiment(folder.path());
  {
    const auto archive = openArchiveForWriting(settings, someProvenance());
    archive->noteEvaluators({ FIRST });
    EXPECT_EQ(describe(evaluatorsOf(folder.path(), 0)), "");
    evolve(*archive, settings, 1, 0);
    EXPECT_EQ(describe(evaluatorsOf(folder.path(), 0)), describe({ FIRST }));
    Evaluator more = FIRST;
    more.evaluations = 20;
    archive->noteEvaluators({ more, SECOND });  // written at the end
  }
  EXPECT_EQ(describe(evaluatorsOf(folder.path(), 0)),
            "laboratory|Analytical Engine|scalar|1.2.3|20\n" + describe({ SECOND }));
  openArchiveForWriting(settings, someProvenance())->noteEvaluators({ SECOND });
  EXPECT_EQ(evaluatorsOf(folder.path(), 0).size(), 2u);
  EXPECT_EQ(describe(evaluatorsOf(folder.path(), 1)), describe({ SECOND }));
}

TEST(ArchiveEvaluators, areNoPartOfTheDigest)
{
  const TemporaryFolder folder;
  const ExperimentSettings settings = smallExperiment(folder.path());
  evolve(*openArchiveForWriting(settings, someProvenance()), settings, 1, 3);
  const std::string digest = openArchiveForReading(folder.path())->digest();
  openArchiveForWriting(settings, someProvenance())->noteEvaluators({ FIRST, SECOND });
  EXPECT_EQ(openArchiveForReading(folder.path())->digest(), digest);
}

TEST(ArchiveEvaluators, areNoneInAnArchiveFromBeforeTheyWereKept)
{
  const TemporaryFolder folder;
  const ExperimentSettings settings = smallExperiment(folder.path());
  evolve(*openArchiveForWriting(settings, someProvenance()), settings, 1, 3);
  openFile(folder.path(), SQLite::OPEN_READWRITE).exec("DROP TABLE evaluators");
  EXPECT_TRUE(evaluatorsOf(folder.path(), 0).empty());
  EXPECT_FALSE(openArchiveForReading(folder.path())->findDamage());
  openArchiveForWriting(settings, someProvenance())->noteEvaluators({ FIRST });
  EXPECT_EQ(describe(evaluatorsOf(folder.path(), 1)), describe({ FIRST }));
}
}  // namespace
}  // namespace devo_evo::test
