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

/// What a worker of a farm is doing.
enum class WorkerState
{
  CONNECTING,   ///< it has announced itself
  IDLE,         ///< it waits for work
  WORKING,      ///< it evaluates robots
  LATE,         ///< it takes much longer than usual: others do its work, too
  LOST,         ///< it broke off, took too long, fell silent, or answered nonsense; it may come back
  REFUSED,      ///< it has another engine
  QUARANTINED,  ///< it gave a wrong evaluation
};

/// Whether a worker in this state takes work.
constexpr bool usable(WorkerState state)
{
  return state == WorkerState::IDLE || state == WorkerState::WORKING || state == WorkerState::LATE;
}

/// A worker, for reports.
struct WorkerStatus
{
  std::string name;
  std::string host;
  WorkerState state = WorkerState::IDLE;
  std::string reason;           ///< why it is late, lost, refused or quarantined, or was lost last
  int64_t evaluations = 0;      ///< taken from it
  int64_t checked = 0;          ///< of these, compared with those of another worker, and equal
  int64_t losses = 0;           ///< how often it was lost
  std::string processor;        ///< of its machine; empty: not known
  std::string instruction_set;  ///< that it computes with
  std::string version;          ///< of its devo_evo

  bool usable() const { return devo_evo::usable(state); }
};

/// "working", or "lost: the connection failed".
std::string stateText(const WorkerStatus& worker);

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
