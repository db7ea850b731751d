#include "ros/scene_markers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace devo_evo
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

// Sizes in units of Surroundings::stroke, the side of a voxel.
constexpr double EDGE_WIDTH = 0.06;
constexpr double POINT_SIZE = 0.2;
constexpr double PATH_WIDTH = 0.12;
constexpr double ARROW_WIDTH = 0.35;
constexpr double ARROW_ABOVE = 4.0;  // over the centre of mass, where the body does not hide it
constexpr double CAPTION_HEIGHT = 0.9;
constexpr double CAPTION_ABOVE = 6.5;  // over the centre of mass
constexpr double LINE_WIDTH = 0.08;
constexpr double MARKED_LINE_WIDTH = 0.25;
constexpr double LABEL_HEIGHT = 1.6;
constexpr double LIGHT_SIZE = 2.4;
constexpr double ABOVE_FLOOR = 0.05;  // of lines, so that the floor does not hide them

const Colour DARK = { 0.13F, 0.13F, 0.15F };
const Colour FLOOR = { 0.93F, 0.93F, 0.91F };
const Colour LINES = { 0.72F, 0.72F, 0.70F };
const Colour MARKED_LINES = { 0.45F, 0.45F, 0.45F };
const Colour PATH = { 0.20F, 0.20F, 0.22F };
const Colour ARROW = { 0.85F, 0.10F, 0.45F };
const Colour LIGHT = { 1.0F, 0.80F, 0.15F };

/// Faces are the darker the less they look at the light, which comes from above, from behind and from the right.
double brightness(const Eigen::Vector3d& normal)
{
  static const Eigen::Vector3d light = Eigen::Vector3d(0.45, -0.35, 0.82).normalized();
  constexpr double darkest = 0.62;
  return darkest + (1.0 - darkest) * (0.5 + 0.5 * normal.dot(light));
}

Colour shaded(const Colour& colour, double brightness)
{
  const auto factor = static_cast<float>(brightness);
  return { factor * colour.red, factor * colour.green, factor * colour.blue };
}

std_msgs::ColorRGBA toMsg(const Colour& colour)
{
  std_msgs::ColorRGBA message;
  message.r = colour.red;
  message.g = colour.green;
  message.b = colour.blue;
  message.a = 1.0F;
  return message;
}

double rounded(double position)
{
  constexpr double fineness = 131072.0;  // 2^17
  return std::nearbyint(position * fineness) / fineness;
}
}  // namespace

const char* const WORLD_FRAME = "world";

SceneMarkers::SceneMarkers(const BodySettings& body, const Eigen::Vector3d& offset)
  : appearance_(makeAppearance(body)), surroundings_(appearance_->surroundings()), offset_(offset)
{
}

Marker SceneMarkers::marker(const std::string& name_space, int32_t type) const
{
  Marker marker;
  marker.header.frame_id = WORLD_FRAME;
  marker.ns = name_space;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color = toMsg(DARK);
  return marker;
}

geometry_msgs::Point SceneMarkers::point(const Eigen::Vector3d& position) const
{
  geometry_msgs::Point point;
  point.x = rounded(position.x() + offset_.x());
  point.y = rounded(position.y() + offset_.y());
  point.z = rounded(position.z() + offset_.z());
  return point;
}

MarkerArray SceneMarkers::robot(const RobotFrame& frame, Colouring colouring) const
{
  MarkerArray markers;
  for (const Surface& surface : appearance_->surfaces(frame, colouring))
  {
    Marker body = marker("body", Marker::TRIANGLE_LIST);
    body.id = static_cast<int32_t>(markers.markers.size());
    for (size_t corner = 0; corner < surface.corners.size(); ++corner)
    {
      body.points.push_back(point(surface.corners[corner]));
      body.colors.push_back(toMsg(shaded(surface.colours[corner], brightness(surface.normals[corner]))));
    }
    markers.markers.push_back(std::move(body));
  }
  Marker edges = marker("edges", Marker::LINE_LIST);
  edges.scale.x = EDGE_WIDTH * surroundings_.stroke;
  for (const auto& [first, second] : appearance_->edges(frame))
  {
    edges.points.push_back(point(first));
    edges.points.push_back(point(second));
  }
  if (!edges.points.empty())
  {
    markers.markers.push_back(std::move(edges));
  }
  Marker parts = marker("parts", Marker::POINTS);
  parts.scale.x = parts.scale.y = POINT_SIZE * surroundings_.stroke;
  for (size_t part = 0; part < frame.parts.size(); ++part)
  {
    parts.points.push_back(point(frame.parts[part].position));
    parts.colors.push_back(toMsg(appearance_->colourOf(frame, part, colouring)));
  }
  markers.markers.push_back(std::move(parts));
  return markers;
}

MarkerArray SceneMarkers::annotations(const RobotFrame& frame, const MotionTrace& trace,
                                      const std::string& caption) const
{
  const double L = surroundings_.stroke;
  Marker path = marker("path", Marker::LINE_STRIP);
  path.scale.x = PATH_WIDTH * L;
  path.color = toMsg(PATH);
  for (const Eigen::Vector3d& place : trace.path())
  {
    path.points.push_back(point(place));
  }
  Marker arrow = marker("velocity", Marker::ARROW);
  arrow.scale.x = ARROW_WIDTH * L;
  arrow.scale.y = 2.5 * ARROW_WIDTH * L;
  arrow.scale.z = 0.0;
  arrow.color = toMsg(ARROW);
  const Eigen::Vector3d tail = frame.center_of_mass + Eigen::Vector3d(0.0, 0.0, ARROW_ABOVE * L);
  arrow.points = { point(tail), point(tail + ARROW_TIME * trace.velocity()) };

  Marker text = marker("caption", Marker::TEXT_VIEW_FACING);
  text.pose.position = point(frame.center_of_mass + Eigen::Vector3d(0.0, 0.0, CAPTION_ABOVE * L));
  text.scale.z = CAPTION_HEIGHT * L;
  text.text = caption;
  MarkerArray markers;
  markers.markers = { path, arrow, text };
  return markers;
}

MarkerArray SceneMarkers::floor(const FloorPlan& plan) const
{
  const double L = surroundings_.stroke;
  const Eigen::Matrix3d to_world = surroundings_.floorToWorld().toRotationMatrix();
  const auto on_floor = [&](const Eigen::Vector3d& place, double height)
  { return point(to_world * (place + Eigen::Vector3d(0.0, 0.0, height))); };
  Marker area = marker("floor", Marker::TRIANGLE_LIST);
  area.color = toMsg(FLOOR);
  const Eigen::Vector2d low = plan.area.min(), high = plan.area.max();
  const std::array<Eigen::Vector3d, 4> corners = {
    { { low.x(), low.y(), 0.0 }, { high.x(), low.y(), 0.0 }, { high.x(), high.y(), 0.0 }, { low.x(), high.y(), 0.0 } }
  };
  for (const size_t corner : { 0, 1, 2, 0, 2, 3 })
  {
    area.points.push_back(on_floor(corners[corner], 0.0));
    area.colors.push_back(area.color);
  }

  const auto lines = [&](const char* name_space, const std::vector<FloorPlan::Line>& ways, double width, Colour colour)
  {
    Marker marker = this->marker(name_space, Marker::LINE_LIST);
    marker.scale.x = width * L;
    marker.color = toMsg(colour);
    for (const FloorPlan::Line& line : ways)
    {
      marker.points.push_back(on_floor(line[0], ABOVE_FLOOR * L));
      marker.points.push_back(on_floor(line[1], ABOVE_FLOOR * L));
    }
    return marker;
  };
  MarkerArray markers;
  markers.markers = { area, lines("lines", plan.lines, LINE_WIDTH, LINES),
                      lines("marked_lines", plan.marked_lines, MARKED_LINE_WIDTH, MARKED_LINES) };
  for (const auto& [place, text] : plan.labels)
  {
    Marker label = marker("labels", Marker::TEXT_VIEW_FACING);
    label.id = static_cast<int32_t>(markers.markers.size());
    label.pose.position = on_floor(place, LABEL_HEIGHT * L / 2.0);
    label.scale.z = LABEL_HEIGHT * L;
    label.color = toMsg(MARKED_LINES);
    label.text = text;
    markers.markers.push_back(label);
  }
  append(markers, light());
  return markers;
}

/// A ball on a post, where the light is.
MarkerArray SceneMarkers::light() const
{
  MarkerArray markers;
  if (!surroundings_.light)
  {
    return markers;
  }
  Marker ball = marker("light", Marker::SPHERE);
  ball.pose.position = point(*surroundings_.light);
  ball.scale.x = ball.scale.y = ball.scale.z = LIGHT_SIZE * surroundings_.stroke;
  ball.color = toMsg(LIGHT);
  Marker post = marker("post", Marker::CYLINDER);
  Eigen::Vector3d foot = surroundings_.onFloor(*surroundings_.light);
  const double height = foot.z();
  foot.z() *= 0.5;
  const Eigen::Quaterniond upright = surroundings_.floorToWorld();
  post.pose.position = point(upright * foot);
  post.pose.orientation.w = upright.w();
  post.pose.orientation.x = upright.x();
  post.pose.orientation.y = upright.y();
  post.pose.orientation.z = upright.z();
  post.scale.x = post.scale.y = 0.2 * ball.scale.x;
  post.scale.z = std::max(height, 1e-3);
  post.color = toMsg(MARKED_LINES);
  markers.markers = { ball, post };
  return markers;
}

MarkerArray nothing()
{
  MarkerArray markers;
  markers.markers.resize(1);
  markers.markers.front().header.frame_id = WORLD_FRAME;
  markers.markers.front().action = Marker::DELETEALL;
  return markers;
}

void setStamp(MarkerArray& markers, const ros::Time& stamp)
{
  for (Marker& marker : markers.markers)
  {
    marker.header.stamp = stamp;
  }
}

void append(MarkerArray& markers, MarkerArray more)
{
  markers.markers.insert(markers.markers.end(), std::make_move_iterator(more.markers.begin()),
                         std::make_move_iterator(more.markers.end()));
}
}  // namespace devo_evo
