#pragma once

#include <Eigen/Core>

#include <vector>

namespace devo_evo
{
// What a picture shows. Positions are in a frame that lies on the floor: right-handed, metres, the floor at z = 0,
// which is frame `world` where the floor is level. Colours are red, green and blue from 0 to 1.

/// A surface of triangles. Without normals they are flat: two in a row that share two corners make one face, whose
/// outline is drawn, while the line between them is not.
struct ColouredTriangles
{
  std::vector<Eigen::Vector3f> corners;  ///< three per triangle, seen counter-clockwise from outside [m]
  std::vector<Eigen::Vector3f> colours;  ///< of each corner [1]
  std::vector<Eigen::Vector3f> normals;  ///< of each corner of a smooth surface, which has no outlines; else empty
};

/// A line drawn flat on the floor.
struct FloorLine
{
  std::vector<Eigen::Vector2f> points;  ///< x, y [m]
  float width = 0.002f;                 ///< [m]
  Eigen::Vector3f colour{ 0.2f, 0.2f, 0.2f };
  float opacity = 1.0f;
  bool arrow = false;  ///< whether it ends in an arrow's head
};

/// The floor: an endless plane with lines at equal distances, which fades out away from the camera's target.
struct Floor
{
  bool lines = true;
  float line_distance = 0.04f;                       ///< [m]; one body length makes the lines a scale
  Eigen::Vector2f line_origin{ 0.0f, 0.0f };         ///< where two lines cross [m]
  Eigen::Vector3f colour{ 0.953f, 0.949f, 0.941f };  ///< of the floor
  Eigen::Vector3f line_colour{ 0.80f, 0.80f, 0.79f };
  Eigen::Vector3f background{ 0.985f, 0.985f, 0.985f };  ///< what it fades to
  float fade_start = 0.35f, fade_end = 1.1f;             ///< distances from the target [m]
};

struct Scene
{
  std::vector<ColouredTriangles> bodies;
  std::vector<ColouredTriangles> scenery;  ///< drawn like bodies, but without shadows: it may stand far away
  std::vector<FloorLine> floor_lines;
  Floor floor;
  float body_size = 0.04f;  ///< of what is shown: shadows are soft in proportion [m]
};

/// Where one looks from: a point at a distance from the target. It stands level, whatever the floor's slope.
struct Camera
{
  Eigen::Vector3d target{ 0.0, 0.0, 0.0 };  ///< in the middle of the picture [m]
  double distance = 0.36;                   ///< from the target [m]
  double azimuth = 0.0;         ///< 0: from +x, so that +y is to the right; positive: turned towards +y [rad]
  double elevation = 0.4;       ///< above the horizontal [rad]
  double slope = 0.0;           ///< by which the floor descends towards +y [rad]
  double field_of_view = 0.42;  ///< of the picture's height [rad]; 0: parallel projection
  double height = 0.16;         ///< what the picture's height shows, if the projection is parallel [m]

  /// The scene's frame to clip coordinates, as OpenGL has them.
  Eigen::Matrix4d projection(double aspect_ratio) const;

  /// Where a point appears in a picture: x to the right, y down [pixels].
  Eigen::Vector2d toPicture(const Eigen::Vector3d& point, int width, int height) const;
};
}  // namespace devo_evo
