#include "study/work.h"

#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/text.h"
#include "experiment/rate_meter.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

namespace devo_evo
{
namespace
{
using Clock = RateMeter::Clock;

constexpr size_t ENOUGH_UNDER_WAY = 256;           // robots: keeps every simulator busy
constexpr std::ptrdiff_t SUBMITTED_TOGETHER = 64;  // robots
constexpr auto LONGEST_UNWRITTEN = std::chrono::seconds(2);

/// One call of doWork().
class Workshop
{
public:
  Workshop(const std::string& title, const World& world, bool keep_velocities, StudyDatabase& database,
           const FarmFactory& make_farm, StudyObserver& observer)
    : title_(title)
    , body_(world.body)
    , world_(database.numberOf(world))
    , keep_velocities_(keep_velocities)
    , database_(database)
    , make_farm_(make_farm)
    , observer_(observer)
    , rate_(Clock::now(), std::chrono::seconds(10))
    , pace_(Clock::now(), std::chrono::minutes(10))
  {
  }

  bool run(const std::vector<WorkMaker>& work)
  {
    for (auto next = work.begin(); next != work.end() || !open_.empty();)
    {
      if (observer_.stopRequested())
      {
        keepSimulated();
        return false;
      }
      while (next != work.end() && under_way_.size() < ENOUGH_UNDER_WAY && !somethingReady())
      {
        begin((*next++)());
      }
      collect();
      finishReady(work.size());
    }
    return true;
  }

private:
  /// Work that waits for robots.
  struct Open
  {
    Work work;
    std::set<Hash128> awaited;
  };

  void begin(Work work)
  {
    Open open;
    std::vector<EvaluationRequest> requests;
    for (const DevelopmentalProgram& program : work.robots)
    {
      const Hash128 phenotype = phenotypeHash(program);
      if (simulated_.count(phenotype) != 0 || database_.hasEvaluation(world_, phenotype, keep_velocities_))
      {
        continue;
      }
      open.awaited.insert(phenotype);
      if (asked_.insert(phenotype).second)
      {
        requests.push_back({ 1, ++last_id_, program });
        under_way_[last_id_] = phenotype;
      }
    }
    if (!requests.empty())
    {
      farm_ = farm_ ? std::move(farm_) : make_farm_(BodySettings(body_));
    }
    // A farm may keep results back until all of what was submitted together is done.
    for (auto begin = requests.begin(); begin != requests.end();)
    {
      const auto end = begin + std::min<std::ptrdiff_t>(SUBMITTED_TOGETHER, requests.end() - begin);
      farm_->submit(std::vector<EvaluationRequest>(begin, end));
      begin = end;
    }
    open.work = std::move(work);
    open.work.robots.clear();
    open_.push_back(std::move(open));
  }

  bool somethingReady() const
  {
    return std::any_of(open_.begin(), open_.end(), [](const Open& open) { return open.awaited.empty(); });
  }

  void collect()
  {
    if (under_way_.empty())
    {
      return;
    }
    for (EvaluationResult& result : farm_->collect(std::chrono::milliseconds(100)))
    {
      const auto robot = under_way_.find(result.id);
      if (robot == under_way_.end())
      {
        continue;
      }
      for (Open& open : open_)
      {
        open.awaited.erase(robot->second);
      }
      asked_.erase(robot->second);
      simulated_[robot->second] = std::move(result.evaluation);
      under_way_.erase(robot);
      rate_.add(Clock::now(), 1);
    }
    if (!simulated_.empty() && Clock::now() - written_ > LONGEST_UNWRITTEN)
    {
      keepSimulated();
    }
  }

  void finishReady(size_t total)
  {
    std::vector<Open> waiting;
    std::vector<Open> ready;
    for (Open& open : open_)
    {
      (open.awaited.empty() ? ready : waiting).push_back(std::move(open));
    }
    open_ = std::move(waiting);
    if (ready.empty())
    {
      return;
    }
    database_.inTransaction(
        [&]
        {
          writeSimulated();
          for (const Open& open : ready)
          {
            open.work.write();
          }
        });
    simulated_.clear();
    done_ += ready.size();
    pace_.add(Clock::now(), static_cast<int64_t>(ready.size()));
    observer_.showProgress(title_ + ": " + toText(static_cast<int64_t>(done_)) + "/" +
                           toText(static_cast<int64_t>(total)) + "; " + fixedText(rate_.rate(), 1) +
                           " evaluations/s, " + durationText(static_cast<double>(total - done_) / pace_.rate()) +
                           " left");
  }

  void writeSimulated()
  {
    for (const auto& [phenotype, result] : simulated_)
    {
      database_.putEvaluation(world_, phenotype, result, keep_velocities_);
    }
    written_ = Clock::now();
  }

  void keepSimulated()
  {
    database_.inTransaction([&] { writeSimulated(); });
    simulated_.clear();
  }

  const std::string title_;
  const SoftBodySettings body_;
  const int64_t world_;
  const bool keep_velocities_;
  StudyDatabase& database_;
  const FarmFactory& make_farm_;
  StudyObserver& observer_;
  std::unique_ptr<Farm> farm_;  // made when it is needed
  std::vector<Open> open_;
  std::map<int64_t, Hash128> under_way_;     // by id of the request
  std::set<Hash128> asked_;                  // the same phenotypes
  std::map<Hash128, Evaluation> simulated_;  // and not written yet
  int64_t last_id_ = 0;
  size_t done_ = 0;
  Clock::time_point written_ = Clock::now();
  RateMeter rate_;
  RateMeter pace_;
};
}  // namespace

bool doWork(const std::string& title, const World& world, bool keep_velocities, const std::vector<WorkMaker>& work,
            StudyDatabase& database, const FarmFactory& make_farm, StudyObserver& observer)
{
  return Workshop(title, world, keep_velocities, database, make_farm, observer).run(work);
}
}  // namespace devo_evo
