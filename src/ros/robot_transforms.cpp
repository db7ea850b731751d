#include "ros/robot_transforms.h"

#include "ros/scene_markers.h"

namespace devo_evo
{
namespace
{
geometry_msgs::TransformStamped transformTo(const std::string& frame, const ros::Time& stamp,
                                            const Eigen::Vector3d& origin, const Eigen::Quaterniond& orientation)
{
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = WORLD_FRAME;
  message.child_frame_id = frame;
  message.transform.translation.x = origin.x();
  message.transform.translation.y = origin.y();
  message.transform.translation.z = origin.z();
  message.transform.rotation.x = orientation.x();
  message.transform.rotation.y = orientation.y();
  message.transform.rotation.z = orientation.z();
  message.transform.rotation.w = orientation.w();
  return message;
}
}  // namespace

std::vector<geometry_msgs::TransformStamped> robotTransforms(const std::string& name,
                                                             const Eigen::Vector3d& center_of_mass,
                                                             const Eigen::Quaterniond& orientation,
                                                             const ros::Time& stamp)
{
  const Eigen::Vector3d foot(center_of_mass.x(), center_of_mass.y(), 0.0);
  return { transformTo(name + "/robot", stamp, center_of_mass, orientation),
           transformTo(name + "/follow", stamp, foot, Eigen::Quaterniond::Identity()) };
}
}  // namespace devo_evo
