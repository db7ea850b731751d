#include "devo_evo/render/robot_mesh.h"

#include "render/frames.h"
#include "soft_body/robots.h"

#include <gtest/gtest.h>

#include <map>

namespace devo_evo
{
namespace
{
/// Volume that a closed surface encloses, by the divergence theorem [m^3]; positive if faces look outwards.
double enclosedVolume(const RobotMesh& mesh, const std::vector<Eigen::Vector3d>& vertices)
{
  double volume = 0.0;
  for (const RobotMesh::Face& face : mesh.faces())
  {
    const auto corner = [&](size_t i) { return vertices[static_cast<size_t>(face.corners[i])]; };
    volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0 + corner(0).dot(corner(2).cross(corner(3))) / 6.0;
  }
  return volume;
}

Eigen::Vector3d centerOf(const RobotMesh::Face& face, const std::vector<Eigen::Vector3d>& vertices)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int corner : face.corners)
  {
    sum += vertices[static_cast<size_t>(corner)];
  }
  return sum / 4.0;
}

TEST(RobotMesh, ThePapersBodyHas80OuterFacesAnd160Edges)
{
  const RobotMesh mesh(SoftBodySettings{});  // 4 x 4 x 3
  EXPECT_EQ(mesh.faces().size(), 2u * (4 * 4 + 4 * 3 + 4 * 3));
  EXPECT_EQ(mesh.edges().size(), 160u);
  EXPECT_EQ(mesh.vertexCount(), 5 * 5 * 4);
}

TEST(RobotMesh, TheSurfaceIsClosedAndLooksOutwards)
{
  const RobotMesh mesh(bodyOf(3, 2, 4));
  std::map<std::pair<int, int>, int> directed;
  for (const RobotMesh::Face& face : mesh.faces())
  {
    for (size_t i = 0; i < 4; ++i)
    {
      ++directed[{ face.corners[i], face.corners[(i + 1) % 4] }];
    }
  }
  for (const auto& [edge, count] : directed)  // each once in each direction
  {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(directed.count({ edge.second, edge.first }), 1u);
  }
  EXPECT_EQ(directed.size(), 2 * mesh.edges().size());
}

TEST(RobotMesh, FacesComeByVoxelAndSide)
{
  const RobotMesh mesh(bodyOf(1, 1, 2));
  const std::vector<Eigen::Vector3d> vertices = mesh.vertices(restingFrame(bodyOf(1, 1, 2)));
  std::vector<int> voxels;
  std::vector<Eigen::Vector3d> normals;
  for (const RobotMesh::Face& face : mesh.faces())
  {
    voxels.push_back(face.voxel);
    normals.push_back(faceNormal(face, vertices));
  }
  EXPECT_EQ(voxels, (std::vector<int>{ 0, 0, 0, 0, 0, 1, 1, 1, 1, 1 }));
  const std::vector<Eigen::Vector3d> expected = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, -1, 0 }, { 0, 1, 0 }, { 0, 0, -1 },
                                                  { -1, 0, 0 }, { 1, 0, 0 }, { 0, -1, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  for (size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_LT((normals[i] - expected[i]).norm(), 1e-12) << i;
  }
}

TEST(RobotMesh, ABodyAtRestIsAStackOfCubes)
{
  const SoftBodySettings body = bodyOf(4, 4, 3);
  const RobotMesh mesh(body);
  const std::vector<Eigen::Vector3d> vertices = mesh.vertices(restingFrame(body));
  EXPECT_LT((vertices[0] - Eigen::Vector3d(0, 0, 0)).norm(), 1e-12);
  EXPECT_LT((vertices[1] - Eigen::Vector3d(0.01, 0, 0)).norm(), 1e-12);
  EXPECT_LT((vertices.back() - Eigen::Vector3d(0.04, 0.04, 0.03)).norm(), 1e-12);
  EXPECT_NEAR(enclosedVolume(mesh, vertices), 48e-6, 1e-15);
}

TEST(RobotMesh, NeighboursMeetAtTheMiddleOfTheirBond)
{
  // Two voxels of 1 and 2 cm whose centres are 1.6 cm apart: the small one ends at 0.8 cm from its centre, in the
  // middle, on that side, and at half its length on the other.
  const SoftBodySettings body = bodyOf(2, 1, 1);
  RobotFrame frame = restingFrame(body);
  frame.parts[0].position = { 0.0, 0.0, 0.0 };
  frame.parts[1].position = { 0.016, 0.0, 0.0 };
  frame.parts[1].present_length = 0.02;
  const RobotMesh mesh(body);
  const std::vector<Eigen::Vector3d> vertices = mesh.vertices(frame);
  EXPECT_LT((vertices[0] - Eigen::Vector3d(-0.005, -0.005, -0.005)).norm(), 1e-12);
  EXPECT_LT((vertices[1] - Eigen::Vector3d(0.008, -0.0075, -0.0075)).norm(), 1e-12);  // mean of 0.5 and 1 cm
  EXPECT_LT((vertices[2] - Eigen::Vector3d(0.026, -0.01, -0.01)).norm(), 1e-12);
}

TEST(RobotMesh, MovesWithTheBody)
{
  const SoftBodySettings body = bodyOf(2, 3, 2);
  const RobotMesh mesh(body);
  RobotFrame frame = restingFrame(body);
  const std::vector<Eigen::Vector3d> before = mesh.vertices(frame);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  const Eigen::Vector3d shift(0.1, -0.2, 0.3);
  for (ShownPart& voxel : frame.parts)
  {
    voxel.position = turn * voxel.position + shift;
    voxel.orientation = turn * voxel.orientation;
  }
  const std::vector<Eigen::Vector3d> after = mesh.vertices(frame);
  for (size_t i = 0; i < before.size(); ++i)
  {
    EXPECT_LT((after[i] - (turn * before[i] + shift)).norm(), 1e-12);
  }
}

TEST(RobotMesh, ALivingRobotFillsAboutTheSpaceOfItsVoxels)
{
  SoftBodySettings body;
  body.lifetime = 1.0;
  LifePlayback playback(BodySettings(body), scrambledRobot(body, 3));
  const RobotMesh mesh(body);
  for (const double time : { 0.0, 0.5, 0.9 })
  {
    playback.advanceTo(time);
    const RobotFrame frame = playback.frame();
    const std::vector<Eigen::Vector3d> vertices = mesh.vertices(frame);
    double volume = 0.0;
    for (const ShownPart& voxel : frame.parts)
    {
      volume += voxel.present_length * voxel.present_length * voxel.present_length;
    }
    EXPECT_NEAR(enclosedVolume(mesh, vertices) / volume, 1.0, 0.35);
    for (const RobotMesh::Face& face : mesh.faces())  // each face is near the voxel that it belongs to
    {
      const ShownPart& voxel = frame.parts[static_cast<size_t>(face.voxel)];
      EXPECT_NEAR((centerOf(face, vertices) - voxel.position).norm(), voxel.present_length / 2, body.voxel_size / 2);
    }
  }
}
}  // namespace
}  // namespace devo_evo
