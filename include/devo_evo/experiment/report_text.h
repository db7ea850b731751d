#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/experiment/settings.h"

#include <string>

namespace devo_evo
{
// What people read while an experiment runs and when it ends; the same from the tool and from the nodes.

/// A number with a fixed count of decimals, whatever the locale; "-" if it is not finite.
std::string fixedText(double number, int decimals);

/// A duration in its two largest units: "42 s", "3 min 5 s", "2 h 10 min", "4 d 3 h"; "unknown" if it is not finite.
std::string durationText(double seconds);

/// One line on a generation: trial, generation, best and median body lengths, evaluations per second, time left.
std::string progressText(const GenerationReport& report, const ExperimentSettings& settings);

/// Several lines, each with its end: where the results lie, what the best robot of all trials did, and the digest.
std::string resultsText(const Archive& archive, const std::string& output);
}  // namespace devo_evo
