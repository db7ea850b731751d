#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/evolution/body.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
/// What the panel knows of an experiment: the line of descent of a champion.
struct LineageView
{
  std::string folder;           ///< of the experiment
  std::vector<int64_t> trials;  ///< that have a generation, ascending
  int64_t trial = 0;
  std::shared_ptr<const Body> body;             ///< whose lives these are; none if there are no individuals
  std::vector<ArchivedIndividual> individuals;  ///< oldest first, the champion last; without genomes. At least one
};

/// Reads the lineage of a champion from an archive, which may be written to meanwhile.
/// @param folder  of the experiment, as an absolute path.
/// @param trial   none: that of the best champion of all trials.
/// @param known   what was read before; an answer that is the same needs little work.
/// @throw ArchiveError, InvalidInput if there is no such experiment, or nobody in it yet.
LineageView readLineageView(const std::string& folder, std::optional<int64_t> trial, const LineageView& known);

/// The folder of the experiment that a player was started with or, if it was not given one, to which the evolver in its
/// namespace writes. Asks the ROS master.
/// @param player resolved name of the node. @throw InvalidInput if there is neither, std::runtime_error without master.
std::string folderOf(const std::string& player);
}  // namespace devo_evo
