#pragma once

#include "devo_evo/picture/pictures.h"

#include <string>

namespace devo_evo
{
/// A film of what a bag shows: one that `lineage` or a recording of players has written. Whoever builds the tool with
/// ROS gets src/ros/picture/bag_film.cpp; without, bags cannot be read.
/// @param bag with topics that end in `robot` and `floor` (visualization_msgs/MarkerArray).
/// @throw InvalidInput if it is no bag, or has no such topics; PictureError
void filmBag(const std::string& bag, const std::string& path, const PictureFormat& format,
             const FilmProgress& progress);
}  // namespace devo_evo
