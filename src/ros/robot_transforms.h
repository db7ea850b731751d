#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace devo_evo
{
/// The frames of a robot that is shown, in WORLD_FRAME: `<name>/robot`, at its centre of mass [m] with its mean
/// orientation, and `<name>/follow`, below it on the floor and never turning, for cameras.
std::vector<geometry_msgs::TransformStamped> robotTransforms(const std::string& name,
                                                             const Eigen::Vector3d& center_of_mass,
                                                             const Eigen::Quaterniond& orientation,
                                                             const ros::Time& stamp);
}  // namespace devo_evo
