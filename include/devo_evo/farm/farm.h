#pragma once

#include "devo_evo/soft_body/developmental_program.h"
#include "devo_evo/soft_body/evaluation.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace devo_evo
{
/// One robot to be evaluated for (trial, id).
struct EvaluationRequest
{
  int64_t trial = 0;
  int64_t id = 0;
  DevelopmentalProgram program;
};

/// Its result. Whoever made it, and however often, it is the same.
struct EvaluationResult
{
  int64_t trial = 0;
  int64_t id = 0;
  Evaluation evaluation;
  std::string worker;  ///< name of the worker that made it
};

/// What a worker of the farm is doing, for reports.
struct WorkerStatus
{
  std::string name;
  std::string state;        ///< "idle", "working", "lost: why" or "refused: why"
  bool usable = false;      ///< whether it takes work
  int64_t evaluations = 0;  ///< results taken from it
};

/// Hands evaluations to workers: local threads or ROS simulators. Every request is answered exactly once, however
/// workers come, go or fail; while there is none, requests wait. submit(), collect() and status() may be called from
/// different threads.
class Farm
{
public:
  virtual ~Farm() = default;

  virtual void submit(std::vector<EvaluationRequest> requests) = 0;

  /// Waits up to `timeout` for results; returns what there is, possibly nothing.
  virtual std::vector<EvaluationResult> collect(std::chrono::milliseconds timeout) = 0;

  virtual std::vector<WorkerStatus> status() const = 0;
};
}  // namespace devo_evo
