#include "devo_evo/render/colouring.h"

#include "devo_evo/render/appearance.h"

#include <gtest/gtest.h>

#include <array>

namespace devo_evo
{
namespace
{
constexpr double L = 0.01;

std::array<float, 3> parts(const Colour& colour)
{
  return { colour.red, colour.green, colour.blue };
}

void expectColour(const Colour& colour, float red, float green, float blue)
{
  EXPECT_NEAR(colour.red, red, 1e-6);
  EXPECT_NEAR(colour.green, green, 1e-6);
  EXPECT_NEAR(colour.blue, blue, 1e-6);
}

ShownPart voxelOf(double present, double resting, double remaining, double phase)
{
  return { Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity(), present, resting, remaining, phase };
}

/// As the only voxel of a body of this pitch.
Colour colourOf(const ShownPart& voxel, Colouring colouring)
{
  SoftBodySettings settings;
  settings.voxel_size = L;
  RobotFrame frame;
  frame.parts = { voxel };
  return makeAppearance(BodySettings(settings))->colourOf(frame, 0, colouring);
}

TEST(Colouring, JetGoesFromBlueOverGreenToRed)
{
  expectColour(jet(0.0), 0, 0, 1);
  expectColour(jet(0.125), 0, 0.5, 1);
  expectColour(jet(0.25), 0, 1, 1);
  expectColour(jet(0.5), 0, 1, 0);
  expectColour(jet(0.75), 1, 1, 0);
  expectColour(jet(0.875), 1, 0.5, 0);
  expectColour(jet(1.0), 1, 0, 0);
}

TEST(Colouring, JetEndsAtItsEnds)
{
  EXPECT_EQ(parts(jet(-7.0)), parts(jet(0.0)));
  EXPECT_EQ(parts(jet(7.0)), parts(jet(1.0)));
}

TEST(Colouring, HuesFormACircle)
{
  expectColour(hue(0.0), 1, 0, 0);
  expectColour(hue(1.0 / 6), 1, 1, 0);
  expectColour(hue(1.0 / 3), 0, 1, 0);
  expectColour(hue(0.5), 0, 1, 1);
  expectColour(hue(2.0 / 3), 0, 0, 1);
  expectColour(hue(5.0 / 6), 1, 0, 1);
  expectColour(hue(1.0), 1, 0, 0);
  expectColour(hue(-0.5), 0, 1, 1);
}

TEST(Colouring, SmallVoxelsAreBlueMediumOnesGreenLargeOnesRed)
{
  for (const Colouring colouring : { Colouring::RESTING_LENGTH, Colouring::PRESENT_LENGTH })
  {
    const auto colour = [&](double length) { return colourOf(voxelOf(length, length, 0.0, 0.0), colouring); };
    expectColour(colour(0.0015), 0, 0, 1);
    expectColour(colour(0.0090), 0, 1, 0);  // 0.9 / 1.5 - 0.1 = 0.5
    expectColour(colour(0.0165), 1, 0, 0);
  }
}

TEST(Colouring, RestingAndPresentLengthAreTwoThings)
{
  const ShownPart voxel = voxelOf(0.0165, 0.0090, 0.0, 0.0);
  expectColour(colourOf(voxel, Colouring::RESTING_LENGTH), 0, 1, 0);
  expectColour(colourOf(voxel, Colouring::PRESENT_LENGTH), 1, 0, 0);
}

TEST(Colouring, ShrinkingVoxelsAreBlueGrowingOnesRedOthersGreen)
{
  const auto colour = [&](double remaining)
  { return colourOf(voxelOf(L, L, remaining, 0.0), Colouring::REMAINING_DEVELOPMENT); };
  expectColour(colour(-0.0075), 0, 0, 1);
  expectColour(colour(0.0), 0, 1, 0);
  expectColour(colour(0.0075), 1, 0, 0);
}

TEST(Colouring, PhasesOneCycleApartLookAlike)
{
  const auto colour = [&](double phase) { return colourOf(voxelOf(L, L, 0.0, phase), Colouring::PHASE); };
  expectColour(colour(0.0), 0, 1, 1);
  expectColour(colour(0.5), 1, 0, 0);
  expectColour(colour(-0.5), 1, 0, 0);
  EXPECT_NE(parts(colour(-0.25)), parts(colour(0.25)));
}

TEST(Colouring, NamesReadBack)
{
  for (const Colouring colouring :
       { Colouring::RESTING_LENGTH, Colouring::REMAINING_DEVELOPMENT, Colouring::PHASE, Colouring::PRESENT_LENGTH })
  {
    EXPECT_EQ(parseColouring(toString(colouring)), colouring);
  }
  EXPECT_THROW(parseColouring("rainbow"), InvalidInput);
}
}  // namespace
}  // namespace devo_evo
