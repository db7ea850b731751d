#include "devo_evo/render/robot_mesh.h"

#include "devo_evo/soft_body/lattice.h"

#include <algorithm>
#include <set>

namespace devo_evo
{
namespace
{
/// Which side of a voxel: 2 axis for the lower, 2 axis + 1 for the upper one.
size_t side(size_t axis, int upper)
{
  return 2 * axis + static_cast<size_t>(upper);
}
}  // namespace

RobotMesh::RobotMesh(const SoftBodySettings& settings)
  : grid_({ settings.grid_x, settings.grid_y, settings.grid_z })
  , vertex_voxels_(static_cast<size_t>((grid_[0] + 1) * (grid_[1] + 1) * (grid_[2] + 1)))
{
  const Lattice lattice(settings);
  std::array<int, SIDES> alone;
  alone.fill(NO_NEIGHBOUR);
  neighbours_.assign(static_cast<size_t>(lattice.voxelCount()), alone);
  for (const Lattice::Bond& bond : lattice.bonds())
  {
    neighbours_[static_cast<size_t>(bond.voxel_1)][side(static_cast<size_t>(bond.axis), 1)] = bond.voxel_2;
    neighbours_[static_cast<size_t>(bond.voxel_2)][side(static_cast<size_t>(bond.axis), 0)] = bond.voxel_1;
  }
  for (int voxel = 0; voxel < lattice.voxelCount(); ++voxel)
  {
    const std::array<int, 3> place = lattice.coordinates(voxel);
    for (int corner = 0; corner < 8; ++corner)
    {
      const std::array<int, 3> upper = { corner & 1, corner >> 1 & 1, corner >> 2 };
      const int vertex = vertexIndex({ place[0] + upper[0], place[1] + upper[1], place[2] + upper[2] });
      vertex_voxels_[static_cast<size_t>(vertex)].push_back({ voxel, upper });
    }
    addFacesOf(voxel, place);
  }
  addEdges();
}

int RobotMesh::vertexIndex(const std::array<int, 3>& place) const
{
  return place[0] + (grid_[0] + 1) * (place[1] + (grid_[1] + 1) * place[2]);
}

void RobotMesh::addFacesOf(int voxel, const std::array<int, 3>& place)
{
  for (size_t axis = 0; axis < 3; ++axis)
  {
    for (const int upper : { 0, 1 })
    {
      if (neighbours_[static_cast<size_t>(voxel)][side(axis, upper)] != NO_NEIGHBOUR)
      {
        continue;
      }
      // Around the outward normal, +axis or -axis.
      const size_t first = upper == 1 ? (axis + 1) % 3 : (axis + 2) % 3;
      const size_t second = upper == 1 ? (axis + 2) % 3 : (axis + 1) % 3;
      std::array<int, 3> corner = place;
      corner[axis] += upper;
      Face face{ voxel, {} };
      face.corners[0] = vertexIndex(corner);
      ++corner[first];
      face.corners[1] = vertexIndex(corner);
      ++corner[second];
      face.corners[2] = vertexIndex(corner);
      --corner[first];
      face.corners[3] = vertexIndex(corner);
      faces_.push_back(face);
    }
  }
}

void RobotMesh::addEdges()
{
  std::set<std::array<int, 2>> edges;
  for (const Face& face : faces_)
  {
    for (size_t i = 0; i < 4; ++i)
    {
      const int a = face.corners[i], b = face.corners[(i + 1) % 4];
      edges.insert({ std::min(a, b), std::max(a, b) });
    }
  }
  edges_.assign(edges.begin(), edges.end());
}

/// From each voxel's centre to the centres of its sides.
std::vector<std::array<Eigen::Vector3d, RobotMesh::SIDES>> RobotMesh::sideCenters(const RobotFrame& frame) const
{
  std::vector<std::array<Eigen::Vector3d, SIDES>> centers(frame.parts.size());
  for (size_t voxel = 0; voxel < frame.parts.size(); ++voxel)
  {
    const ShownPart& shown = frame.parts[voxel];
    const Eigen::Matrix3d axes = shown.orientation.toRotationMatrix();
    for (size_t axis = 0; axis < 3; ++axis)
    {
      for (const int upper : { 0, 1 })
      {
        const int neighbour = neighbours_[voxel][side(axis, upper)];
        const double sign = upper == 1 ? 0.5 : -0.5;
        centers[voxel][side(axis, upper)] =
            neighbour == NO_NEIGHBOUR
                ? Eigen::Vector3d(sign * shown.present_length * axes.col(static_cast<Eigen::Index>(axis)))
                : Eigen::Vector3d(0.5 * (frame.parts[static_cast<size_t>(neighbour)].position - shown.position));
      }
    }
  }
  return centers;
}

std::vector<Eigen::Vector3d> RobotMesh::vertices(const RobotFrame& frame) const
{
  const auto centers = sideCenters(frame);
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(vertex_voxels_.size());
  for (const std::vector<Corner>& corners : vertex_voxels_)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Corner& corner : corners)
    {
      const auto voxel = static_cast<size_t>(corner.voxel);
      sum += frame.parts[voxel].position + centers[voxel][side(0, corner.upper[0])] +
             centers[voxel][side(1, corner.upper[1])] + centers[voxel][side(2, corner.upper[2])];
    }
    vertices.push_back(sum / static_cast<double>(corners.size()));
  }
  return vertices;
}

Eigen::Vector3d faceNormal(const RobotMesh::Face& face, const std::vector<Eigen::Vector3d>& vertices)
{
  const auto corner = [&](size_t i) -> const Eigen::Vector3d&
  { return vertices[static_cast<size_t>(face.corners[i])]; };
  return (corner(2) - corner(0)).cross(corner(3) - corner(1)).normalized();
}
}  // namespace devo_evo
