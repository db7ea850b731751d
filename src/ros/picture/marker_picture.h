#pragma once

#include "devo_evo/picture/image.h"
#include "devo_evo/picture/life_scene.h"
#include "devo_evo/picture/robot_scene.h"
#include "devo_evo/picture/scene.h"
#include "devo_evo/picture/scene_painter.h"

#include <visualization_msgs/MarkerArray.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace devo_evo
{
/// Draws what markers show (SceneMarkers): the robot, its path and velocity, the floor, and captions, seen by a camera
/// that follows the robot. Markers come from the network or a bag and are not trusted: what is not as it should be is
/// refused.
class MarkerPicture
{
public:
  /// @param interval between pictures, for the camera [s].
  MarkerPicture(int width, int height, double interval);

  /// @throw InvalidInput if a marker has no sense; nothing of the array is taken then.
  void add(const visualization_msgs::MarkerArray& markers);

  /// Whether there is a robot to draw.
  bool hasRobot() const { return markers_.count("body") > 0; }

  /// @pre hasRobot(). @throw PictureError
  Image paint();

private:
  using Marker = visualization_msgs::Marker;

  Scene scene() const;
  Surroundings surroundingsOf() const;
  void follow();
  const Marker* marker(const std::string& name_space) const;

  ScenePainter painter_;
  const int width_, height_;
  FollowingPoint following_;
  Camera camera_;
  Surroundings surroundings_;                             ///< body_size, slope and light, of the last picture
  double body_size_ = 0.0;                                ///< of the robot as it was first seen [m]; 0: not yet
  std::map<std::string, std::map<int, Marker>> markers_;  ///< by namespace and id
};
}  // namespace devo_evo
