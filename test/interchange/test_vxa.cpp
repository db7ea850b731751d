#include "devo_evo/interchange/vxa.h"

#include "devo_evo/soft_body/simulation.h"
#include "devo_evo/soft_body/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace devo_evo
{
namespace
{
/// Numbers with all their digits, as evolution makes them.
VxaRobot someRobot()
{
  VxaRobot robot;
  robot.id = "3/1042";
  robot.settings.lifetime = 0.1;
  DevelopmentalProgram& program = robot.genome.program;
  for (int voxel = 0; voxel < 48; ++voxel)
  {
    const double part = (voxel + 1.0) / 49.0;
    program.morphology_initial.push_back(part - 0.5);
    program.morphology_final.push_back(0.4 - part / 3.0);
    program.control_initial.push_back(part / 7.0);
    program.control_final.push_back(-part / 11.0);
    robot.genome.mutation_rate.push_back(part);
  }
  return robot;
}

std::string replaced(std::string text, const std::string& part, const std::string& by)
{
  const size_t place = text.find(part);
  EXPECT_NE(place, std::string::npos) << part;
  return place == std::string::npos ? text : text.replace(place, part.size(), by);
}

/// What is said of the robot's file after a change; "" if it is read.
std::string complaintAfter(const std::string& part, const std::string& by)
{
  try
  {
    readVxa(replaced(toVxa(someRobot()), part, by), "robot.vxa");
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

void expectComplaint(const std::string& part, const std::string& by, const std::string& tag, const std::string& words)
{
  const std::string complaint = complaintAfter(part, by);
  EXPECT_EQ(complaint.rfind("robot.vxa, line ", 0), 0u) << complaint;
  EXPECT_NE(complaint.find("<" + tag + ">: "), std::string::npos) << complaint;
  EXPECT_NE(complaint.find(words), std::string::npos) << complaint;
}

TEST(Vxa, aRobotComesBackWithTheSameGenomeSettingsAndLife)
{
  const VxaRobot robot = someRobot();
  const VxaRobot back = readVxa(toVxa(robot), "robot.vxa");
  EXPECT_EQ(back.id, "3/1042");
  EXPECT_EQ(back.genome, robot.genome);
  EXPECT_EQ(evaluate(back.settings, { back.genome.program })[0].state_hash,
            evaluate(robot.settings, { robot.genome.program })[0].state_hash);
}

TEST(Vxa, everyNumberOfTheSettingsComesBackToTheLastBit)
{
  VxaRobot robot = someRobot();
  double number = 1.0 / 3.0;
  for (const auto& field : softBodyReals())
  {
    if (std::string(field.name) != "slope")
    {
      number = std::fmod(number * 1.37, 1.0);
      robot.settings.*field.value = field.minimum + (field.maximum - field.minimum) * number * 0.02;
    }
  }
  robot.settings.time_step_fraction = 0.9 / 7.0;
  robot.settings.self_collision = false;
  robot.settings.sideways_bend_test = true;
  const SoftBodySettings back = readVxa(toVxa(robot), "robot.vxa").settings;
  for (const auto& field : softBodyReals())
  {
    EXPECT_EQ(back.*field.value, robot.settings.*field.value) << field.name;
  }
  EXPECT_FALSE(back.self_collision);
  EXPECT_TRUE(back.sideways_bend_test);
}

TEST(Vxa, holdsWhatTheReleasedExperimentsSet)
{
  VxaRobot robot = someRobot();
  robot.settings = SoftBodySettings();
  const std::string text = toVxa(robot);
  for (const std::string tag : { "<DtFrac>0.35<",
                                 "<BondDampingZ>1<",
                                 "<ColDampingZ>0.8<",
                                 "<SlowDampingZ>0.01<",
                                 "<SelfColEnabled>1<",
                                 "<ColSystem>3<",
                                 "<CollisionHorizon>2<",
                                 "<StopConditionType>2<",
                                 "<StopConditionValue>10.5<",
                                 "<InitCmTime>0.5<",
                                 "<MinTempFact>0.25<",
                                 "<GravAcc>-9.81<",
                                 "<FloorEnabled>1<",
                                 "<TempAmp>39<",
                                 "<TempBase>25<",
                                 "<TempPeriod>0.25<",
                                 "<GrowthAmplitude>0.75<",
                                 "<Lattice_Dim>0.01<",
                                 "<Elastic_Mod>5e+06<",
                                 "<Density>1e+06<",
                                 "<Poissons_Ratio>0.35<",
                                 "<CTE>0.01<",
                                 "<uStatic>1<",
                                 "<uDynamic>0.5<",
                                 "<X_Voxels>4<",
                                 "<Z_Voxels>3<",
                                 "<![CDATA[3333333333333333]]>" })
  {
    EXPECT_NE(text.find(tag), std::string::npos) << tag;
  }
}

TEST(Vxa, aRobotThatDoesNotDevelopHasNoFinalValues)
{
  VxaRobot robot = someRobot();
  robot.genome.program.morphology_final = robot.genome.program.morphology_initial;
  robot.genome.program.control_final = robot.genome.program.control_initial;
  const std::string text = toVxa(robot);
  EXPECT_EQ(text.find("<Final"), std::string::npos);
  EXPECT_EQ(readVxa(text, "robot.vxa").genome, robot.genome);
}

TEST(Vxa, roundNumbersOfOtherProgramsStayRound)
{
  std::string text = toVxa(someRobot());
  text.erase(text.find("<DevoEvo>"), text.find("</DevoEvo>") + 10 - text.find("<DevoEvo>"));
  text = replaced(text, "<StopConditionValue>0.6<", "<StopConditionValue>0.8<");
  text = replaced(text, "<TempPeriod>0.25<", "<TempPeriod>0.3333333333333333<");
  text = replaced(text, "<X_Voxels>4<", "<X_Voxels>4.0<");
  const VxaRobot robot = readVxa(text, "robot.vxa");
  EXPECT_EQ(robot.settings.lifetime, 0.3);
  EXPECT_EQ(robot.settings.actuation_frequency, 3.0);
  EXPECT_EQ(robot.id, "robot.vxa");
  EXPECT_TRUE(robot.genome.mutation_rate.empty());
}

/// The order of tags and the forms of numbers are those of the Python program that the paper's authors released.
TEST(Vxa, aFileInTheFormOfTheReleasedExperimentsIsRead)
{
  std::string text = toVxa(someRobot());
  text.erase(text.find("<DevoEvo>"), text.find("</DevoEvo>") + 10 - text.find("<DevoEvo>"));
  for (const auto& [ours, theirs] : std::vector<std::pair<std::string, std::string>>{
           { "<X_Voxels>4<", "<X_Voxels>4.0<" },
           { "<Y_Voxels>4<", "<Y_Voxels>4.0<" },
           { "<Z_Voxels>3<", "<Z_Voxels>3.0<" },
           { "<FloorSlope>0<", "<FloorSlope>0.0<" },
           { "<MinElasticMod>5e+06<", "<MinElasticMod>5000000.0<" },
           { "<GrowthAmplitude>0.75</GrowthAmplitude>", "" },
           { "<Environment>", "<Environment>\n<GrowthAmplitude>0.75</GrowthAmplitude>" },
           { "<EquilibriumMode>",
             "<SurfMesh><CMesh><DrawSmooth>1</DrawSmooth><Vertices/><Facets/><Lines/></CMesh></SurfMesh>"
             "<EquilibriumMode>" },
           { "</GA>",
             "<QhullTmpFile>run/qhull.txt</QhullTmpFile><CurvaturesTmpFile>run/curvatures.txt</CurvaturesTmpFile></"
             "GA>" },
       })
  {
    text = replaced(text, ours, theirs);
  }
  for (const auto& [ours, theirs] :
       { std::pair<std::string, std::string>("<Elastic_Mod>5e+06<", "<Elastic_Mod>5000000.0<"),
         { "1e+06<", "1e+006<" } })
  {
    for (size_t place = text.find(ours); place != std::string::npos; place = text.find(ours, place))
    {
      text.replace(place, ours.size(), theirs);
    }
  }
  const VxaRobot robot = readVxa(text, "robot.vxa");
  EXPECT_EQ(robot.genome.program.control_final, someRobot().genome.program.control_final);
  EXPECT_EQ(robot.genome.program.morphology_initial, someRobot().genome.program.morphology_initial);
  for (const auto& field : softBodyReals())
  {
    EXPECT_EQ(robot.settings.*field.value, someRobot().settings.*field.value) << field.name;
  }
}

TEST(Vxa, missingRepeatedAndUnknownTagsAreNamed)
{
  expectComplaint("<DtFrac>0.35</DtFrac>", "", "Integration", "<DtFrac> is missing");
  expectComplaint("<DtFrac>0.35</DtFrac>", "<DtFrac>0.35</DtFrac><DtFrac>0.3</DtFrac>", "DtFrac", "given twice");
  expectComplaint("<GravEnabled>1</GravEnabled>", "", "Gravity", "<GravEnabled> is missing");
  expectComplaint("<InitCmTime>0.5</InitCmTime>", "", "StopCondition", "<InitCmTime> is missing");
  expectComplaint("<TimeBetweenTraces>", "<FloorRadius>3</FloorRadius><TimeBetweenTraces>", "FloorRadius",
                  "not simulated here");
  expectComplaint("<PhaseOffset>", "<Stiffness/><PhaseOffset>", "Stiffness", "not simulated here");
}

TEST(Vxa, whatIsNotSimulatedIsRefusedByName)
{
  expectComplaint("<FluidDampEnabled>0", "<FluidDampEnabled>1", "FluidDampEnabled", "fluid is not simulated here");
  expectComplaint("<NumFixed>0", "<NumFixed>2", "NumFixed", "fixed regions (obstacles)");
  expectComplaint("<StickyFloor>0", "<StickyFloor>1", "StickyFloor", "a sticky floor");
  expectComplaint("<FloorSlope>0", "<FloorSlope>3", "FloorSlope", "a sloping floor");
  expectComplaint("<CollisionHorizon>2", "<CollisionHorizon>3", "CollisionHorizon", "another collision horizon");
  expectComplaint("[3333333333333333]", "[3333333333333335]", "Data", "several materials (obstacles");
  expectComplaint("[3333333333333333]", "[3333333333333330]", "Data", "empty: bodies with missing voxels");
  std::string plastic = toVxa(someRobot());
  const size_t material = plastic.find("<Name>Active_+");
  plastic.replace(plastic.find("<MatModel>0", material), 11, "<MatModel>1");
  EXPECT_THROW(readVxa(plastic, "robot.vxa"), InvalidInput);
}

TEST(Vxa, wrongCountsSizesAndNumbersAreNamed)
{
  expectComplaint("[3333333333333333]", "[333333333333333]", "Data", "a layer has 15 voxels");
  expectComplaint("<Z_Voxels>3", "<Z_Voxels>4", "Data", "it has 3 layers; <Z_Voxels> asks for 4");
  expectComplaint("<X_Voxels>4", "<X_Voxels>1000000000", "X_Voxels", "must lie within 1 to 64");
  expectComplaint("<X_Voxels>4", "<X_Voxels>4.5", "X_Voxels", "must be a whole number");
  expectComplaint("<Lattice_Dim>0.01", "<Lattice_Dim>wide", "Lattice_Dim", "must be a finite number");
  expectComplaint("<TempPeriod>0.25", "<TempPeriod>0", "TempPeriod", "must lie within");
  expectComplaint("<TempPeriod>0.25", "<TempPeriod>nan", "TempPeriod", "must be a finite number");
  expectComplaint("<DtFrac>0.35", "<DtFrac>1e999", "DtFrac", "must be a finite number");
  expectComplaint("<DtFrac>0.35", "<DtFrac>0.<!-- -->35", "DtFrac", "several pieces");
  const std::string first_phase = "[" + toText(1.0 / 49.0 / 7.0) + ",";
  expectComplaint(first_phase, "[1.5,", "PhaseOffset", "the value of voxel 0 is \"1.5\"");
  expectComplaint(first_phase, "[0, 0,", "PhaseOffset", "more than 16");
  expectComplaint("<Lifetime>0.1", "<Lifetime>0.2", "Lifetime", "contradicts <StopConditionValue>");
}

TEST(Vxa, hostileXmlIsRefused)
{
  const auto complaint = [](const std::string& text)
  {
    try
    {
      readVxa(text, "robot.vxa");
    }
    catch (const InvalidInput& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(complaint("<!DOCTYPE v [<!ENTITY a \"b\">]><VXA/>").find("document type"), std::string::npos);
  EXPECT_NE(complaint("").find("malformed XML"), std::string::npos);
  EXPECT_NE(complaint("<VXA><Simulator></VXA>").find("malformed XML"), std::string::npos);
  EXPECT_NE(complaint("<html/>").find("not a VXA file"), std::string::npos);
  EXPECT_NE(complaint("<VXA/><VXA/>").find("not a VXA file"), std::string::npos);
  std::string deep = "<VXA>";
  for (int i = 0; i < 100000; ++i)
  {
    deep += "<a>";
  }
  EXPECT_NE(complaint(deep).find("malformed XML"), std::string::npos);
  EXPECT_NE(complaint(std::string(LARGEST_VXA_FILE + 1, ' ')).find("more than"), std::string::npos);
}

TEST(Vxa, whatTheFormatCannotExpressIsNotWritten)
{
  VxaRobot robot = someRobot();
  robot.settings.actuation_frequency = 0.0;
  EXPECT_THROW(toVxa(robot), InvalidInput);
  robot = someRobot();
  robot.settings.slope = 0.1;
  EXPECT_THROW(toVxa(robot), InvalidInput);
}
}  // namespace
}  // namespace devo_evo
