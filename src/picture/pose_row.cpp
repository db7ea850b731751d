#include "picture/pose_row.h"

#include "devo_evo/picture/robot_scene.h"
#include "devo_evo/picture/scene_painter.h"
#include "devo_evo/soft_body/text.h"

#include <cmath>

namespace devo_evo
{
Image paintPoses(const Appearance& appearance, const std::vector<RobotFrame>& frames, Colouring colouring, int width,
                 int height)
{
  const Surroundings surroundings = appearance.surroundings();
  const double size = surroundings.body_size, count = static_cast<double>(frames.size());
  const double aspect = static_cast<double>(width) / height;
  Camera camera;
  camera.field_of_view = 0.0;
  camera.azimuth = 0.38;
  camera.elevation = 0.30;
  // Bodies grow to 1.75 times their nominal size, and stand askew.
  constexpr double room = 2.1, headroom = 2.2;
  camera.height = std::max(headroom * size, room * size * count / aspect);
  camera.distance = 20.0 * size * count;
  camera.target = Eigen::Vector3d(0.0, 0.0, 0.36 * camera.height);
  const double spacing = camera.height * aspect / count;

  const Eigen::Vector3f right(static_cast<float>(-std::sin(camera.azimuth)),
                              static_cast<float>(std::cos(camera.azimuth)), 0.0f);
  Scene scene;
  scene.body_size = static_cast<float>(size);
  scene.floor.lines = false;
  scene.floor.colour = scene.floor.background = Eigen::Vector3f::Ones();
  scene.floor.fade_start = static_cast<float>(4.0 * size * count);
  scene.floor.fade_end = 2.0f * scene.floor.fade_start;
  for (size_t i = 0; i < frames.size(); ++i)
  {
    const double place = spacing * (static_cast<double>(i) + 0.5 - 0.5 * count);
    Eigen::Vector3f center = surroundings.onFloor(frames[i].center_of_mass).cast<float>();
    center.z() = 0.0f;
    for (ColouredTriangles& triangles : robotTriangles(appearance, frames[i], colouring))
    {
      for (Eigen::Vector3f& corner : triangles.corners)
      {
        corner += static_cast<float>(place) * right - center;
      }
      scene.bodies.push_back(std::move(triangles));
    }
  }
  return ScenePainter(width, height).paint(scene, camera);
}

std::vector<RobotFrame> framesAt(const ShownRobot& robot, const std::vector<double>& times)
{
  LifePlayback playback(robot.body, robot.program);
  std::vector<RobotFrame> frames;
  for (const double time : times)
  {
    const bool reached = playback.advanceTo(time) || (playback.finished() && !playback.diverged());
    RobotFrame frame = reached ? playback.frame() : RobotFrame();
    if (!reached || !frame.finite())
    {
      throw PictureError("robot " + robot.name + ": its simulation diverges before " + toText(time) + " s after birth");
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

std::vector<double> equalTimes(double from, double to, int count)
{
  std::vector<double> times;
  for (int i = 0; i < count; ++i)
  {
    times.push_back(from + (to - from) * i / (count - 1));
  }
  return times;
}
}  // namespace devo_evo
