#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/farm/farm.h"

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace devo_evo
{
/// Counts whose evaluations an experiment uses, by machine and program. Workers come and go under ever new names; of
/// machines there are few.
class EvaluatorTally
{
public:
  /// Counts one evaluation. @param worker its name.
  void count(const std::string& worker) { ++counted_[worker]; }

  /// @param workers as the farm knows them now. Those without a host, threads of this program, are not listed.
  /// @return everybody counted so far.
  std::vector<Evaluator> evaluators(const std::vector<WorkerStatus>& workers);

private:
  using Description = std::tuple<std::string, std::string, std::string, std::string>;

  std::map<std::string, int64_t> counted_;      ///< by name, since evaluators() was asked for last
  std::map<Description, int64_t> evaluations_;  ///< by host, processor, instruction set and version
};
}  // namespace devo_evo
