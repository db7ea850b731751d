#include "ros/picture/renderer_node.h"

#include "devo_evo/soft_body/settings.h"

#include <ros/console.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>

namespace devo_evo
{
RendererNode::RendererNode(const RendererOptions& options)
  : private_node_("~")
  , options_(options)
  , picture_(options.width, options.height, 1.0 / options.rate)
  , film_(options.film.empty() ? nullptr : makeFilmWriter(options.film, options.width, options.height, options.rate))
  , images_(private_node_.advertise<sensor_msgs::Image>("image", 2))
  , robot_(node_.subscribe("robot", 10, &RendererNode::onMarkers, this))
  , floor_(node_.subscribe("floor", 10, &RendererNode::onMarkers, this))
  , timer_(node_.createWallTimer(ros::WallDuration(1.0 / options.rate), [this](const ros::WallTimerEvent&) { draw(); }))
{
}

void RendererNode::onMarkers(const visualization_msgs::MarkerArray::ConstPtr& markers)
{
  try
  {
    picture_.add(*markers);
  }
  catch (const InvalidInput& error)
  {
    ROS_WARN_STREAM_THROTTLE(10, "markers that cannot be drawn are ignored: " << error.what());
  }
}

void RendererNode::draw()
{
  const bool wanted = film_ != nullptr || images_.getNumSubscribers() > 0;
  if (!wanted || !picture_.hasRobot())
  {
    return;
  }
  const Image picture = picture_.paint();
  if (film_ != nullptr)
  {
    film_->add(picture);
  }
  if (images_.getNumSubscribers() > 0)
  {
    publish(picture);
  }
}

void RendererNode::publish(const Image& picture)
{
  sensor_msgs::Image message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = "world";
  message.width = static_cast<uint32_t>(picture.width());
  message.height = static_cast<uint32_t>(picture.height());
  message.encoding = sensor_msgs::image_encodings::BGR8;
  message.step = 3 * message.width;
  message.data.reserve(static_cast<size_t>(message.step) * message.height);
  for (size_t i = 0; i < picture.byteCount(); i += 4)
  {
    message.data.insert(message.data.end(), picture.data() + i, picture.data() + i + 3);
  }
  images_.publish(message);
}

void RendererNode::close()
{
  timer_.stop();
  if (film_ != nullptr)
  {
    film_->finish();
    ROS_INFO_STREAM("the film is in " << options_.film);
  }
}
}  // namespace devo_evo
