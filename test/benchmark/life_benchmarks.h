#pragma once

namespace devo_evo
{
/// Registers every scene of whole lives with every instruction set: "lives/<scene>/<instruction set>".
void registerLifeBenchmarks();

/// Prints a line of known_results.txt for every scene of whole lives.
void printLifeHashes();
}  // namespace devo_evo
