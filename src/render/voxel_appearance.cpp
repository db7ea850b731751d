#include "devo_evo/render/robot_mesh.h"
#include "devo_evo/soft_body/lattice.h"
#include "devo_evo/soft_body/text.h"
#include "render/body_kinds.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
constexpr double LENGTH_SPAN = 1.5;  // from the smallest to the largest resting length, in units of L

class VoxelAppearance : public Appearance
{
public:
  explicit VoxelAppearance(const SoftBodySettings& settings) : settings_(settings), mesh_(settings) {}

  Surroundings surroundings() const override
  {
    Surroundings surroundings;
    surroundings.body_size = settings_.voxel_size * std::max({ settings_.grid_x, settings_.grid_y, settings_.grid_z });
    surroundings.body_length = settings_.voxel_size * settings_.grid_y;
    surroundings.stroke = settings_.voxel_size;
    return surroundings;
  }

  std::vector<Surface> surfaces(const RobotFrame& frame, Colouring colouring) const override
  {
    const std::vector<Eigen::Vector3d> vertices = mesh_.vertices(frame);
    Surface surface;
    surface.flat = true;
    for (const RobotMesh::Face& face : mesh_.faces())
    {
      const Colour colour = colourOf(frame, static_cast<size_t>(face.voxel), colouring);
      const Eigen::Vector3d normal = faceNormal(face, vertices);
      for (const size_t corner : { 0, 1, 2, 0, 2, 3 })
      {
        surface.corners.push_back(vertices[static_cast<size_t>(face.corners[corner])]);
        surface.normals.push_back(normal);
        surface.colours.push_back(colour);
      }
    }
    return { surface };
  }

  std::vector<std::array<Eigen::Vector3d, 2>> edges(const RobotFrame& frame) const override
  {
    const std::vector<Eigen::Vector3d> vertices = mesh_.vertices(frame);
    std::vector<std::array<Eigen::Vector3d, 2>> edges;
    for (const auto& [first, second] : mesh_.edges())
    {
      edges.push_back({ vertices[static_cast<size_t>(first)], vertices[static_cast<size_t>(second)] });
    }
    return edges;
  }

  Colour colourOf(const RobotFrame& frame, size_t part, Colouring colouring) const override
  {
    const ShownPart& voxel = frame.parts[part];
    const double range = LENGTH_SPAN * settings_.voxel_size;
    return colourOfPart(voxel, colouring, voxel.resting_length / range - 0.1, voxel.present_length / range - 0.1,
                        voxel.remaining_development / range + 0.5);
  }

  ColourBar colourBar(Colouring colouring) const override
  {
    const double L = 100 * settings_.voxel_size;  // [cm]
    const std::string low = fixedText(0.15 * L, 2) + " cm", high = fixedText(1.65 * L, 2) + " cm";
    switch (colouring)
    {
      case Colouring::RESTING_LENGTH:
        return { "resting length of voxels", low, high };
      case Colouring::PRESENT_LENGTH:
        return { "present length of voxels", low, high };
      case Colouring::REMAINING_DEVELOPMENT:
        return { "development to come", "\u2212" + fixedText(0.75 * L, 2) + " cm",
                 "+" + fixedText(0.75 * L, 2) + " cm" };
      case Colouring::PHASE:
        break;
    }
    return { "phase of actuation", "\u2212\u00bd cycle", "+\u00bd cycle" };
  }

  std::vector<size_t> measuredParts() const override
  {
    const Lattice lattice(settings_);
    return { lattice.surface().begin(), lattice.surface().end() };
  }

  std::string partName(size_t part) const override { return "voxel " + toText(static_cast<int64_t>(part)); }
  double actuationFrequency() const override { return settings_.actuation_frequency; }

private:
  const SoftBodySettings settings_;
  const RobotMesh mesh_;
};
}  // namespace

std::shared_ptr<const Appearance> makeVoxelAppearance(const SoftBodySettings& settings)
{
  return std::make_shared<VoxelAppearance>(settings);
}
}  // namespace devo_evo
