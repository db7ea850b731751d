#pragma once

#include "devo_evo/farm/farm.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace devo_evo
{
/// An evaluation held against another one of the same robot.
struct Comparison
{
  std::string worker;
  int64_t trial = 0;
  int64_t id = 0;
  Evaluation given;  ///< by the worker
  Evaluation right;  ///< that it should have given; the same if it agrees
  bool agrees = false;
};

/// The books of a farm: which robots are to be evaluated, who is at them, and which evaluations can be relied on. It
/// knows nothing of threads, clocks and networks.
///
/// Robots that are submitted together are a group, whose results come out together, when each robot has one and no
/// check is open. Until then whatever a worker has said can be voided, so nobody ever builds on an evaluation of
/// somebody who turns out to be wrong before the group is complete.
///
/// A fraction of the robots is evaluated by two workers. Where two evaluations of a robot differ, the referee (the
/// owner of the farm) evaluates it; so it does with robots to be checked for which there is no second worker.
class WorkLedger
{
public:
  /// Name of the referee in results.
  static constexpr const char* REFEREE = "evolver";

  /// @param checked_fraction of robots that are evaluated twice, 0 to 1. Which ones depends on trial and id only.
  explicit WorkLedger(double checked_fraction) : checked_fraction_(checked_fraction) {}

  void submit(std::vector<EvaluationRequest> requests);

  /// How many robots there are in groups that are not complete, whatever has been done about them.
  size_t open() const { return robots_.size(); }

  /// How many evaluations wait to be taken by somebody.
  size_t waiting() const { return queue_.size(); }

  /// Whether there is one that this worker may take: nobody evaluates the same robot twice.
  bool hasWorkFor(const std::string& worker) const;

  /// Gives the worker up to `most` robots, which must have none. The oldest go first.
  std::vector<EvaluationRequest> take(const std::string& worker, size_t most);

  /// Takes the evaluations of what the worker took, in the same order.
  void deliver(const std::string& worker, const std::vector<Evaluation>& evaluations);

  /// The worker will not deliver. @return how many robots it had.
  size_t giveUp(const std::string& worker);

  /// The worker may still deliver what it has, but others are to do it too.
  void doAgain(const std::string& worker);

  /// Whether all that the worker still has to deliver is no longer needed.
  bool isSuperseded(const std::string& worker) const;

  /// Gives up the worker, and voids what it has said of robots whose group is not complete, unless the referee has
  /// judged them. @return how many evaluations these were.
  size_t distrust(const std::string& worker);

  /// Hands checks that none of these workers can make to the referee. Does nothing if there are no workers.
  void refer(const std::set<std::string>& usable_workers);

  /// Whether the referee has something to do.
  bool hasWorkForReferee() const { return !referred_.empty(); }

  /// Gives the referee a robot, with the number to name it by. @pre hasWorkForReferee()
  std::pair<int64_t, EvaluationRequest> takeAsReferee();

  /// Takes the referee's evaluation of a robot, which is right by definition.
  void judge(int64_t number, const Evaluation& evaluation);

  /// What has been compared since the last call.
  std::vector<Comparison> takeComparisons();

  /// Whether a group is complete.
  bool hasResults() const;

  /// The results of complete groups, which are forgotten.
  std::vector<EvaluationResult> takeResults();

private:
  struct Opinion
  {
    std::string worker;
    Evaluation evaluation;
  };

  struct Robot
  {
    EvaluationRequest request;
    int64_t group = 0;
    size_t wanted = 1;  // opinions
    std::vector<Opinion> opinions;
    std::vector<std::string> asked;  // who is at it
    size_t queued = 0;               // times in the queue
    bool referred = false;           // the referee is to judge it, and has not yet
    std::optional<Evaluation> verdict;

    bool involves(const std::string& worker) const;
    bool settled() const { return !referred && opinions.size() >= wanted; }
    const Evaluation& evaluation() const { return verdict ? *verdict : opinions.front().evaluation; }
  };

  bool isChecked(const EvaluationRequest& request) const;
  void enqueueMissing(int64_t number, Robot& robot);
  void dequeue(int64_t number, Robot& robot);
  void addOpinion(int64_t number, Robot& robot, Opinion opinion);
  void refer(int64_t number, Robot& robot);
  void record(const Robot& robot, const Opinion& opinion);
  void settledChanged(const Robot& robot, bool was_settled);

  double checked_fraction_;
  std::map<int64_t, Robot> robots_;                        // of groups that are not complete, by number
  std::map<int64_t, std::vector<int64_t>> groups_;         // the numbers of their robots
  std::map<int64_t, size_t> unsettled_;                    // how many of these are not settled
  std::deque<int64_t> queue_;                              // a robot for every opinion that somebody is to give
  std::map<std::string, std::vector<int64_t>> under_way_;  // what workers have taken
  std::deque<int64_t> referred_;
  std::vector<Comparison> comparisons_;
  int64_t next_number_ = 0;
};
}  // namespace devo_evo
