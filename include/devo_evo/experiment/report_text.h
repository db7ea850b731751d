#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/experiment/settings.h"
#include "devo_evo/farm/farm.h"
#include "devo_evo/soft_body/text.h"

#include <string>
#include <vector>

namespace devo_evo
{
// What people read while an experiment runs and when it ends; the same from the tool and from the nodes.

/// A duration in its two largest units: "42 s", "3 min 5 s", "2 h 10 min", "4 d 3 h"; "unknown" if it is not finite.
std::string durationText(double seconds);

/// One line on a generation: trial, generation, best and median body lengths, evaluations per second, time left.
std::string progressText(const GenerationReport& report, const ExperimentSettings& settings);

/// Several lines, each with its end: how many evaluations the workers of each host made and what they do, and each
/// worker that is late, lost, refused or quarantined, with the reason. Empty if there have been no workers.
std::string workersText(const std::vector<WorkerStatus>& workers);

/// Several lines, each with its end: where the results lie, what the best robot of all trials did, and the digest.
std::string resultsText(const Archive& archive, const std::string& output);
}  // namespace devo_evo
