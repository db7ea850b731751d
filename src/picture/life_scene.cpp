#include "devo_evo/picture/life_scene.h"

#include "devo_evo/picture/image.h"
#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr double FOLLOWING_TIME = 0.3;  // of the camera [s]
constexpr double END = std::numeric_limits<double>::infinity();

Eigen::Vector2f onFloor(const Eigen::Vector3d& point)
{
  return point.head<2>().cast<float>();
}

/// Every fifth line across the way, darker.
void addFifthLines(Scene& scene, const Eigen::Vector3d& birthplace, const Camera& camera, double body_length)
{
  const double reach = scene.floor.fade_end;
  const double spacing = 5.0 * body_length;
  const double first = std::ceil((camera.target.y() - reach - birthplace.y()) / spacing);
  for (double k = first; birthplace.y() + k * spacing < camera.target.y() + reach; ++k)
  {
    const auto y = static_cast<float>(birthplace.y() + k * spacing);
    const auto x = static_cast<float>(camera.target.x());
    FloorLine line;
    line.points = { { x - 8 * scene.body_size, y }, { x + 8 * scene.body_size, y } };
    line.width = 0.035f * scene.body_size;
    line.colour = Eigen::Vector3f(0.55f, 0.56f, 0.58f);
    line.opacity = 0.6f;
    scene.floor_lines.push_back(line);
  }
}
}  // namespace

std::string treatmentTitle(const std::string& name)
{
  const std::string devo = "evo_devo";
  if (name.rfind(devo, 0) != 0)
  {
    return name == "evo" ? "Evo" : name;
  }
  const std::string part = name.size() > devo.size() ? name.substr(devo.size() + 1) : "";
  return part.empty() ? "Evo-Devo" : "Evo-Devo, " + part + " alone";
}

std::string descriptionOf(const ShownRobot& robot)
{
  if (!robot.descent)
  {
    return "from a file";
  }
  const Descent& descent = *robot.descent;
  return treatmentTitle(descent.treatment) + "  \u00b7  trial " + toText(descent.trial) +
         "  \u00b7  born in generation " + toText(descent.generation) + "  \u00b7  age " + toText(descent.age);
}

Viewpoint viewpointFor(const Surroundings& surroundings)
{
  Viewpoint viewpoint;
  if (surroundings.light)
  {
    viewpoint.azimuth = -1.15;
    viewpoint.elevation = 0.16;
    viewpoint.distance = 6.5;
    viewpoint.field_of_view = 0.55;
  }
  return viewpoint;
}

LifeScene::LifeScene(const ShownRobot& robot, const ViewOptions& options)
  : robot_(robot)
  , options_(options)
  , appearance_(makeAppearance(robot.body))
  , surroundings_(appearance_->surroundings())
  , lifetime_(makeBody(robot.body)->lifetime())
  , playback_(robot.body, robot.program)
  , following_(options.interval, FOLLOWING_TIME)
{
  if (!playback_.advanceTo(0.0))
  {
    throw PictureError("robot " + robot.name + ": its simulation diverges before there is anything to be seen");
  }
  frame_ = playback_.frame();
  birthplace_ = place();
  camera_.slope = surroundings_.slope;
  const Viewpoint viewpoint = options.viewpoint.value_or(viewpointFor(surroundings_));
  camera_.distance = viewpoint.distance * surroundings_.body_size;
  camera_.azimuth = viewpoint.azimuth;
  camera_.elevation = viewpoint.elevation;
  camera_.field_of_view = viewpoint.field_of_view;
  take();
}

bool LifeScene::next()
{
  if (playback_.finished())
  {
    return false;
  }
  next_time_ += options_.interval;
  playback_.advanceTo(next_time_ < lifetime_ ? next_time_ : END);
  if (playback_.diverged())
  {
    return false;
  }
  const RobotFrame frame = playback_.frame();
  if (!frame.finite())
  {
    return false;
  }
  frame_ = frame;
  take();
  return true;
}

void LifeScene::take()
{
  trace_.add(frame_.time_since_birth, place());
  const Eigen::Vector3d followed = following_.follow(place());
  camera_.target = Eigen::Vector3d(followed.x(), followed.y(), 0.35 * surroundings_.body_size);
}

Scene LifeScene::scene() const
{
  Scene scene;
  scene.body_size = static_cast<float>(surroundings_.body_size);
  scene.floor.line_distance = static_cast<float>(surroundings_.body_length);
  scene.floor.line_origin = onFloor(birthplace_);
  scene.floor.fade_start = 5.0f * scene.body_size;
  scene.floor.fade_end = (surroundings_.light ? 40.0f : 16.0f) * scene.body_size;
  scene.bodies = robotTriangles(*appearance_, frame_, options_.colouring);
  scene.scenery = lightTriangles(surroundings_);
  addFifthLines(scene, birthplace_, camera_, surroundings_.body_length);

  FloorLine path;
  path.width = 0.06f * scene.body_size;
  path.colour = Eigen::Vector3f(0.16f, 0.36f, 0.55f);
  path.opacity = 0.75f;
  const double reach = scene.floor.fade_end;
  for (const Eigen::Vector3d& place : trace_.path())
  {
    if ((place - this->place()).norm() < reach)
    {
      path.points.push_back(onFloor(place));
    }
  }
  scene.floor_lines.push_back(path);

  // An arrow as long as the way of half a second, ahead of the robot on the floor.
  const Eigen::Vector2f velocity = onFloor(trace_.velocity());
  if (velocity.norm() > 0.05f * scene.body_size)
  {
    FloorLine arrow;
    const Eigen::Vector2f start = onFloor(place()) + 0.85f * scene.body_size * velocity.normalized();
    arrow.points = { start, start + 0.35f * velocity };
    arrow.width = 0.08f * scene.body_size;
    arrow.colour = Eigen::Vector3f(0.84f, 0.30f, 0.16f);
    arrow.opacity = 0.9f;
    arrow.arrow = true;
    scene.floor_lines.push_back(arrow);
  }
  return scene;
}

Readings LifeScene::readings() const
{
  Readings readings;
  readings.name = "Robot " + robot_.name;
  readings.description = descriptionOf(robot_);
  readings.time_since_birth = frame_.time_since_birth;
  readings.lifetime = lifetime_;
  readings.travelled = (place().y() - birthplace_.y()) / surroundings_.body_length;
  readings.velocity = trace_.velocity().y() / surroundings_.body_length;
  if (surroundings_.light)
  {
    readings.to_light = (*surroundings_.light - frame_.center_of_mass).norm();
    readings.slope = surroundings_.slope;
  }
  readings.velocities = evaluation().velocity_body_lengths_per_s;
  return readings;
}

std::vector<FloorMark> floorMarks(const Eigen::Vector3d& birthplace, const Camera& camera, double body_length,
                                  double body_size)
{
  const double reach = 4.5 * body_size;
  const double travelled = (camera.target.y() - birthplace.y()) / body_length;
  const int first = static_cast<int>(std::ceil(travelled - reach / body_length));
  const int last = static_cast<int>(std::floor(travelled + reach / body_length));
  std::vector<FloorMark> marks;
  for (int k = first; k <= last; ++k)
  {
    marks.push_back({ { camera.target.x() + 1.9 * body_size, birthplace.y() + k * body_length, 0.0 }, k });
  }
  return marks;
}
}  // namespace devo_evo
