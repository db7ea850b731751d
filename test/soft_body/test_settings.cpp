#include "devo_evo/soft_body/settings.h"

#include "evolution/settings_of.h"
#include "soft_body/robots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace devo_evo;

namespace
{
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

template <class Action>
std::string messageOf(Action action)
{
  try
  {
    action();
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "accepted";
}

std::string verdictOn(const SoftBodySettings& settings)
{
  return messageOf([&settings] { settings.validate(); });
}

std::string verdictOn(const DevelopmentalProgram& program)
{
  return messageOf([&program] { validate(program, SoftBodySettings()); });
}
}  // namespace

// ---- settings ----------------------------------------------------------------------------------------------------

TEST(Settings, areThePapersByDefault)
{
  const SoftBodySettings settings;
  EXPECT_EQ("accepted", verdictOn(settings));
  EXPECT_EQ(48, settings.voxelCount());
  EXPECT_EQ(10.0, settings.lifetime);
  // dt = 0.35 / (2 pi sqrt(E L / (rho L^3))), sqrt(50,000 / s^2) = 223.607 / s
  EXPECT_NEAR(0.35 / (2.0 * 3.1415926 * 223.60679774997897), settings.timeStep(), 1e-18);
}

TEST(Settings, stepLongerInSofterHeavierOrLargerBodies)
{
  SoftBodySettings settings;
  const double dt = settings.timeStep();
  settings.youngs_modulus /= 4.0;
  EXPECT_NEAR(2.0 * dt, settings.timeStep(), 1e-15);
  settings.density *= 4.0;
  EXPECT_NEAR(4.0 * dt, settings.timeStep(), 1e-15);
  settings.voxel_size *= 2.0;
  EXPECT_NEAR(8.0 * dt, settings.timeStep(), 1e-15);
}

TEST(Settings, areCheckedFieldByField)
{
  for (const BoundedField<SoftBodySettings, double>& field : softBodyReals())
  {
    SCOPED_TRACE(field.name);
    SoftBodySettings settings;
    EXPECT_LE(field.minimum, settings.*field.value);
    EXPECT_GE(field.maximum, settings.*field.value);
    for (const double bad : { std::nextafter(field.minimum, -1e300), std::nextafter(field.maximum, 1e300), NOT_A_NUMBER,
                              std::numeric_limits<double>::infinity() })
    {
      settings.*field.value = bad;
      EXPECT_EQ(0u, verdictOn(settings).find(std::string(field.name) + " is ")) << verdictOn(settings);
    }
  }
  for (const BoundedField<SoftBodySettings, int>& field : softBodyIntegers())
  {
    SCOPED_TRACE(field.name);
    for (const int bad : { field.minimum - 1, field.maximum + 1 })
    {
      SoftBodySettings settings;
      settings.*field.value = bad;
      EXPECT_EQ(0u, verdictOn(settings).find(std::string(field.name) + " is ")) << verdictOn(settings);
    }
  }
}

TEST(Settings, tellWhatIsWrongAndWhatWouldBeRight)
{
  SoftBodySettings settings;
  settings.poissons_ratio = 0.5;
  EXPECT_EQ("poissons_ratio is 0.5; it must lie within 0 to 0.499", verdictOn(settings));
  settings = SoftBodySettings();
  settings.grid_z = 0;
  EXPECT_EQ("grid_z is 0; it must lie within 1 to 64", verdictOn(settings));
  settings = SoftBodySettings();
  settings.gravity = NOT_A_NUMBER;
  EXPECT_EQ("gravity is nan; it must lie within 0 to 1000", verdictOn(settings));
}

TEST(Settings, limitTheSizeOfABodyAndTheLengthOfASimulation)
{
  SoftBodySettings settings;
  settings.grid_x = settings.grid_y = 64;
  settings.grid_z = 8;
  EXPECT_EQ("accepted", verdictOn(settings));
  settings.grid_z = 9;
  EXPECT_EQ("grid is 64x64x9; it must have at most 32768 voxels", verdictOn(settings));

  settings = SoftBodySettings();
  settings.youngs_modulus = 1e12;
  settings.density = 1.0;
  settings.voxel_size = 1e-4;
  const std::string verdict = verdictOn(settings);
  EXPECT_NE(std::string::npos, verdict.find("ask for more than 1e+09 steps")) << verdict;
}

TEST(Settings, areRefusedWhereDragWouldReverseMotion)
{
  SoftBodySettings settings;
  settings.global_damping = 10.0;
  settings.time_step_fraction = 0.7;
  EXPECT_EQ("global_damping times time_step_fraction is 7; it must be at most 6.28", verdictOn(settings));
}

TEST(Settings, areCheckedBeforeASimulation)
{
  SoftBodySettings settings;
  settings.lifetime = 0.0;
  const DevelopmentalProgram robot = uniformRobot(settings, 0.0);
  EXPECT_EQ("lifetime is 0; it must lie within 0.001 to 1000", messageOf([&] { evaluate(settings, { robot }); }));
}

// ---- programs ----------------------------------------------------------------------------------------------------

TEST(Program, mayHoldGenesWithinTheLimitsAndSinglePrecisionBeyond)
{
  const SoftBodySettings settings;
  EXPECT_EQ("accepted", verdictOn(scrambledRobot(settings, 1)));
  EXPECT_EQ("accepted", verdictOn(uniformRobot(settings, 1.0, -1.0)));
  EXPECT_EQ("accepted", verdictOn(uniformRobot(settings, -1.0 - 1e-7, 1.0 + 1e-7)));
}

TEST(Program, isRejectedWithTheArrayAndTheSizeThatIsWrong)
{
  DevelopmentalProgram program = uniformRobot(SoftBodySettings(), 0.0);
  program.control_final.pop_back();
  EXPECT_EQ("phase_final has 47 values; a grid of 4x4x3 voxels needs 48", verdictOn(program));
  program = uniformRobot(SoftBodySettings(), 0.0);
  program.morphology_initial.clear();
  EXPECT_EQ("size_gene_initial has 0 values; a grid of 4x4x3 voxels needs 48", verdictOn(program));
}

TEST(Program, isRejectedWithTheValueThatIsWrong)
{
  DevelopmentalProgram program = uniformRobot(SoftBodySettings(), 0.0);
  program.morphology_final[7] = -1.5;
  EXPECT_EQ("size_gene_final[7] is -1.5; it must lie within -1 to 1", verdictOn(program));
  program = uniformRobot(SoftBodySettings(), 0.0);
  program.control_initial[47] = NOT_A_NUMBER;
  EXPECT_EQ("phase_initial[47] is nan; it must lie within -1 to 1", verdictOn(program));
  program = uniformRobot(SoftBodySettings(), 0.0);
  program.control_initial[0] = 1.0 + 2e-7;
  EXPECT_EQ(0u, verdictOn(program).find("phase_initial[0] is 1.0000002"));
}

TEST(Program, isCheckedBeforeASimulation)
{
  const SoftBodySettings settings;
  DevelopmentalProgram program = uniformRobot(settings, 0.0);
  program.morphology_initial[3] = std::numeric_limits<double>::infinity();
  EXPECT_EQ("size_gene_initial[3] is inf; it must lie within -1 to 1",
            messageOf(
                [&] {
                  evaluate(settings, { uniformRobot(settings, 0.0), program });
                }));
}

TEST(Program, hasWindowsThatTellHowMuchItDevelops)
{
  SoftBodySettings settings;
  settings.grid_x = settings.grid_y = 1;
  settings.grid_z = 2;
  const DevelopmentalProgram program = { { -1.0, 0.0 }, { 1.0, 0.5 }, { 0.25, -0.25 }, { 0.25, 0.25 } };
  const std::shared_ptr<const Body> body = makeSoftBody(settings);
  const GenomeLayout paper = body->layout(settingsOf(Treatment::EVO_DEVO, Profile::PAPER));
  const GenomeLayout released_code = body->layout(settingsOf(Treatment::EVO_DEVO, Profile::RELEASED_CODE));
  EXPECT_NEAR((2.0 + 0.5) / 2.0 / 2.0, morphologyWindow(program, paper), 1e-15);
  EXPECT_NEAR((0.0 + 0.5) / 2.0 / 2.0, controlWindow(program, released_code), 1e-15);
  EXPECT_NEAR((0.0 + 0.5) / 2.0 / 0.5, controlWindow(program, paper), 1e-15);
  EXPECT_EQ(0.0, morphologyWindow(uniformRobot(settings, 0.7), paper));
}

// ---- batches -----------------------------------------------------------------------------------------------------

TEST(Batch, holdsOneToAsManyRobotsAsThereAreLanes)
{
  const SoftBodySettings settings;
  EXPECT_EQ("a simulation by scalar takes 1 to 1 robots, not 2",
            messageOf([&] { makeSimulation(settings, scrambledRobots(settings, 2), InstructionSet::SCALAR); }));
  EXPECT_EQ("a simulation by scalar takes 1 to 1 robots, not 0",
            messageOf([&] { makeSimulation(settings, {}, InstructionSet::SCALAR); }));
}
