#include "devo_evo/farm/local_farm.h"

#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>

namespace devo_evo
{
namespace
{
class LocalFarm : public Farm
{
public:
  LocalFarm(std::shared_ptr<const Body> body, int threads, InstructionSet instruction_set)
    : body_(std::move(body)), instruction_set_(instruction_set)
  {
    for (int i = 0; i < threads; ++i)
    {
      workers_.emplace_back();
      workers_.back().name = "thread " + toText(i + 1);
    }
    try
    {
      for (size_t i = 0; i < workers_.size(); ++i)
      {
        threads_.emplace_back([this, i] { work(i); });
      }
    }
    catch (...)
    {
      stop();
      throw;
    }
  }

  ~LocalFarm() override { stop(); }

  void submit(std::vector<EvaluationRequest> requests) override
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      requests_.insert(requests_.end(), std::make_move_iterator(requests.begin()),
                       std::make_move_iterator(requests.end()));
    }
    work_to_do_.notify_all();
  }

  std::vector<EvaluationResult> collect(std::chrono::milliseconds timeout) override
  {
    std::unique_lock<std::mutex> lock(mutex_);
    something_to_report_.wait_for(lock, timeout, [this] { return !results_.empty() || error_; });
    if (error_)
    {
      std::rethrow_exception(error_);
    }
    return std::exchange(results_, {});
  }

  std::vector<WorkerStatus> status() const override
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return workers_;
  }

private:
  void work(size_t worker)
  {
    try
    {
      for (std::vector<EvaluationRequest> group = take(worker); !group.empty(); group = take(worker))
      {
        deliver(worker, group, evaluateGroup(group));
      }
    }
    catch (const EvaluationAbandoned&)
    {
      // The farm is being destroyed: nobody waits for the results.
    }
    catch (...)
    {
      report(worker, std::current_exception());
    }
  }

  /// Waits for work and takes a group of it; nothing when the farm stops.
  std::vector<EvaluationRequest> take(size_t worker)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    workers_[worker].state = WorkerState::IDLE;
    ++idle_;
    work_to_do_.wait(lock, [this] { return stop_ || error_ || !requests_.empty(); });
    const size_t size = groupSize();
    --idle_;
    if (stop_ || error_)
    {
      return {};
    }
    workers_[worker].state = WorkerState::WORKING;
    const auto end = requests_.begin() + static_cast<std::ptrdiff_t>(size);
    std::vector<EvaluationRequest> group(std::make_move_iterator(requests_.begin()), std::make_move_iterator(end));
    requests_.erase(requests_.begin(), end);
    return group;
  }

  /// As much as the lanes hold, but no more than a fair share among the idle: a group that leaves lanes empty takes
  /// somewhat less time than a full one.
  size_t groupSize() const
  {
    const size_t share = (requests_.size() + idle_ - 1) / idle_;
    return std::min(share, static_cast<size_t>(body_->laneCount(instruction_set_)));
  }

  std::vector<Evaluation> evaluateGroup(const std::vector<EvaluationRequest>& group) const
  {
    std::vector<DevelopmentalProgram> programs;
    for (const EvaluationRequest& request : group)
    {
      programs.push_back(request.program);
    }
    return body_->evaluate(programs, instruction_set_, &stop_);
  }

  void deliver(size_t worker, const std::vector<EvaluationRequest>& group, std::vector<Evaluation> evaluations)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      WorkerStatus& status = workers_[worker];
      for (size_t i = 0; i < group.size(); ++i)
      {
        results_.push_back({ group[i].trial, group[i].id, std::move(evaluations[i]), status.name });
      }
      status.evaluations += static_cast<int64_t>(group.size());
    }
    something_to_report_.notify_all();
  }

  void report(size_t worker, std::exception_ptr error)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      workers_[worker].state = WorkerState::LOST;
      workers_[worker].reason = "it failed";
      error_ = error_ ? error_ : std::move(error);
    }
    something_to_report_.notify_all();
    work_to_do_.notify_all();
  }

  void stop()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);  // so that no thread misses it between looking and waiting
      stop_ = true;
    }
    work_to_do_.notify_all();
    for (std::thread& thread : threads_)
    {
      thread.join();
    }
  }

  const std::shared_ptr<const Body> body_;
  const InstructionSet instruction_set_;

  mutable std::mutex mutex_;  // guards everything below but stop_, which is only set under it
  std::condition_variable work_to_do_;
  std::condition_variable something_to_report_;
  std::deque<EvaluationRequest> requests_;
  std::vector<EvaluationResult> results_;
  std::vector<WorkerStatus> workers_;
  size_t idle_ = 0;  // workers that wait for work
  std::exception_ptr error_;
  std::atomic<bool> stop_{ false };

  std::vector<std::thread> threads_;
};
}  // namespace

std::unique_ptr<Farm> makeLocalFarm(std::shared_ptr<const Body> body, int threads, InstructionSet instruction_set)
{
  if (threads < 1)
  {
    throw InvalidInput("a farm needs 1 thread or more, not " + toText(threads));
  }
  return std::make_unique<LocalFarm>(std::move(body), threads, instruction_set);
}
}  // namespace devo_evo
