#pragma once

#include "devo_evo/evolution/genome.h"
#include "study/frozen.h"

#include <string>
#include <vector>

namespace devo_evo
{
/// A kind of random walk through the space of genomes (docs/study.md, "walk_steps").
struct WalkKind
{
  Scope space = Scope::CONTROL;  ///< what mutates: BODY or CONTROL
  bool removed = false;          ///< whether it starts frozen at birth and mutates as a robot of treatment evo
  bool one_voxel = false;        ///< whether a step changes one voxel; else mutation rates are redrawn

  std::string robot() const { return removed ? "removed" : "champion"; }
  std::string mutationOperator() const { return one_voxel ? "one_voxel" : "redrawn_rates"; }
};

/// The kinds of walks from a champion. @param with_removed, with_one_voxel whether there are such, too.
std::vector<WalkKind> walkKinds(Treatment treatment, bool with_removed, bool with_one_voxel);

/// The genomes of a walk: the start, and one for each step. A pure function of its arguments.
/// @param settings of the champion's experiment. @param number of the walk, from 1.
std::vector<Genome> walk(const WalkKind& kind, const Genome& champion, const EvolutionSettings& settings,
                         const Body& body, int64_t trial, int64_t number, int64_t steps);

/// How many voxels differ in at least one gene.
int64_t voxelsChanged(const DevelopmentalProgram& before, const DevelopmentalProgram& after);
}  // namespace devo_evo
