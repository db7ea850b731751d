#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/bodies/bodies.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>
#include <sstream>

namespace devo_evo
{
namespace
{
using Json = nlohmann::json;

/// Two voxels.
SoftBodySettings smallBody()
{
  SoftBodySettings settings;
  settings.grid_x = 2;
  settings.grid_y = 1;
  settings.grid_z = 1;
  return settings;
}

const std::string ROBOT = R"({"id": 7, "size_gene_initial": [0.5, -1], "phase_initial_cycles": [0.25, 0]})";

std::vector<RobotRecord> readAll(const std::string& text, const SoftBodySettings& settings = smallBody())
{
  std::istringstream input(text);
  RobotReader reader(input, "robots.jsonl", *makeSoftBody(settings));
  std::vector<RobotRecord> robots;
  while (auto robot = reader.next())
  {
    robots.push_back(*robot);
  }
  return robots;
}

/// What the reader says about a text that it must refuse.
std::string complaintOf(const std::string& text)
{
  try
  {
    readAll(text);
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

/// The small robot with one field replaced by some JSON.
std::string robotWith(const std::string& field, const std::string& json)
{
  Json robot = Json::parse(ROBOT);
  robot[field] = "REPLACE";
  std::string text = robot.dump();
  return text.replace(text.find("\"REPLACE\""), 9, json);
}

TEST(ReadingRobots, TakesIdsAndArrays)
{
  const auto robots = readAll(ROBOT + "\n" + robotWith("id", "\"a b\"") + "\n");
  ASSERT_EQ(robots.size(), 2u);
  EXPECT_EQ(robots[0].id, RobotId(int64_t{ 7 }));
  EXPECT_EQ(robots[0].line, 1);
  EXPECT_EQ(robots[0].genome.program.morphology_initial, (std::vector<double>{ 0.5, -1.0 }));
  EXPECT_EQ(robots[0].genome.program.control_initial, (std::vector<double>{ 0.25, 0.0 }));
  EXPECT_TRUE(robots[0].genome.mutation_rate.empty());
  EXPECT_EQ(robots[1].id, RobotId("a b"));
  EXPECT_EQ(robots[1].line, 2);
}

TEST(ReadingRobots, WithoutFinalValuesTheyDoNotDevelop)
{
  const auto robot = readAll(ROBOT).front().genome.program;
  EXPECT_EQ(robot.morphology_final, robot.morphology_initial);
  EXPECT_EQ(robot.control_final, robot.control_initial);
}

TEST(ReadingRobots, TakesFinalValuesAndMutationRates)
{
  const auto robots =
      readAll(robotWith("size_gene_final", "[0, 0.125]") + "\n" + robotWith("phase_final_cycles", "[1, -1]") + "\n" +
              robotWith("mutation_rate", "[0.5, 1]"));
  EXPECT_EQ(robots[0].genome.program.morphology_final, (std::vector<double>{ 0.0, 0.125 }));
  EXPECT_EQ(robots[1].genome.program.control_final, (std::vector<double>{ 1.0, -1.0 }));
  EXPECT_EQ(robots[2].genome.mutation_rate, (std::vector<double>{ 0.5, 1.0 }));
}

TEST(ReadingRobots, TakesTheReferenceGenomes)
{
  std::ifstream input(TEST_DATA_DIR "/genomes.jsonl");
  RobotReader reader(input, "genomes.jsonl", *makeSoftBody(SoftBodySettings()));
  int count = 0;
  for (; reader.next(); ++count)
  {
  }
  EXPECT_EQ(count, 36);
}

TEST(ReadingRobots, LetsPassWhatDoesNoHarm)
{
  EXPECT_TRUE(readAll("").empty());
  EXPECT_TRUE(readAll("\n \t\n\r\n").empty());
  EXPECT_EQ(readAll("\n\n" + ROBOT + "\n\n").front().line, 3);
  EXPECT_EQ(readAll(ROBOT + "\r\n" + ROBOT + "\r\n").size(), 2u);
  EXPECT_EQ(readAll("\xef\xbb\xbf" + ROBOT).size(), 1u);
  EXPECT_EQ(readAll(robotWith("note", "{\"deep\": [[1, {\"size_gene_initial\": 2}]]}")).size(), 1u);
  EXPECT_EQ(readAll(robotWith("size_gene_final", "null")).size(), 1u);
  EXPECT_EQ(readAll(robotWith("grid", "[2, 1, 1]")).size(), 1u);
  EXPECT_EQ(readAll(ROBOT + "\n" + ROBOT).size(), 2u);
}

TEST(ReadingRobots, RefusesMalformedJsonWithLineAndColumn)
{
  EXPECT_EQ(complaintOf(ROBOT + "\n{\"id\": 8,, }").rfind("robots.jsonl, line 2, column 10: malformed JSON", 0), 0u);
  EXPECT_EQ(complaintOf("{\"id\": 8").rfind("robots.jsonl, line 1, column 9: malformed JSON", 0), 0u);
  EXPECT_EQ(complaintOf("\n\nnonsense").rfind("robots.jsonl, line 3, column ", 0), 0u);
  EXPECT_EQ(complaintOf(ROBOT + " " + ROBOT).rfind("robots.jsonl, line 1, column ", 0), 0u);
  EXPECT_EQ(complaintOf("[1, 2]"), "robots.jsonl, line 1: it holds a list of 2; it must be a JSON object");
  EXPECT_EQ(complaintOf("{\"id\": \"\xff\"}").rfind("robots.jsonl, line 1, column ", 0), 0u);
}

TEST(ReadingRobots, RefusesAFieldGivenTwice)
{
  EXPECT_EQ(complaintOf("{\"id\": 1, \"id\": 2}"), "robots.jsonl, line 1: the field \"id\" is given twice");
}

TEST(ReadingRobots, RefusesWhatIsNoIdentity)
{
  EXPECT_EQ(complaintOf("{}"), "robots.jsonl, line 1: id is missing; it must be text or a whole number");
  EXPECT_EQ(complaintOf(robotWith("id", "1.5")), "robots.jsonl, line 1: id is 1.5; it must be text or a whole number");
  EXPECT_NE(complaintOf(robotWith("id", "18446744073709551615")), "");
  EXPECT_NE(complaintOf(robotWith("id", "null")), "");
  EXPECT_NE(complaintOf(robotWith("id", "true")), "");
}

TEST(ReadingRobots, RefusesGenomesOfTheWrongSize)
{
  EXPECT_EQ(complaintOf(robotWith("size_gene_initial", "[0]")),
            "robots.jsonl, line 1, robot 7: size_gene_initial has 1 values; a grid of 2x1x1 voxels needs 2");
  EXPECT_NE(complaintOf(robotWith("phase_final_cycles", "[0, 0, 0]")).find("phase_final has 3 values"),
            std::string::npos);
  EXPECT_NE(complaintOf(robotWith("mutation_rate", "[0.5]")).find("mutation_rate has 1 values; it must have 2 or none"),
            std::string::npos);
  EXPECT_EQ(complaintOf(robotWith("grid", "[1, 2, 1]")),
            "robots.jsonl, line 1, robot 7: grid does not fit the parameter grid; it must be [2,1,1]");
}

TEST(ReadingRobots, RefusesGenesOutOfRange)
{
  EXPECT_EQ(complaintOf(robotWith("size_gene_initial", "[0, 1.5]")),
            "robots.jsonl, line 1, robot 7: size_gene_initial[1] is 1.5; it must lie within -1 to 1");
  EXPECT_NE(
      complaintOf(robotWith("mutation_rate", "[0.5, 2]")).find("mutation_rate[1] is 2; it must lie within 0 to 1"),
      std::string::npos);
}

TEST(ReadingRobots, RefusesGenesThatAreNoNumbers)
{
  EXPECT_EQ(complaintOf(robotWith("size_gene_initial", "[0, null]")),
            "robots.jsonl, line 1, robot 7: size_gene_initial[1] is null; it must be a number");
  EXPECT_NE(complaintOf(robotWith("size_gene_initial", "[true, 0]")).find("[0] is true"), std::string::npos);
  EXPECT_NE(complaintOf(robotWith("size_gene_initial", "[[], 0]")).find("[0] is a list of 0"), std::string::npos);
  EXPECT_NE(complaintOf(robotWith("size_gene_initial", "3")).find("is not a list"), std::string::npos);
  EXPECT_NE(complaintOf("{\"id\": 7}").find("robot 7: size_gene_initial is missing"), std::string::npos);
}

TEST(ReadingRobots, NamesTheGeneThatIsNotFinite)
{
  for (const std::string word : { "NaN", "nan", "Infinity", "-Infinity" })
  {
    const std::string message = complaintOf(robotWith("size_gene_initial", "[0, " + word + "]"));
    EXPECT_EQ(message.rfind("robots.jsonl, line 1, column ", 0), 0u) << message;
    EXPECT_NE(message.find("robot 7, size_gene_initial[1]: it is "), std::string::npos) << message;
    EXPECT_NE(message.find("it must be a finite number"), std::string::npos) << message;
  }
  const std::string overflow = complaintOf(robotWith("size_gene_initial", "[0, 1e999]"));
  EXPECT_NE(overflow.find("line 1: malformed JSON, robot 7, size_gene_initial[1]: "), std::string::npos) << overflow;
}

TEST(ReadingRobots, SurvivesDeepNestingAndEndlessLines)
{
  const std::string deep(500000, '[');
  EXPECT_NE(complaintOf(deep), "");
  EXPECT_NE(complaintOf("{\"id\": " + deep + std::string(500000, ']') + "}").find("id is a list of 1"),
            std::string::npos);
  EXPECT_NE(complaintOf(std::string(2000000, 'x')).find("line 1: the line has more than"), std::string::npos);
}

Evaluation validEvaluation()
{
  Evaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = 0.1;
  evaluation.displacement_y_voxels = 0.4;
  evaluation.displacement_xy_voxels = 1.0 / 3.0;
  evaluation.first_top_contact_since_birth_s = 2.5;
  evaluation.turns = -1.25;
  evaluation.airborne_fraction = 0.0;
  evaluation.velocity_body_lengths_per_s = { 0.5, 1e-9 };
  evaluation.state_hash = 0xabc;
  return evaluation;
}

TEST(WritingEvaluations, HasEveryFieldInOrder)
{
  EXPECT_EQ(evaluationToJson(RobotId("golden-000"), validEvaluation(), *makeSoftBody(SoftBodySettings())),
            R"({"id":"golden-000","valid":true,"fitness":0.1,"displacement_y_voxels":0.4,)"
            R"("displacement_xy_voxels":0.3333333333333333,)"
            R"("first_top_contact_since_birth_s":2.5,"fell_over_since_birth_s":null,"turns":-1.25,)"
            R"("airborne_fraction":0.0,"velocity_body_lengths_per_s":[0.5,1e-09],"state_hash":"0000000000000abc"})");
}

TEST(WritingEvaluations, NumbersReadBackAsTheSame)
{
  for (const double number : { 0.1 + 0.2, 1.0 / 3.0, 52.183749102837465, -1.7976931348623157e308, 5e-324 })
  {
    Evaluation evaluation = validEvaluation();
    evaluation.turns = number;
    const Json json =
        Json::parse(evaluationToJson(RobotId(int64_t{ 1 }), evaluation, *makeSoftBody(SoftBodySettings())));
    EXPECT_EQ(json["turns"].get<double>(), number);
    EXPECT_EQ(json["id"], 1);
  }
}

TEST(WritingEvaluations, AnInvalidOneHasNullsAndAVerdict)
{
  Evaluation evaluation;
  evaluation.divergence = Divergence{ 1000, 17, std::numeric_limits<double>::infinity() };
  const SoftBodySettings settings;
  const Json json = Json::parse(evaluationToJson(RobotId(int64_t{ 1 }), evaluation, *makeSoftBody(settings)));
  EXPECT_EQ(json["valid"], false);
  for (const std::string field : { "displacement_y_voxels", "displacement_xy_voxels", "fitness", "turns",
                                   "airborne_fraction", "first_top_contact_since_birth_s", "state_hash" })
  {
    EXPECT_TRUE(json.at(field).is_null()) << field;
  }
  EXPECT_TRUE(json["velocity_body_lengths_per_s"].empty());
  EXPECT_EQ(json["verdict"]["step"], 1000);
  EXPECT_EQ(json["verdict"]["time_s"].get<double>(), 1000 * settings.timeStep());
  EXPECT_EQ(json["verdict"]["bond"], 17);
  EXPECT_TRUE(json["verdict"]["strain"].is_null());
  EXPECT_EQ(json["verdict"]["message"], evaluation.divergence->describe(settings.timeStep()));
}
}  // namespace
}  // namespace devo_evo
