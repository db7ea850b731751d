#pragma once

namespace devo_evo
{
/// Registers experiments on threads of the library, archive included: "experiments/<scene>/threads:<number>".
void registerExperimentBenchmarks();

/// Prints a line of known_results.txt for every such scene.
void printExperimentHashes();
}  // namespace devo_evo
