#pragma once

#include <QObject>

#include <functional>
#include <memory>

namespace devo_evo
{
/// Does what may take long, or block, in a thread of its own, one job after the other, and hands the outcome to the
/// thread that made this object: a GUI that does not wait.
class BackgroundJobs
{
public:
  /// Called in the thread that made this object; never once this is destroyed.
  using Outcome = std::function<void()>;
  using Job = std::function<Outcome()>;

  BackgroundJobs();

  /// Waits for the jobs that are left, but at most for a second: one may hang in a call over the network, and is left
  /// to itself then. So jobs must own what they use.
  ~BackgroundJobs();
  BackgroundJobs(const BackgroundJobs&) = delete;
  BackgroundJobs& operator=(const BackgroundJobs&) = delete;

  void run(Job job);

  /// Hands an outcome over from any thread, as a job does.
  std::function<void(Outcome)> poster() const;

private:
  struct State;

  QObject receiver_;  ///< in whose thread outcomes are called
  std::shared_ptr<State> state_;
};
}  // namespace devo_evo
