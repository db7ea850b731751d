#pragma once

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/render/colouring.h"
#include "devo_evo/render/life_playback.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
/// How large the robots of a body are, and where they live. World frame: right-handed, z up.
struct Surroundings
{
  double body_size = 0.0;                ///< longest side, for cameras and shadows [m]
  double body_length = 0.0;              ///< unit of distances [m]
  double stroke = 0.0;                   ///< unit of the thickness of lines and the height of letters [m]
  double slope = 0.0;                    ///< by which the floor, a plane through the origin, descends towards +y [rad]
  std::optional<Eigen::Vector3d> light;  ///< where the light stands that robots seek [m]; none: they seek none

  /// A frame that lies on the floor, z its normal and y downhill, to the world: no change if the floor is level.
  Eigen::Quaterniond floorToWorld() const;

  /// A place of the world in the floor's frame [m].
  Eigen::Vector3d onFloor(const Eigen::Vector3d& place) const { return floorToWorld().conjugate() * place; }
};

/// Part of what is seen of a robot.
struct Surface
{
  std::vector<Eigen::Vector3d>
      corners;  ///< three per triangle, counter-clockwise as seen from outside; world frame [m]
  std::vector<Eigen::Vector3d>
      normals;                  ///< of each corner, outwards. On a flat face, two triangles in a row, all alike
  std::vector<Colour> colours;  ///< of each corner
  bool flat = false;            ///< whether it consists of flat faces, which have outlines
};

/// What a colour bar says.
struct ColourBar
{
  std::string title, low, high;
};

/// How the robots of one body look; the same for all of them. Immutable.
class Appearance
{
public:
  virtual ~Appearance() = default;

  virtual Surroundings surroundings() const = 0;

  /// What is seen of a robot: of a soft body one surface, of the quadruped one for each part, in their order.
  virtual std::vector<Surface> surfaces(const RobotFrame& frame, Colouring colouring) const = 0;

  /// Lines along which faces meet, pairs of ends; none on smooth surfaces. World frame [m].
  virtual std::vector<std::array<Eigen::Vector3d, 2>> edges(const RobotFrame& frame) const = 0;

  /// Of a part, in its colouring.
  virtual Colour colourOf(const RobotFrame& frame, size_t part, Colouring colouring) const = 0;

  virtual ColourBar colourBar(Colouring colouring) const = 0;

  /// Parts whose length is of interest: voxels at the surface, legs. @return places in RobotFrame::parts, ascending.
  virtual std::vector<size_t> measuredParts() const = 0;

  /// For people: "voxel 17", "leg 2".
  virtual std::string partName(size_t part) const = 0;

  /// Of actuation [Hz].
  virtual double actuationFrequency() const = 0;
};

/// @throw InvalidInput if the settings are invalid.
std::shared_ptr<const Appearance> makeAppearance(const BodySettings& body);
}  // namespace devo_evo
