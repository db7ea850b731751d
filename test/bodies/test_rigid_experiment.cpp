// Evolution of the rigid quadruped through farm and archive.

#include "devo_evo/experiment/experiment.h"
#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/experiment/parameters.h"
#include "devo_evo/farm/local_farm.h"
#include "devo_evo/verification/compare.h"
#include "devo_evo/verification/verify.h"

#include "archive/test_tools.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace devo_evo::test
{
namespace
{
class SilentObserver : public ExperimentObserver
{
public:
  void generationCommitted(const GenerationReport& /*report*/) override {}
};

ExperimentSettings shortExperiment(const std::string& output)
{
  ExperimentSettings settings;
  settings.body.kind = BodyKind::RIGID;
  settings.body.rigid.lifetime = 1.0;
  settings.evolution.population = 4;
  settings.generations = 3;
  settings.output = output;
  return settings;
}

void run(const ExperimentSettings& settings, int threads = 2)
{
  const auto archive = openArchiveForWriting(settings, someProvenance());
  const auto farm = makeLocalFarm(makeBody(settings.body), threads);
  SilentObserver observer;
  EXPECT_EQ(Experiment(settings, *archive, *farm, observer).run(), RunOutcome::FINISHED);
}

std::string digestOf(const std::string& output)
{
  return openArchiveForReading(output)->digest();
}

TEST(RigidExperiment, EvolvesTheSameWithAnyNumberOfThreadsAndAfterAnInterruption)
{
  const TemporaryFolder one, three, interrupted;
  run(shortExperiment(one.path()), 1);
  run(shortExperiment(three.path()), 3);
  EXPECT_EQ(digestOf(one.path()), digestOf(three.path()));
  ExperimentSettings settings = shortExperiment(interrupted.path());
  settings.generations = 1;
  run(settings);
  settings.generations = 3;
  run(settings);
  EXPECT_EQ(digestOf(one.path()), digestOf(interrupted.path()));
}

TEST(RigidExperiment, TheArchiveGivesBackWhatWasEvolvedAndWhatItDid)
{
  const TemporaryFolder folder;
  const ExperimentSettings settings = shortExperiment(folder.path());
  run(settings);
  const auto archive = openArchiveForReading(folder.path());
  EXPECT_EQ(archive->settings().body.kind, BodyKind::RIGID);
  EXPECT_EQ(archive->settings().body.rigid.lifetime, 1.0);
  const std::shared_ptr<const Body> body = makeBody(settings.body);
  const auto champion = bestChampion(*archive);
  ASSERT_TRUE(champion && champion->has_genome);
  const Evaluation& archived = *champion->individual.evaluation;
  const Evaluation again = body->evaluate({ champion->individual.genome.program }, InstructionSet::SCALAR).front();
  EXPECT_EQ(again.state_hash, archived.state_hash);
  EXPECT_EQ(again.fitness, archived.fitness);
  for (const Measure& measure : body->measures())
  {
    const double a = measure.get(again), b = measure.get(archived);
    EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << measure.name;
  }
  EXPECT_EQ(countRows(folder.path(), "individuals WHERE descent IS NULL OR leg_contact IS NULL"), 0);
  EXPECT_EQ(countRows(folder.path(), "genomes WHERE length(leg_length_initial) <> 32 OR length(weight_initial) <> 64"),
            0);
}

TEST(RigidExperiment, IsVerifiedAndEqualsItsRepetition)
{
  const TemporaryFolder a, b;
  run(shortExperiment(a.path()));
  run(shortExperiment(b.path()));
  const auto archive = openArchiveForReading(a.path());
  const auto farm = makeLocalFarm(makeBody(archive->settings().body), 2);
  VerificationScope scope;
  scope.all = true;
  const Verification found = verify(*archive, scope, *farm, [](const Verification&) { return true; });
  EXPECT_FALSE(found.offence) << found.offence->what;
  EXPECT_EQ(found.simulated, found.individuals);
  const ArchiveComparison comparison = compareArchives(*archive, *openArchiveForReading(b.path()));
  EXPECT_TRUE(comparison.parameters.empty() && comparison.trials.empty() && comparison.extents.empty());
}

TEST(RigidExperiment, AChangedMeasureIsFoundByVerification)
{
  const TemporaryFolder folder;
  run(shortExperiment(folder.path()));
  openFile(folder.path(), SQLite::OPEN_READWRITE).exec("UPDATE individuals SET descent = descent + 0.001 WHERE id = 2");
  const auto archive = openArchiveForReading(folder.path());
  const auto farm = makeLocalFarm(makeBody(archive->settings().body), 2);
  VerificationScope scope;
  scope.all = true;
  const Verification found = verify(*archive, scope, *farm, [](const Verification&) { return true; });
  ASSERT_TRUE(found.offence);
  EXPECT_EQ(found.offence->what.find("descent is "), 0u) << found.offence->what;
}

TEST(RigidExperiment, IsNotResumedWithAnotherBodyOrAnotherSlope)
{
  const TemporaryFolder folder;
  run(shortExperiment(folder.path()));
  ExperimentSettings soft = smallExperiment(folder.path());
  EXPECT_NE(messageOf<ArchiveError>([&] { openArchiveForWriting(soft, someProvenance()); })
                .find("body is rigid there and soft here"),
            std::string::npos);
  ExperimentSettings steep = shortExperiment(folder.path());
  steep.body.rigid.slope = 4.0;
  EXPECT_NE(messageOf<ArchiveError>([&] { openArchiveForWriting(steep, someProvenance()); })
                .find("rigid_slope is 3 there and 4 here"),
            std::string::npos);
}

TEST(RigidExperiment, ParametersOfTheOtherBodyAreRefused)
{
  ExperimentSettings settings = shortExperiment("/tmp");
  settings.body.soft.lifetime = 5.0;
  EXPECT_EQ(messageOf<InvalidInput>([&] { settings.validate(); }),
            "lifetime is 5, but it is a parameter of soft bodies, and body is rigid; leave it at 10");
  ExperimentSettings soft;
  soft.output = "/tmp";
  soft.body.rigid.slope = 5.0;
  EXPECT_EQ(messageOf<InvalidInput>([&] { soft.validate(); }),
            "rigid_slope is 5, but it is a parameter of rigid bodies, and body is soft; leave it at 3");
}

TEST(RigidExperiment, FoundersOfTheOtherBodyAreRefused)
{
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/founders.jsonl";
  const std::shared_ptr<const Body> soft = makeSoftBody(SoftBodySettings());
  const EvolutionSettings evolution;
  std::ofstream(path) << robotToJson(std::string("soft"),
                                     bornGenome(evolution, soft->layout(evolution), 1, 0, 0, nullptr), *soft)
                      << "\n";
  ExperimentSettings settings = shortExperiment(folder.path());
  settings.founders = path;
  EXPECT_NE(messageOf<InvalidInput>([&] { loadFounders(settings); })
                .find("founders.jsonl, line 1, robot \"soft\": body is \"soft\", and the parameter body is rigid"),
            std::string::npos);
}

TEST(RigidExperiment, StartsWithGivenFounders)
{
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/founders.jsonl";
  std::ofstream(path) << R"({"id":"a","body":"rigid","leg_length_initial":[1,1,1,1],"leg_length_final":[0,0,0,0],)"
                      << R"("weight_initial":[0,0,0,0,0,0,0,0]})"
                      << "\n";
  ExperimentSettings settings = shortExperiment(folder.path());
  settings.founders = path;
  loadFounders(settings);
  run(settings);
  const ArchivedIndividual first = openArchiveForReading(folder.path())->readIndividual(1, 0);
  EXPECT_EQ(first.morphology_window, 1.0);
  EXPECT_EQ(first.control_window, 0.0);
}

TEST(RigidJson, ARobotReadsBackAsItWas)
{
  const std::shared_ptr<const Body> body = makeRigidBody(RigidBodySettings());
  const EvolutionSettings settings;
  const Genome genome = bornGenome(settings, body->layout(settings), 1, 0, 0, nullptr);
  std::istringstream input(robotToJson(int64_t{ 7 }, genome, *body) + "\n");
  const auto robot = RobotReader(input, "robots", *body).next();
  ASSERT_TRUE(robot);
  EXPECT_EQ(robot->genome, genome);
}

TEST(RigidJson, ARobotOfTheOtherBodyIsRefusedEvenIfItDoesNotSaySo)
{
  const std::shared_ptr<const Body> soft = makeSoftBody(SoftBodySettings());
  std::istringstream input(R"({"id":1,"leg_length_initial":[1,1,1,1],"weight_initial":[0,0,0,0,0,0,0,0]})");
  RobotReader reader(input, "robots", *soft);
  EXPECT_EQ(
      messageOf<InvalidInput>([&] { reader.next(); }),
      "robots, line 1, robot 1: it is a robot with a rigid body, since it has leg_length_initial, and the parameter "
      "body is soft; a robot of that kind of body is needed, or the other parameter");
}

/// The best fitness of a run with this selection.
double bestOf(Selection selection, const ExperimentSettings& given)
{
  const TemporaryFolder folder;
  ExperimentSettings settings = given;
  settings.output = folder.path();
  settings.evolution.selection = selection;
  run(settings);
  return bestChampion(*openArchiveForReading(folder.path()))->individual.evaluation->fitness;
}

TEST(RigidEvolution, FindsBrighterPlacesThanRandomSearchWithTheSameBudget)
{
  int wins = 0;
  for (const int64_t seed : { 1, 2, 3 })
  {
    ExperimentSettings settings = shortExperiment("");
    settings.body.rigid.lifetime = 3.0;
    settings.evolution.population = 8;
    settings.evolution.seed = seed;
    settings.generations = 25;
    const double evolved = bestOf(Selection::AFPO, settings);
    const double drawn = bestOf(Selection::RANDOM_SEARCH, settings);
    wins += evolved > drawn ? 1 : 0;
  }
  EXPECT_GE(wins, 2);
}
}  // namespace
}  // namespace devo_evo::test
