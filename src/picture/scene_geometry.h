#pragma once

#include "devo_evo/picture/scene.h"

#include <vector>

namespace devo_evo
{
// Scenes as OpenGL takes them: rows of floats.

/// Per corner: position, normal of its face or its own, colour, and distances from the three edges of its triangle: 1
/// at the opposite corner, 0 on the edge; 1 all over for an edge that is no outline.
std::vector<float> bodyVertices(const std::vector<ColouredTriangles>& bodies);

/// Triangles. Per corner: x, y, colour, opacity, and distances from the three edges at which the line must look smooth,
/// 0 on the edge.
std::vector<float> floorLineVertices(const std::vector<FloorLine>& lines);

/// The part of the floor that the bodies' shadows lie on, with a margin.
struct ShadowArea
{
  Eigen::Vector2f center{ 0.0f, 0.0f }, extent{ 0.1f, 0.1f };  ///< half the sides [m]
};

/// @param to_light direction towards the lamp.
ShadowArea shadowArea(const std::vector<ColouredTriangles>& bodies, const Eigen::Vector3f& to_light, float margin);

/// A rectangle of a picture [pixels].
struct PictureArea
{
  int x = 0, y = 0, width = 0, height = 0;
};

/// Where bodies are in a picture, with a margin for their outlines: everywhere, if one is behind the camera.
/// @param projection the scene's frame to clip coordinates.
PictureArea pictureArea(const std::vector<ColouredTriangles>& bodies, const Eigen::Matrix4f& projection, int width,
                        int height);

/// Softens one channel of a picture of bytes, close to a Gaussian: three running means along rows and columns.
/// @param radius of each mean [pixels].
void blur(std::vector<uint8_t>& channel, int width, int height, int radius);
}  // namespace devo_evo
