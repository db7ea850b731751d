#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/farm/farm.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace devo_evo
{
/// Which archived individuals are simulated again. Everything else about all of them is checked in any case.
struct VerificationScope
{
  bool all = false;
  int64_t sample = 100;               ///< how many, evenly over all trials and ids; besides them each trial's champion
  std::optional<int64_t> lineage_of;  ///< instead of a sample, the ancestors of this trial's champion
};

/// What was checked, and what was found.
struct Verification
{
  int64_t trials = 0;
  int64_t generations = 0;         ///< whose newcomers and survivors were made again from the rules
  int64_t individuals = 0;         ///< whose birth was repeated
  int64_t genomes = 0;             ///< stored ones that were compared with the repeated birth
  int64_t simulated = 0;           ///< individuals whose life was repeated
  bool complete = true;            ///< false: it was told to stop
  std::optional<Offence> offence;  ///< the first that was found
};

/// Repeats evolution from the parameters: every birth (and so every mutation), every selection, and the lives of those
/// in scope; compares all of it with the archive to the last bit. Ends at the first offence.
/// @param farm     for lives, with the archive's body and physics; nobody else may use it meanwhile.
/// @param progress told of every generation, after it: what was checked so far. @return false to stop.
/// @throw ArchiveError if the archive cannot be read; InvalidInput if it has no trial to check as scope asks.
Verification verify(const Archive& archive, const VerificationScope& scope, Farm& farm,
                    const std::function<bool(const Verification&)>& progress);
}  // namespace devo_evo
