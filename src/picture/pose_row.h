#pragma once

#include "devo_evo/picture/image.h"
#include "devo_evo/render/appearance.h"
#include "devo_evo/render/shown_robot.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// One robot at several times of its life, side by side from left to right, each turned as it is, on one floor.
/// @param frames at least one. @param width, height of the picture [pixels].
Image paintPoses(const Appearance& appearance, const std::vector<RobotFrame>& frames, Colouring colouring, int width,
                 int height);

/// Frames of a life at given times, ascending [s since birth]. @throw PictureError if the simulation diverges before.
std::vector<RobotFrame> framesAt(const ShownRobot& robot, const std::vector<double>& times);

/// `count` times from one to another, both included [s].
std::vector<double> equalTimes(double from, double to, int count);
}  // namespace devo_evo
