#include "rviz_plugin/background_jobs.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace devo_evo
{
namespace
{
constexpr std::chrono::seconds LONGEST_WAIT{ 1 };  // for jobs at the end
}  // namespace

/// Shared with the thread, which may outlive us.
struct BackgroundJobs::State
{
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Job> jobs;         ///< guarded by mutex
  QObject* receiver = nullptr;  ///< guarded by mutex; null once nobody wants outcomes any more
  bool ended = false;           ///< guarded by mutex; whether the thread is through

  void post(Outcome outcome)
  {
    std::lock_guard<std::mutex> lock(mutex);
    if (receiver != nullptr && outcome)
    {
      QMetaObject::invokeMethod(receiver, std::move(outcome), Qt::QueuedConnection);
    }
  }

  void work()
  {
    std::unique_lock<std::mutex> lock(mutex);
    for (;;)
    {
      changed.wait(lock, [&] { return !jobs.empty() || receiver == nullptr; });
      if (jobs.empty())
      {
        break;
      }
      Job job = std::move(jobs.front());
      jobs.pop_front();
      lock.unlock();
      post(job());
      job = nullptr;
      lock.lock();
    }
    ended = true;
    changed.notify_all();
  }
};

BackgroundJobs::BackgroundJobs() : state_(std::make_shared<State>())
{
  state_->receiver = &receiver_;
  std::thread([state = state_] { state->work(); }).detach();
}

BackgroundJobs::~BackgroundJobs()
{
  std::unique_lock<std::mutex> lock(state_->mutex);
  state_->receiver = nullptr;
  state_->changed.notify_all();
  state_->changed.wait_for(lock, LONGEST_WAIT, [&] { return state_->ended; });
}

void BackgroundJobs::run(Job job)
{
  {
    std::lock_guard<std::mutex> lock(state_->mutex);
    state_->jobs.push_back(std::move(job));
  }
  state_->changed.notify_all();
}

std::function<void(BackgroundJobs::Outcome)> BackgroundJobs::poster() const
{
  return [state = state_](Outcome outcome) { state->post(std::move(outcome)); };
}
}  // namespace devo_evo
