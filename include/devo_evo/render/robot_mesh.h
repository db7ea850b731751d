#pragma once

#include "devo_evo/render/life_playback.h"
#include "devo_evo/soft_body/settings.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace devo_evo
{
/// The surface of a body as deformed blocks, one a voxel: what the lattice's shape decides, for every frame of any
/// robot on it. Blocks that are neighbours share the vertices between them, which lie where the bonds have their
/// middles; a face without neighbour lies half the voxel's present length from its centre. So the surface is closed.
class RobotMesh
{
public:
  /// A side of a voxel without a neighbour there.
  struct Face
  {
    int voxel;
    std::array<int, 4> corners;  ///< vertices, counter-clockwise as seen from outside
  };

  explicit RobotMesh(const SoftBodySettings& settings);

  /// Faces by voxel, those of one voxel in the order -x, +x, -y, +y, -z, +z of its sides.
  const std::vector<Face>& faces() const { return faces_; }

  /// Pairs of vertices that are joined by an edge of a face, each pair once.
  const std::vector<std::array<int, 2>>& edges() const { return edges_; }

  /// Corners of the lattice, (grid_x + 1) (grid_y + 1) (grid_z + 1); x runs fastest, then y. Those inside the body are
  /// there too, but belong to no face.
  int vertexCount() const { return static_cast<int>(vertex_voxels_.size()); }

  /// Where the vertices are, in the world frame [m]. @pre the frame has as many voxels as the settings.
  std::vector<Eigen::Vector3d> vertices(const RobotFrame& frame) const;

private:
  static constexpr int SIDES = 6;
  static constexpr int NO_NEIGHBOUR = -1;

  int vertexIndex(const std::array<int, 3>& place) const;
  void addFacesOf(int voxel, const std::array<int, 3>& place);
  void addEdges();
  std::vector<std::array<Eigen::Vector3d, SIDES>> sideCenters(const RobotFrame& frame) const;

  /// A voxel at a vertex, and which of its corners is there: for each axis, 0 the lower or 1 the upper side.
  struct Corner
  {
    int voxel;
    std::array<int, 3> upper;
  };

  std::array<int, 3> grid_;
  std::vector<std::array<int, SIDES>> neighbours_;  ///< of each voxel, in the order of sides
  std::vector<std::vector<Corner>> vertex_voxels_;
  std::vector<Face> faces_;
  std::vector<std::array<int, 2>> edges_;
};

/// Unit normal of a face, pointing outwards; of a warped face, that of its mean plane.
Eigen::Vector3d faceNormal(const RobotMesh::Face& face, const std::vector<Eigen::Vector3d>& vertices);
}  // namespace devo_evo
