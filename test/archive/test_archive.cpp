// What goes into an archive comes out of it: individuals, genomes, lineages, and where to go on.

#include "devo_evo/archive/archive.h"

#include "archive/test_tools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace devo_evo::test
{
namespace
{
constexpr int64_t TRIAL = 1;

/// Equal in all that is archived, to the last bit.
void expectSame(const Evaluation& archived, const Evaluation& made)
{
  EXPECT_EQ(archived.valid, made.valid);
  EXPECT_EQ(archived.first_top_contact_since_birth_s, made.first_top_contact_since_birth_s);
  EXPECT_EQ(archived.fell_over_since_birth_s, made.fell_over_since_birth_s);
  EXPECT_EQ(archived.state_hash, made.state_hash);
  EXPECT_TRUE(archived.velocity_body_lengths_per_s.empty());
  ASSERT_EQ(archived.divergence.has_value(), made.divergence.has_value());
  if (made.valid)
  {
    EXPECT_EQ(archived.fitness, made.fitness);
    EXPECT_EQ(archived.displacement_y_voxels, made.displacement_y_voxels);
    EXPECT_EQ(archived.displacement_xy_voxels, made.displacement_xy_voxels);
    EXPECT_EQ(archived.turns, made.turns);
    EXPECT_EQ(archived.airborne_fraction, made.airborne_fraction);
  }
  else
  {
    EXPECT_TRUE(std::isnan(archived.fitness));
    EXPECT_TRUE(std::isnan(archived.turns));
    EXPECT_EQ(archived.divergence->step, made.divergence->step);
    EXPECT_EQ(archived.divergence->bond, made.divergence->bond);
    EXPECT_EQ(archived.divergence->strain, made.divergence->strain);
  }
}

class ArchiveTest : public testing::Test
{
protected:
  /// Opens the archive, after closing it if it is open.
  void open()
  {
    archive_.reset();
    archive_ = openArchiveForWriting(settings_, someProvenance());
  }

  /// Evolves and remembers everybody who was ever born.
  void evolveTo(int64_t last_generation)
  {
    evolve(*archive_, settings_, TRIAL, last_generation,
           [this](const GenerationRecord& record, const Trial&)
           {
             last_ = record;
             for (const Individual& newcomer : record.newcomers)
             {
               born_[newcomer.id] = newcomer;
             }
           });
  }

  /// The ids of the living of the last generation and all their ancestors.
  std::set<int64_t> livingAndAncestors() const
  {
    std::set<int64_t> ids;
    for (int64_t id : last_.survivors)
    {
      for (; id != Individual::NO_PARENT; id = born_.at(id).parent)
      {
        ids.insert(id);
      }
    }
    return ids;
  }

  TemporaryFolder folder_;
  ExperimentSettings settings_ = smallExperiment(folder_.path() + "/made/for/this");
  std::unique_ptr<Archive> archive_;
  std::map<int64_t, Individual> born_;
  GenerationRecord last_;
};

TEST_F(ArchiveTest, everybodyWhoEverLivedIsReadBackToTheLastBit)
{
  open();
  evolveTo(30);
  const std::unique_ptr<Archive> reader = openArchiveForReading(settings_.output);
  const GenomeLayout layout = makeBody(settings_.body)->layout(settings_.evolution);
  int invalid = 0;
  for (const auto& [id, individual] : born_)
  {
    const ArchivedIndividual archived = reader->readIndividual(TRIAL, id);
    EXPECT_EQ(archived.individual.id, id);
    EXPECT_EQ(archived.individual.parent, individual.parent);
    EXPECT_EQ(archived.individual.generation, individual.generation);
    EXPECT_EQ(archived.individual.age, individual.age);
    EXPECT_EQ(archived.morphology_window, morphologyWindow(individual.genome.program, layout));
    EXPECT_EQ(archived.control_window, controlWindow(individual.genome.program, layout));
    expectSame(*archived.individual.evaluation, *individual.evaluation);
    invalid += individual.evaluation->valid ? 0 : 1;
  }
  EXPECT_GT(invalid, 0);
}

TEST_F(ArchiveTest, genomesAreKeptOfTheLivingAndTheirAncestorsOnly)
{
  open();
  evolveTo(40);
  std::set<int64_t> kept;
  SQLite::Database file = openFile(settings_.output);
  SQLite::Statement query(file, "SELECT id FROM genomes");
  while (query.executeStep())
  {
    kept.insert(query.getColumn(0).getInt64());
  }
  EXPECT_EQ(kept, livingAndAncestors());
  EXPECT_LT(kept.size(), born_.size() / 2);
}

TEST_F(ArchiveTest, genomesOfDeadBranchesAreMadeAgainByReplayingMutations)
{
  open();
  evolveTo(40);
  for (const auto& [id, individual] : born_)
  {
    const ArchivedIndividual archived = archive_->readIndividual(TRIAL, id);
    ASSERT_TRUE(archived.has_genome) << id;
    EXPECT_EQ(archived.individual.genome, individual.genome) << id;
  }
}

TEST_F(ArchiveTest, genomesOfBothTreatmentsAndAllMutationRatesAreKept)
{
  for (const Treatment treatment : { Treatment::EVO, Treatment::EVO_DEVO })
  {
    for (const std::optional<double> rate : { std::optional<double>(), std::optional<double>(0.25) })
    {
      settings_.evolution.treatment = treatment;
      settings_.evolution.mutation_rate = rate;
      settings_.output = folder_.path() + "/" + std::to_string(static_cast<int>(treatment)) + (rate ? "f" : "s");
      open();
      born_.clear();
      evolveTo(10);
      for (const int64_t id : last_.survivors)
      {
        EXPECT_EQ(archive_->readIndividual(TRIAL, id).individual.genome, born_[id].genome);
      }
      const bool develops = treatment == Treatment::EVO_DEVO;
      EXPECT_EQ(countRows(settings_.output, "genomes WHERE size_gene_final IS NULL") == 0, develops);
      EXPECT_EQ(countRows(settings_.output, "genomes WHERE mutation_rate IS NULL") == 0, !rate);
    }
  }
}

TEST_F(ArchiveTest, aGenomeOfADeadBranchThatAnotherVersionMakesDifferentlyIsNotGiven)
{
  open();
  evolveTo(10);
  const std::set<int64_t> kept = livingAndAncestors();
  int64_t dead = 0;
  while (kept.count(dead) != 0)
  {
    ++dead;
  }
  openFile(settings_.output, SQLite::OPEN_READWRITE)
      .exec("UPDATE individuals SET genome_hash = zeroblob(16) WHERE id = " + std::to_string(dead));
  const ArchivedIndividual archived = archive_->readIndividual(TRIAL, dead);
  EXPECT_FALSE(archived.has_genome);
  EXPECT_TRUE(archived.individual.genome.program.morphology_initial.empty());
}

TEST_F(ArchiveTest, aLineageLeadsFromTheOldestAncestorToTheIndividual)
{
  open();
  evolveTo(30);
  const int64_t champion = archive_->championOf(TRIAL);
  EXPECT_EQ(champion, last_.champion);
  const std::vector<ArchivedIndividual> lineage = archive_->readLineage(TRIAL, champion);
  ASSERT_GT(lineage.size(), 2u);
  EXPECT_EQ(lineage.front().individual.parent, Individual::NO_PARENT);
  EXPECT_EQ(lineage.back().individual.id, champion);
  for (size_t i = 1; i < lineage.size(); ++i)
  {
    EXPECT_EQ(lineage[i].individual.parent, lineage[i - 1].individual.id);
    EXPECT_EQ(lineage[i].individual.genome, born_[lineage[i].individual.id].genome);
  }
}

TEST_F(ArchiveTest, anEvaluationIsFoundByPhenotypeInEveryTrial)
{
  open();
  evolveTo(5);
  evolve(*archive_, settings_, 2, 3);
  for (const auto& [id, individual] : born_)
  {
    const auto found = archive_->findEvaluation(phenotypeHash(individual.genome.program));
    ASSERT_TRUE(found) << id;
    expectSame(*found, *individual.evaluation);
  }
  EXPECT_FALSE(archive_->findEvaluation(Hash128{ 1, 2, 3 }));
}

TEST_F(ArchiveTest, aTrialGoesOnWhereItWasCommitted)
{
  open();
  evolveTo(7);
  open();
  const TrialState state = archive_->trialStates().at(TRIAL);
  EXPECT_EQ(state.generation, 7);
  EXPECT_EQ(state.next_id, born_.rbegin()->first + 1);
  ASSERT_EQ(state.survivors.size(), last_.survivors.size());
  for (size_t i = 0; i < state.survivors.size(); ++i)
  {
    const Individual& survivor = state.survivors[i];
    const Individual& newborn = born_[survivor.id];
    EXPECT_EQ(survivor.id, last_.survivors[i]);
    EXPECT_EQ(survivor.age, newborn.age + 7 - newborn.generation);
    EXPECT_EQ(survivor.genome, newborn.genome);
    expectSame(*survivor.evaluation, *newborn.evaluation);
  }
}

TEST_F(ArchiveTest, aResumedTrialEndsAsAnUndisturbedOne)
{
  open();
  evolveTo(25);
  const std::string undisturbed = archive_->digest();

  settings_.output += "/again";
  for (const int64_t generation : { 0, 3, 4, 25 })
  {
    open();
    evolveTo(generation);
  }
  EXPECT_EQ(archive_->digest(), undisturbed);
}

TEST_F(ArchiveTest, severalTrialsStandSideBySide)
{
  open();
  for (int64_t generation = 0; generation < 4; ++generation)
  {
    for (const int64_t trial : { 3, 1, 2 })
    {
      evolve(*archive_, settings_, trial, generation);
    }
  }
  EXPECT_EQ(archive_->trials(), (std::vector<int64_t>{ 1, 2, 3 }));
  EXPECT_EQ(archive_->trialStates().size(), 3u);
  EXPECT_FALSE(archive_->readIndividual(1, 0).individual.genome == archive_->readIndividual(2, 0).individual.genome);
}

TEST_F(ArchiveTest, aGenerationWithoutAnyValidRobotHasNoNumbers)
{
  open();
  Trial trial(settings_.evolution, *makeBody(settings_.body), TRIAL);
  for (const int64_t id : trial.awaiting())
  {
    Evaluation diverged;
    diverged.divergence = Divergence{ 1, 0, std::numeric_limits<double>::infinity() };
    trial.setEvaluation(id, diverged);
  }
  archive_->commitGeneration(trial.select());
  EXPECT_EQ(countRows(settings_.output, "generations WHERE best_fitness IS NULL AND median_fitness IS NULL"), 1);
  EXPECT_EQ(countRows(settings_.output, "individuals WHERE valid = 0 AND fitness IS NULL AND state_hash IS NULL"), 8);
  const Evaluation evaluation = *archive_->readIndividual(TRIAL, 0).individual.evaluation;
  EXPECT_FALSE(evaluation.valid);
  EXPECT_TRUE(std::isinf(evaluation.divergence->strain));
}

TEST_F(ArchiveTest, generationsOfSeveralTrialsAreCommittedTogetherOrNotAtAll)
{
  open();
  std::vector<GenerationRecord> records;
  for (const int64_t number : { 1, 2, 3 })
  {
    Trial trial(settings_.evolution, *makeBody(settings_.body), number);
    evaluateAll(trial);
    records.push_back(trial.select());
  }
  std::vector<GenerationRecord> flawed = records;
  flawed.back().newcomers.front().evaluation.reset();
  EXPECT_THROW(archive_->commitGenerations(flawed), std::logic_error);
  EXPECT_TRUE(archive_->trials().empty());
  archive_->commitGenerations(records);
  EXPECT_EQ(archive_->trials(), (std::vector<int64_t>{ 1, 2, 3 }));
}

TEST_F(ArchiveTest, onlyTheNextGenerationOfATrialIsTaken)
{
  open();
  evolveTo(2);
  Trial trial = beginOrResume(*archive_, settings_, TRIAL);
  evaluateAll(trial);
  const GenerationRecord next = trial.select();
  EXPECT_THROW(archive_->commitGeneration(last_), std::logic_error);
  archive_->commitGeneration(next);
  EXPECT_THROW(archive_->commitGeneration(next), std::logic_error);

  GenerationRecord unevaluated = next;
  ++unevaluated.generation;
  unevaluated.newcomers.front().evaluation.reset();
  EXPECT_THROW(archive_->commitGeneration(unevaluated), std::logic_error);
  EXPECT_EQ(archive_->trialStates().at(TRIAL).generation, 3);
}

TEST_F(ArchiveTest, whoeverIsNotThereIsNamed)
{
  open();
  evolveTo(1);
  EXPECT_NE(messageOf<InvalidInput>([&] { archive_->readIndividual(3, 1042); }).find("3/1042"), std::string::npos);
  EXPECT_NE(messageOf<InvalidInput>([&] { archive_->readLineage(TRIAL, 9999); }).find("1/9999"), std::string::npos);
  EXPECT_NE(messageOf<InvalidInput>([&] { archive_->championOf(2); }).find("trial 2"), std::string::npos);
}
}  // namespace
}  // namespace devo_evo::test
