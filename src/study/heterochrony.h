#pragma once

#include "devo_evo/archive/archive.h"

#include <vector>

namespace devo_evo
{
/// By how much a step of a lineage closed a developmental window, from its initial and from its final end
/// (docs/study.md, "ancestors"). Their sum is the parent's window minus the child's.
struct WindowClosing
{
  double initial_towards_final = 0.0;  ///< progenesis [of the window, -1 to 1]
  double final_towards_initial = 0.0;  ///< neoteny [of the window, -1 to 1]
};

WindowClosing morphologyClosing(const DevelopmentalProgram& parent, const DevelopmentalProgram& child);
WindowClosing controlClosing(const DevelopmentalProgram& parent, const DevelopmentalProgram& child, double phase_limit);

/// W_L and W_Phi along a lineage, from the founder on.
struct Windows
{
  std::vector<double> morphology;
  std::vector<double> control;
};

/// What the windows do without selection: from the lineage's founder, as many steps with the same mutation rates. A
/// pure function of its arguments.
/// @param lineage oldest first. @param replicate from 1.
Windows neutralWindows(const std::vector<ArchivedIndividual>& lineage, const EvolutionSettings& settings,
                       const Body& body, int64_t trial, int64_t replicate);
}  // namespace devo_evo
