#pragma once

#include "devo_evo/archive/archive.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace devo_evo
{
/// An individual in its phylogeny.
struct Descendant
{
  ArchivedIndividual archived;   ///< genome: see ArchivedIndividual
  std::optional<int64_t> death;  ///< the first generation whose selection it did not survive; none: it is alive
};

/// All individuals of a trial, by id. @throw InvalidInput if the trial has no finished generation.
std::vector<Descendant> readPhylogeny(const Archive& archive, int64_t trial);

/// An individual and its ancestors, oldest first. @throw InvalidInput if there is no such individual.
std::vector<Descendant> readAncestry(const Archive& archive, int64_t trial, int64_t id);

/// Takes a text line by line, each without its end.
using LineSink = std::function<void(const std::string&)>;

/// Newick: one line for each tree, of which there is one for each random individual that is in the list, or whose
/// parent is not. Labels are "trial/id"; a branch is as long as the generations from the parent's birth to its own, a
/// root's as those from generation 0.
/// @param descendants parents before their children.
void writeNewick(const std::vector<Descendant>& descendants, const LineSink& sink);

/// The ALife data standard for phylogenies: id, ancestor_list, origin_time, destruction_time [generations], trait_...
void writeAlifeStandard(const std::vector<Descendant>& descendants, const Body& body, const LineSink& sink);

/// Every column of the archive's table `individuals`, and `death`; hashes in hexadecimal digits, nothing for NULL.
void writeCsv(const std::vector<Descendant>& descendants, const Body& body, const LineSink& sink);
}  // namespace devo_evo
