#pragma once

#include "devo_evo/picture/film_writer.h"
#include "ros/picture/marker_picture.h"

#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <memory>
#include <string>

namespace devo_evo
{
/// What the renderer node does.
struct RendererOptions
{
  int width = 1280, height = 720;  ///< of its pictures [pixels]
  int rate = 25;                   ///< pictures per second
  std::string film;                ///< path of a film of all pictures, as for makeFilmWriter(); empty: none
};

/// Draws what a player, or a bag that is played, shows: subscribes to `robot` and `floor` (MarkerArray) and publishes
/// `~image` (sensor_msgs/Image, bgr8) while somebody listens. Works in the thread of the global callback queue.
class RendererNode
{
public:
  /// @throw InvalidInput, PictureError
  explicit RendererNode(const RendererOptions& options);

  /// Ends the film. @throw PictureError
  void close();

private:
  void onMarkers(const visualization_msgs::MarkerArray::ConstPtr& markers);
  void draw();
  void publish(const Image& picture);

  ros::NodeHandle node_, private_node_;
  const RendererOptions options_;
  MarkerPicture picture_;
  std::unique_ptr<FilmWriter> film_;
  ros::Publisher images_;
  ros::Subscriber robot_, floor_;
  ros::WallTimer timer_;
};
}  // namespace devo_evo
