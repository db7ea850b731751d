#pragma once

#include "devo_evo/evolution/genome.h"
#include "devo_evo/soft_body/settings.h"

#include <string>

namespace devo_evo
{
/// A robot with everything that its evaluation depends on, as a VXA file holds it.
struct VxaRobot
{
  std::string id;
  Genome genome;
  SoftBodySettings settings;
};

/// The robot as VXA, the file format of Voxelyze and VoxCAD, with settings as the paper's released experiments write
/// them (docs/interchange.md). readVxa() gives the same robot and settings back, to the last bit.
/// @throw InvalidInput if the format cannot express the settings: an actuation_frequency of 0, a slope.
std::string toVxa(const VxaRobot& robot);

/// @param text of the file. @param name of the file, for messages, and as id if the file has none.
/// @throw InvalidInput with file, line and tag if it is not VXA, lacks a tag, has one that it must not have, counts or
///        numbers are wrong, or it asks for something that is not simulated here (which is named).
VxaRobot readVxa(const std::string& text, const std::string& name);

/// Whether the beginning of a file looks like XML, which VXA is.
bool looksLikeVxa(const std::string& text);

/// More bytes than any VXA file has that can be read.
constexpr size_t LARGEST_VXA_FILE = size_t{ 8 } << 20;
}  // namespace devo_evo
