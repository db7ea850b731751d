#include "devo_evo/soft_body/lattice.h"

#include <gtest/gtest.h>

using namespace devo_evo;

TEST(Lattice, numbersVoxelsAlongXThenYThenZ)
{
  const Lattice lattice(4, 3, 2);
  EXPECT_EQ(24, lattice.voxelCount());
  EXPECT_EQ(0, lattice.index(0, 0, 0));
  EXPECT_EQ(1, lattice.index(1, 0, 0));
  EXPECT_EQ(4, lattice.index(0, 1, 0));
  EXPECT_EQ(12, lattice.index(0, 0, 1));
  EXPECT_EQ(23, lattice.index(3, 2, 1));
  EXPECT_EQ((std::array<int, 3>{ 3, 2, 1 }), lattice.coordinates(23));
  EXPECT_EQ((std::array<int, 3>{ 2, 1, 0 }), lattice.coordinates(6));
}

TEST(Lattice, bondsFaceNeighbours)
{
  EXPECT_EQ(104u, Lattice(4, 4, 3).bonds().size());  // 3*4*3 + 4*3*3 + 4*4*2
  EXPECT_TRUE(Lattice(1, 1, 1).bonds().empty());
}

TEST(Lattice, listsBondsByLowerVoxelThenAxis)
{
  const Lattice lattice(2, 2, 2);
  const int expected[][3] = { { 0, 1, 0 }, { 0, 2, 1 }, { 0, 4, 2 }, { 1, 3, 1 }, { 1, 5, 2 }, { 2, 3, 0 },
                              { 2, 6, 2 }, { 3, 7, 2 }, { 4, 5, 0 }, { 4, 6, 1 }, { 5, 7, 1 }, { 6, 7, 0 } };
  ASSERT_EQ(12u, lattice.bonds().size());
  for (size_t i = 0; i < 12; ++i)
  {
    EXPECT_EQ(expected[i][0], lattice.bonds()[i].voxel_1);
    EXPECT_EQ(expected[i][1], lattice.bonds()[i].voxel_2);
    EXPECT_EQ(expected[i][2], lattice.bonds()[i].axis);
  }
}

TEST(Lattice, hasASurfaceOfVoxelsWithFewerThanSixNeighbours)
{
  EXPECT_EQ(44u, Lattice(4, 4, 3).surface().size());  // all but 2x2 inside the middle layer
  const Lattice cube(3, 3, 3);
  ASSERT_EQ(26u, cube.surface().size());
  EXPECT_EQ(12, cube.surface()[12]);
  EXPECT_EQ(14, cube.surface()[13]);  // 13 is the centre
}

TEST(Lattice, countsFaceSteps)
{
  const Lattice lattice(4, 4, 3);
  EXPECT_EQ(0, lattice.manhattanDistance(5, 5));
  EXPECT_EQ(1, lattice.manhattanDistance(0, 16));
  EXPECT_EQ(8, lattice.manhattanDistance(lattice.index(0, 3, 0), lattice.index(3, 0, 2)));
}

TEST(Lattice, mirrorsAcrossThePlaneOfBilateralSymmetry)
{
  const Lattice lattice(4, 4, 3);
  EXPECT_EQ(lattice.index(3, 1, 2), lattice.mirrored(lattice.index(0, 1, 2)));
  EXPECT_EQ(lattice.index(1, 3, 0), lattice.mirrored(lattice.index(2, 3, 0)));
  EXPECT_EQ(1, Lattice(3, 1, 1).mirrored(1));
}
