#include "devo_evo/interchange/phylogeny.h"

#include "archive/test_tools.h"
#include "devo_evo/interchange/traces.h"
#include "devo_evo/soft_body/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace devo_evo::test
{
namespace
{
Descendant individual(int64_t id, int64_t parent, int64_t generation, std::optional<int64_t> death)
{
  Descendant descendant;
  Individual& robot = descendant.archived.individual;
  robot.trial = 1;
  robot.id = id;
  robot.parent = parent;
  robot.generation = generation;
  robot.age = generation;
  robot.evaluation = Evaluation();
  robot.evaluation->valid = true;
  robot.evaluation->fitness = 0.5;
  descendant.death = death;
  return descendant;
}

/// 0 has the children 2 and 3, 2 has 5; 4 is random, and alone.
const std::vector<Descendant> FAMILY = { individual(0, Individual::NO_PARENT, 0, 3), individual(2, 0, 1, 2),
                                         individual(3, 0, 2, std::nullopt), individual(4, Individual::NO_PARENT, 2, 2),
                                         individual(5, 2, 4, std::nullopt) };

template <class Writer>
std::vector<std::string> linesOf(Writer writer, const std::vector<Descendant>& descendants)
{
  std::vector<std::string> lines;
  writer(descendants, [&lines](const std::string& line) { lines.push_back(line); });
  return lines;
}

using TableWriter = void (*)(const std::vector<Descendant>&, const Body&, const LineSink&);

std::vector<std::string> tableOf(TableWriter writer, const std::vector<Descendant>& descendants)
{
  const std::shared_ptr<const Body> body = makeSoftBody(SoftBodySettings());
  const auto write = [&](const std::vector<Descendant>& individuals, const LineSink& sink)
  { writer(individuals, *body, sink); };
  return linesOf(write, descendants);
}

std::vector<std::string> fieldsOf(const std::string& line)
{
  std::vector<std::string> fields;
  for (size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1)
  {
    end = line.find(',', begin);
    fields.push_back(line.substr(begin, end - begin));
  }
  return fields;
}

TEST(Phylogeny, newickHasATreeForEachRandomIndividualAndBranchesInGenerations)
{
  EXPECT_EQ(linesOf(writeNewick, FAMILY), (std::vector<std::string>{ "((1/5:3)1/2:1,1/3:2)1/0:0;", "1/4:2;" }));
}

TEST(Phylogeny, newickOfAVeryLongLineageTakesNoDeepStack)
{
  std::vector<Descendant> lineage;
  for (int64_t id = 0; id < 200000; ++id)
  {
    lineage.push_back(individual(id, id - 1, id, std::nullopt));
  }
  const std::string tree = linesOf(writeNewick, lineage).at(0);
  EXPECT_EQ(std::count(tree.begin(), tree.end(), '('), 199999);
}

TEST(Phylogeny, alifeStandardHasItsColumns)
{
  const auto lines = tableOf(writeAlifeStandard, FAMILY);
  EXPECT_EQ(lines.at(0).rfind("id,ancestor_list,origin_time,destruction_time,trait_trial,trait_age,", 0), 0u);
  EXPECT_EQ(lines.at(1).rfind("0,[none],0,3,1,0,1,0.5,", 0), 0u);
  EXPECT_EQ(lines.at(3).rfind("3,[0],2,inf,1,2,1,0.5,", 0), 0u);
}

TEST(Phylogeny, csvHasAValueForEveryColumnOfTheArchive)
{
  const TemporaryFolder folder;
  const ExperimentSettings settings = smallExperiment(folder.path());
  evolve(*openArchiveForWriting(settings, someProvenance()), settings, 1, 10);
  const auto archive = openArchiveForReading(folder.path());
  const auto phylogeny = readPhylogeny(*archive, 1);
  EXPECT_EQ(static_cast<int64_t>(phylogeny.size()), countRows(folder.path(), "individuals"));
  const auto lines = tableOf(writeCsv, phylogeny);
  const auto header = fieldsOf(lines.at(0));
  SQLite::Database file = openFile(folder.path());
  SQLite::Statement columns(file, "SELECT name FROM pragma_table_info('individuals')");
  while (columns.executeStep())
  {
    EXPECT_EQ(std::count(header.begin(), header.end(), columns.getColumn(0).getString()), 1);
  }
  for (const std::string& line : lines)
  {
    EXPECT_EQ(fieldsOf(line).size(), header.size());
  }
  // Exactly the survivors of the last generation are alive.
  const auto alive = std::count_if(phylogeny.begin(), phylogeny.end(), [](const auto& each) { return !each.death; });
  EXPECT_EQ(alive, settings.evolution.population);
}

TEST(Phylogeny, ancestryBeginsWithARandomRobotAndEndsWithTheOneAskedFor)
{
  const TemporaryFolder folder;
  const ExperimentSettings settings = smallExperiment(folder.path());
  evolve(*openArchiveForWriting(settings, someProvenance()), settings, 1, 10);
  const auto archive = openArchiveForReading(folder.path());
  const int64_t champion = archive->championOf(1);
  const auto ancestry = readAncestry(*archive, 1, champion);
  EXPECT_EQ(ancestry.front().archived.individual.parent, Individual::NO_PARENT);
  EXPECT_EQ(ancestry.back().archived.individual.id, champion);
  EXPECT_FALSE(ancestry.back().death);
}

TEST(Trace, hasTheStartEveryIntervalAndTheEndOfTheLifeThatIsEvaluated)
{
  SoftBodySettings settings;
  settings.grid_x = settings.grid_y = 2;
  settings.grid_z = 1;
  settings.lifetime = 0.1;
  const std::vector<double> zero(4, 0.0);
  const DevelopmentalProgram program = { zero, zero, zero, zero };
  std::vector<std::string> lines;
  const LineSink sink = [&lines](const std::string& line) { lines.push_back(line); };
  const Evaluation traced = writeTrace(settings, program, TraceKind::CENTER_OF_MASS, 0.25, sink);
  EXPECT_EQ(traced.state_hash, evaluate(settings, { program })[0].state_hash);
  ASSERT_EQ(lines.size(), 5u);  // header; 0, 0.25, 0.5 and 0.6 s
  EXPECT_EQ(lines[1], "0,-0.5,0.01,0.01,0.005,1,0,0,0");
  EXPECT_EQ(lines[2].rfind("0.25", 0), 0u) << lines[2];
  lines.clear();
  writeTrace(settings, program, TraceKind::VOXELS, 0.25, sink);
  EXPECT_EQ(lines.size(), 1u + 4u * 4u);
  EXPECT_EQ(fieldsOf(lines[1]).size(), fieldsOf(lines[0]).size());
  EXPECT_THROW(writeTrace(settings, program, TraceKind::VOXELS, 0.0, sink), InvalidInput);
}
}  // namespace
}  // namespace devo_evo::test
