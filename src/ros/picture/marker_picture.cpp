#include "ros/picture/marker_picture.h"

#include "devo_evo/soft_body/settings.h"
#include "devo_evo/soft_body/text.h"
#include "picture/canvas.h"
#include "picture/overlay.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace devo_evo
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr size_t MOST_POINTS = 20000000;
constexpr size_t MOST_MARKERS = 10000;
constexpr double FARTHEST = 1e4;  // [m]

Eigen::Vector3d positionOf(const geometry_msgs::Point& point)
{
  return { point.x, point.y, point.z };
}

bool withinReach(const geometry_msgs::Point& point)
{
  return positionOf(point).cwiseAbs().maxCoeff() < FARTHEST;  // false for NaN
}

void check(const Marker& marker)
{
  const auto refuse = [&](const std::string& why)
  { throw InvalidInput("marker " + marker.ns.substr(0, 100) + ": " + why); };
  if (marker.points.size() > MOST_POINTS)
  {
    refuse(toText(static_cast<int64_t>(marker.points.size())) + " points are too many");
  }
  if (!withinReach(marker.pose.position) || !std::all_of(marker.points.begin(), marker.points.end(), withinReach))
  {
    refuse("a point is not finite, or too far away");
  }
  if (marker.type == Marker::TRIANGLE_LIST &&
      (marker.points.size() % 3 != 0 || (!marker.colors.empty() && marker.colors.size() != marker.points.size())))
  {
    refuse("triangles need three points each, and a colour for each point or for none");
  }
  if (marker.type == Marker::LINE_LIST && marker.points.size() % 2 != 0)
  {
    refuse("lines need two points each");
  }
}

Eigen::Vector3f colourOf(const std_msgs::ColorRGBA& colour)
{
  return Eigen::Vector3f(colour.r, colour.g, colour.b).cwiseMax(0.0f).cwiseMin(1.0f);
}

/// @param surroundings whose floor the triangles are to stand on.
ColouredTriangles trianglesOf(const Marker& marker, const Surroundings& surroundings)
{
  ColouredTriangles triangles;
  const Eigen::Matrix3f to_floor = surroundings.floorToWorld().conjugate().toRotationMatrix().cast<float>();
  bool smooth = false;  // whether a triangle is shaded
  for (size_t i = 0; i < marker.points.size(); ++i)
  {
    triangles.corners.emplace_back(to_floor * positionOf(marker.points[i]).cast<float>());
    triangles.colours.push_back(colourOf(marker.colors.empty() ? marker.color : marker.colors[i]));
    smooth = smooth || triangles.colours[i] != triangles.colours[i - i % 3];
  }
  for (size_t i = 0; smooth && i < triangles.corners.size(); i += 3)
  {
    const Eigen::Vector3f* corners = triangles.corners.data() + i;
    triangles.normals.insert(triangles.normals.end(), 3,
                             (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized());
  }
  return triangles;
}

FloorLine floorLine(const Marker& marker, size_t first, size_t last, const Surroundings& surroundings)
{
  FloorLine line;
  for (size_t i = first; i < last; ++i)
  {
    line.points.push_back(surroundings.onFloor(positionOf(marker.points[i])).head<2>().cast<float>());
  }
  line.width = static_cast<float>(std::clamp(marker.scale.x, 1e-5, 1.0));
  line.colour = colourOf(marker.color);
  return line;
}

Eigen::AlignedBox3d boxOf(const Marker& marker)
{
  Eigen::AlignedBox3d box;
  for (const geometry_msgs::Point& point : marker.points)
  {
    box.extend(positionOf(point));
  }
  return box;
}
}  // namespace

MarkerPicture::MarkerPicture(int width, int height, double interval)
  : painter_(width, height), width_(width), height_(height), following_(interval, 0.3)
{
}

void MarkerPicture::add(const MarkerArray& markers)
{
  std::for_each(markers.markers.begin(), markers.markers.end(), check);
  for (const Marker& marker : markers.markers)
  {
    if (marker.action == Marker::DELETEALL)
    {
      markers_.clear();
    }
    else if (marker.action == Marker::DELETE)
    {
      markers_[marker.ns].erase(marker.id);
    }
    else if (markers_[marker.ns].size() < MOST_MARKERS)
    {
      markers_[marker.ns][marker.id] = marker;
    }
  }
  if (marker("body") == nullptr || marker("body")->points.empty())
  {
    markers_.erase("body");
  }
  else if (body_size_ == 0.0)
  {
    body_size_ = std::max(1e-6, boxOf(*marker("body")).sizes().maxCoeff());
  }
}

const visualization_msgs::Marker* MarkerPicture::marker(const std::string& name_space) const
{
  const auto found = markers_.find(name_space);
  return found == markers_.end() || found->second.empty() ? nullptr : &found->second.begin()->second;
}

/// The floor's slope and the light, as markers tell.
Surroundings MarkerPicture::surroundingsOf() const
{
  Surroundings surroundings;
  surroundings.body_size = body_size_;
  const Marker* floor = marker("floor");
  if (floor != nullptr && floor->points.size() >= 3)
  {
    const Eigen::Vector3d corner = positionOf(floor->points[0]);
    const Eigen::Vector3d normal = (positionOf(floor->points[1]) - corner).cross(positionOf(floor->points[2]) - corner);
    surroundings.slope = normal.z() > 0.0 ? std::atan2(normal.y(), normal.z()) : 0.0;
  }
  if (const Marker* light = marker("light"))
  {
    surroundings.light = positionOf(light->pose.position);
  }
  return surroundings;
}

void MarkerPicture::follow()
{
  const Marker* parts = marker("parts") != nullptr ? marker("parts") : marker("body");
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const geometry_msgs::Point& point : parts->points)
  {
    center += positionOf(point) / static_cast<double>(parts->points.size());
  }
  const Eigen::Vector3d followed = following_.follow(surroundings_.onFloor(center));
  const Viewpoint viewpoint = viewpointFor(surroundings_);
  camera_.slope = surroundings_.slope;
  camera_.azimuth = viewpoint.azimuth;
  camera_.elevation = viewpoint.elevation;
  camera_.target = { followed.x(), followed.y(), 0.35 * body_size_ };
  camera_.distance = 7.5 * body_size_;
}

Scene MarkerPicture::scene() const
{
  Scene scene;
  scene.body_size = static_cast<float>(body_size_);
  scene.floor.lines = false;
  scene.floor.fade_start = 5.0f * scene.body_size;
  scene.floor.fade_end = 16.0f * scene.body_size;
  for (const auto& [id, body] : markers_.at("body"))
  {
    scene.bodies.push_back(trianglesOf(body, surroundings_));
  }
  scene.scenery = lightTriangles(surroundings_);
  for (const char* lines : { "lines", "marked_lines" })
  {
    const Marker* marks = marker(lines);
    for (size_t i = 0; marks != nullptr && i + 1 < marks->points.size(); i += 2)
    {
      FloorLine line = floorLine(*marks, i, i + 2, surroundings_);
      line.width = std::max(line.width, 0.02f * scene.body_size);  // thinner ones would look dashed
      scene.floor_lines.push_back(line);
    }
  }
  if (const Marker* path = marker("path"))
  {
    scene.floor_lines.push_back(floorLine(*path, 0, path->points.size(), surroundings_));
  }
  const Marker* velocity = marker("velocity");
  if (velocity != nullptr && velocity->points.size() == 2)
  {
    FloorLine arrow = floorLine(*velocity, 0, 2, surroundings_);
    const Eigen::Vector2f way = arrow.points[1] - arrow.points[0];
    if (way.norm() > 0.05f * scene.body_size)
    {
      arrow.points[0] += 0.85f * scene.body_size * way.normalized();
      arrow.points[1] = arrow.points[0] + 0.7f * way;
      arrow.width = 0.08f * scene.body_size;
      arrow.arrow = true;
      scene.floor_lines.push_back(arrow);
    }
  }
  return scene;
}

Image MarkerPicture::paint()
{
  surroundings_ = surroundingsOf();
  follow();
  Image image = painter_.paint(scene(), camera_);
  Canvas canvas(image);
  const double scale = height_ / 720.0;
  const auto labels = markers_.find("labels");
  if (labels != markers_.end())
  {
    for (const auto& [id, label] : labels->second)
    {
      const Eigen::Vector3d place = surroundings_.onFloor(positionOf(label.pose.position));
      if ((place - camera_.target).norm() < 6.0 * body_size_)
      {
        const Eigen::Vector2d pixel = camera_.toPicture(place, width_, height_);
        canvas.drawText(pixel.x(), pixel.y(), label.text.substr(0, 20), 17 * scale, inks::GREY, Anchor::CENTER);
      }
    }
  }
  if (const Marker* caption = marker("caption"))
  {
    std::istringstream lines(caption->text.substr(0, 500));
    double y = 48 * scale;
    for (std::string line; std::getline(lines, line); y += 27 * scale)
    {
      const bool first = y < 50 * scale;
      canvas.drawText(32 * scale, y, line, (first ? 22 : 16) * scale, first ? inks::DARK : inks::GREY, Anchor::LEFT,
                      first);
    }
  }
  return image;
}
}  // namespace devo_evo
