#include "picture/scene_geometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace devo_evo
{
namespace
{
using Corners = const Eigen::Vector3f*;  // three of them

Eigen::Vector3f areaVector(Corners triangle)
{
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
}

/// For each corner of `a`, whether `b` has it too.
std::array<bool, 3> sharedCorners(Corners a, Corners b)
{
  std::array<bool, 3> shared{};
  for (size_t i = 0; i < 3; ++i)
  {
    shared[i] = std::find(b, b + 3, a[i]) != b + 3;
  }
  return shared;
}

void addCorner(std::vector<float>& vertices, const Eigen::Vector3f& place, const Eigen::Vector3f& normal,
               const Eigen::Vector3f& colour)
{
  for (const Eigen::Vector3f& vector : { place, normal, colour })
  {
    vertices.insert(vertices.end(), { vector.x(), vector.y(), vector.z() });
  }
}

void addTriangle(std::vector<float>& vertices, Corners corners, const Eigen::Vector3f* colours,
                 const Eigen::Vector3f& normal, const std::array<bool, 3>& shared, bool paired)
{
  for (size_t corner = 0; corner < 3; ++corner)
  {
    addCorner(vertices, corners[corner], normal, colours[corner]);
    for (size_t edge = 0; edge < 3; ++edge)  // the edge opposite to corner `edge`
    {
      const bool inner = paired && !shared[edge];
      vertices.push_back(inner || edge == corner ? 1.0f : 0.0f);
    }
  }
}

void addSmoothBody(std::vector<float>& vertices, const ColouredTriangles& body)
{
  for (size_t corner = 0; corner < body.corners.size(); ++corner)
  {
    addCorner(vertices, body.corners[corner], body.normals[corner], body.colours[corner]);
    vertices.insert(vertices.end(), { 1.0f, 1.0f, 1.0f });
  }
}

void addFlatBody(std::vector<float>& vertices, const ColouredTriangles& body)
{
  const size_t triangles = body.corners.size() / 3;
  for (size_t i = 0; i < triangles;)
  {
    Corners first = body.corners.data() + 3 * i, second = first + 3;
    const std::array<bool, 3> shared =
        i + 1 < triangles ? sharedCorners(first, second) : std::array<bool, 3>{ false, false, false };
    const bool paired = std::count(shared.begin(), shared.end(), true) == 2;
    const Eigen::Vector3f area = paired ? Eigen::Vector3f(areaVector(first) + areaVector(second)) : areaVector(first);
    const Eigen::Vector3f normal = area.normalized();
    addTriangle(vertices, first, body.colours.data() + 3 * i, normal, shared, paired);
    if (paired)
    {
      addTriangle(vertices, second, body.colours.data() + 3 * (i + 1), normal, sharedCorners(second, first), true);
    }
    i += paired ? 2 : 1;
  }
}

/// A corner of a floor line's triangles, and its distances from the edges.
struct LineCorner
{
  Eigen::Vector2f place;
  Eigen::Vector3f edges;
};

void addLineTriangle(std::vector<float>& vertices, const std::array<LineCorner, 3>& corners, const FloorLine& line)
{
  for (const LineCorner& corner : corners)
  {
    vertices.insert(vertices.end(),
                    { corner.place.x(), corner.place.y(), line.colour.x(), line.colour.y(), line.colour.z(),
                      line.opacity, corner.edges.x(), corner.edges.y(), corner.edges.z() });
  }
}

Eigen::Vector2f leftOf(const Eigen::Vector2f& direction)
{
  return { -direction.y(), direction.x() };
}

/// The line's points without those too close to the one before.
std::vector<Eigen::Vector2f> distinctPoints(const FloorLine& line)
{
  std::vector<Eigen::Vector2f> points;
  for (const Eigen::Vector2f& point : line.points)
  {
    if (points.empty() || (point - points.back()).norm() > 0.25f * line.width)
    {
      points.push_back(point);
    }
  }
  return points;
}

void addFloorLine(std::vector<float>& vertices, const FloorLine& line)
{
  std::vector<Eigen::Vector2f> points = distinctPoints(line);
  if (points.size() < 2)
  {
    return;
  }
  if (line.arrow)
  {
    const Eigen::Vector2f last = points.back() - points[points.size() - 2];
    const Eigen::Vector2f along = last.normalized(), tip = points.back();
    const float head = std::min(3.6f * line.width, last.norm());
    points.back() = tip - head * along;
    const Eigen::Vector2f side = 0.5f * head * leftOf(along);
    addLineTriangle(vertices,
                    { LineCorner{ tip, { 1, 0, 0 } }, LineCorner{ points.back() + side, { 0, 1, 0 } },
                      LineCorner{ points.back() - side, { 0, 0, 1 } } },
                    line);
  }
  // Sides are square to the mean direction at each point, so that pieces meet without gaps or overlaps.
  std::vector<Eigen::Vector2f> sides;
  for (size_t i = 0; i < points.size(); ++i)
  {
    const Eigen::Vector2f& before = points[i == 0 ? 0 : i - 1];
    const Eigen::Vector2f& after = points[std::min(i + 1, points.size() - 1)];
    sides.push_back(0.5f * line.width * leftOf(Eigen::Vector2f(after - before).normalized()));
  }
  for (size_t i = 1; i < points.size(); ++i)
  {
    const Eigen::Vector3f left(0, 2, 1), right(2, 0, 1);
    const LineCorner a{ points[i - 1] - sides[i - 1], right }, b{ points[i] - sides[i], right };
    const LineCorner c{ points[i] + sides[i], left }, d{ points[i - 1] + sides[i - 1], left };
    addLineTriangle(vertices, { a, b, c }, line);
    addLineTriangle(vertices, { a, c, d }, line);
  }
}

/// Running mean of a row or column with its ends continued.
void smoothLine(uint8_t* first, int count, int stride, int radius, std::vector<uint8_t>& scratch)
{
  const auto at = [&](int i) { return static_cast<int>(first[std::clamp(i, 0, count - 1) * stride]); };
  int sum = 0;
  for (int i = -radius; i <= radius; ++i)
  {
    sum += at(i);
  }
  const int span = 2 * radius + 1;
  for (int i = 0; i < count; ++i)
  {
    scratch[static_cast<size_t>(i)] = static_cast<uint8_t>((sum + span / 2) / span);
    sum += at(i + radius + 1) - at(i - radius);
  }
  for (int i = 0; i < count; ++i)
  {
    first[i * stride] = scratch[static_cast<size_t>(i)];
  }
}
}  // namespace

std::vector<float> bodyVertices(const std::vector<ColouredTriangles>& bodies)
{
  constexpr size_t floats_per_corner = 12;
  std::vector<float> vertices;
  for (const ColouredTriangles& body : bodies)
  {
    vertices.reserve(vertices.size() + floats_per_corner * body.corners.size());
    body.normals.empty() ? addFlatBody(vertices, body) : addSmoothBody(vertices, body);
  }
  return vertices;
}

std::vector<float> floorLineVertices(const std::vector<FloorLine>& lines)
{
  std::vector<float> vertices;
  for (const FloorLine& line : lines)
  {
    addFloorLine(vertices, line);
  }
  return vertices;
}

ShadowArea shadowArea(const std::vector<ColouredTriangles>& bodies, const Eigen::Vector3f& to_light, float margin)
{
  Eigen::AlignedBox2f box;
  for (const ColouredTriangles& body : bodies)
  {
    for (const Eigen::Vector3f& corner : body.corners)
    {
      box.extend(corner.head<2>());
      box.extend(corner.head<2>() - to_light.head<2>() * (corner.z() / to_light.z()));
    }
  }
  if (box.isEmpty())
  {
    return {};
  }
  return { box.center(), 0.5f * box.sizes() + Eigen::Vector2f::Constant(margin) };
}

PictureArea pictureArea(const std::vector<ColouredTriangles>& bodies, const Eigen::Matrix4f& projection, int width,
                        int height)
{
  constexpr int margin = 3;  // [pixels]
  Eigen::AlignedBox2f box;
  for (const ColouredTriangles& body : bodies)
  {
    for (const Eigen::Vector3f& corner : body.corners)
    {
      const Eigen::Vector4f clip = projection * corner.homogeneous();
      if (clip.w() <= 0.0f)
      {
        return { 0, 0, width, height };
      }
      box.extend(Eigen::Vector2f(clip.head<2>() / clip.w()));
    }
  }
  if (box.isEmpty())
  {
    return {};
  }
  const auto pixel = [](float clip, int side)
  { return static_cast<int>((0.5f + 0.5f * std::clamp(clip, -1.1f, 1.1f)) * static_cast<float>(side)); };
  const int left = std::clamp(pixel(box.min().x(), width) - margin, 0, width);
  const int low = std::clamp(pixel(box.min().y(), height) - margin, 0, height);
  const int right = std::clamp(pixel(box.max().x(), width) + margin + 1, left, width);
  const int high = std::clamp(pixel(box.max().y(), height) + margin + 1, low, height);
  return { left, low, right - left, high - low };
}

void blur(std::vector<uint8_t>& channel, int width, int height, int radius)
{
  constexpr int passes = 3;
  std::vector<uint8_t> scratch(static_cast<size_t>(std::max(width, height)));
  for (int pass = 0; pass < passes; ++pass)
  {
    for (int row = 0; row < height; ++row)
    {
      smoothLine(channel.data() + row * width, width, 1, radius, scratch);
    }
    for (int column = 0; column < width; ++column)
    {
      smoothLine(channel.data() + column, height, width, radius, scratch);
    }
  }
}
}  // namespace devo_evo
