#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/experiment/experiment.h"
#include "devo_evo/experiment/parameters.h"
#include "devo_evo/farm/farm.h"
#include "devo_evo/soft_body/simulation.h"

#include <functional>
#include <memory>
#include <string>

namespace devo_evo
{
/// Somebody who watches a study, and can stop it. Called from the thread that runs it.
class StudyObserver
{
public:
  virtual ~StudyObserver() = default;

  /// The next part begins. @param number counts up from 1. @param parts how many there are to run.
  virtual void partBegun(StudyPart /*part*/, size_t /*number*/, size_t /*parts*/) {}

  /// A line worth keeping.
  virtual void say(const std::string& line) = 0;

  /// How far it has got; the next line replaces this one.
  virtual void showProgress(const std::string& line) = 0;

  /// Asked several times a second: whether to stop at once. What was simulated is safe then.
  virtual bool stopRequested() = 0;
};

/// Makes a farm on which robots live with these settings.
using FarmFactory = std::function<std::unique_ptr<Farm>(const BodySettings&)>;

/// The folder a study writes to if none is named: $HOME/devo_evo/study-<scale>-<profile>-seed-<seed>.
/// @throw InvalidInput if HOME is not an absolute path.
std::string defaultStudyOutput(const Parameters& parameters);

/// Checks what a study needs of parameters beyond the range of each. @throw InvalidInput
void validateStudy(const Parameters& parameters);

/// What is left to be simulated, part by part, and how long it takes on this machine: a table for people. Measures for
/// about a second how fast this machine is.
/// @param parameters experiment.output is the study's folder, which need not exist; it is not changed.
/// @param threads    that simulate, or simulator nodes.
std::string estimateText(const Parameters& parameters, int threads, InstructionSet instruction_set);

/// Runs the parts of a study (docs/study.md) in their order, or goes on with it. The same parameters give the same
/// results, however often it is interrupted and whoever simulates.
/// @param parameters experiment.output is the study's folder, absolute.
/// @throw InvalidInput if parameters cannot be used, or a part needs another one that was not run. ArchiveError if
/// results cannot be kept, or the folder holds another study; whatever farms and observer throw.
RunOutcome runStudy(const Parameters& parameters, const Provenance& provenance, const FarmFactory& make_farm,
                    StudyObserver& observer);
}  // namespace devo_evo
