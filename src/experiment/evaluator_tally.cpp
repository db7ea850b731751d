#include "experiment/evaluator_tally.h"

namespace devo_evo
{
std::vector<Evaluator> EvaluatorTally::evaluators(const std::vector<WorkerStatus>& workers)
{
  for (const WorkerStatus& worker : workers)
  {
    const auto counted = counted_.extract(worker.name);
    if (!counted.empty() && !worker.host.empty())
    {
      evaluations_[{ worker.host, worker.processor, worker.instruction_set, worker.version }] += counted.mapped();
    }
  }
  counted_.clear();
  std::vector<Evaluator> evaluators;
  for (const auto& [description, evaluations] : evaluations_)
  {
    const auto& [host, processor, instruction_set, version] = description;
    evaluators.push_back({ host, processor, instruction_set, version, evaluations });
  }
  return evaluators;
}
}  // namespace devo_evo
