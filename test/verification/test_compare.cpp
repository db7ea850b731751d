#include "devo_evo/verification/compare.h"

#include "archive/test_tools.h"

#include <gtest/gtest.h>

namespace devo_evo::test
{
namespace
{
class CompareTest : public testing::Test
{
protected:
  CompareTest()
  {
    for (const std::string& output : { a_.path(), b_.path() })
    {
      const ExperimentSettings settings = smallExperiment(output);
      const auto archive = openArchiveForWriting(settings, someProvenance());
      evolve(*archive, settings, 1, 10);
    }
  }

  ArchiveComparison compare() const
  {
    return compareArchives(*openArchiveForReading(a_.path()), *openArchiveForReading(b_.path()));
  }

  void editB(const std::string& sql) { openFile(b_.path(), SQLite::OPEN_READWRITE).exec(sql); }

  TemporaryFolder a_, b_;
};

TEST_F(CompareTest, equalExperimentsAreEqualWhateverMadeThem)
{
  editB("UPDATE starts SET processor = 'Difference Engine'");
  const ArchiveComparison comparison = compare();
  EXPECT_TRUE(comparison.equal());
  EXPECT_EQ(comparison.equal_generations, 11);
  ASSERT_EQ(comparison.provenance.size(), 1u);
  EXPECT_EQ(comparison.provenance[0].field, "processor");
}

TEST_F(CompareTest, namesTheFirstIndividualThatDiffersAndHow)
{
  editB("UPDATE individuals SET age = age - 1 WHERE trial = 1 AND id IN (18, 30) AND age > 0");
  editB("UPDATE individuals SET control_window = 17 WHERE trial = 1 AND id = 20");
  const ArchiveComparison comparison = compare();
  ASSERT_EQ(comparison.trials.size(), 1u);
  EXPECT_EQ(comparison.trials[0].generation, 2);  // 8 founders, then 9 newcomers a generation
  EXPECT_LE(comparison.trials[0].id, 20);
  EXPECT_EQ(comparison.equal_generations, 2);
}

TEST_F(CompareTest, namesASelectionThatDiffers)
{
  editB("UPDATE survivors SET id = id + 100 WHERE trial = 1 AND generation = 4 AND rank = 3");
  const ArchiveComparison comparison = compare();
  ASSERT_EQ(comparison.trials.size(), 1u);
  EXPECT_EQ(comparison.trials[0].id, -1);
  EXPECT_EQ(comparison.trials[0].generation, 4);
  EXPECT_EQ(comparison.trials[0].fields[0].field, "survivor of rank 3");
}

TEST_F(CompareTest, namesParametersGenomesAndExtents)
{
  const TemporaryFolder other;
  ExperimentSettings settings = smallExperiment(other.path());
  settings.evolution.seed = 2;
  evolve(*openArchiveForWriting(settings, someProvenance()), settings, 1, 3);
  const ArchiveComparison comparison =
      compareArchives(*openArchiveForReading(a_.path()), *openArchiveForReading(other.path()));
  ASSERT_EQ(comparison.parameters.size(), 1u);
  EXPECT_EQ(comparison.parameters[0].field, "seed");
  ASSERT_EQ(comparison.trials.size(), 1u);
  EXPECT_EQ(comparison.trials[0].id, 0);
  EXPECT_NE(comparison.trials[0].fields.back().field.find("[0] (the first of 4)"), std::string::npos);
  ASSERT_EQ(comparison.extents.size(), 1u);
  EXPECT_EQ(comparison.extents[0].generations_a, 11);
  EXPECT_EQ(comparison.extents[0].generations_b, 4);
}
}  // namespace
}  // namespace devo_evo::test
