#include "farm/work_ledger.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace devo_evo
{
namespace
{
bool sameNumber(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// Whether two evaluations agree in everything.
bool equal(const Evaluation& a, const Evaluation& b)
{
  if (a.valid != b.valid || a.state_hash != b.state_hash || a.divergence.has_value() != b.divergence.has_value() ||
      a.first_top_contact_since_birth_s != b.first_top_contact_since_birth_s ||
      a.fell_over_since_birth_s != b.fell_over_since_birth_s ||
      a.velocity_body_lengths_per_s != b.velocity_body_lengths_per_s ||
      !std::equal(a.body_measures.begin(), a.body_measures.end(), b.body_measures.begin(), b.body_measures.end(),
                  sameNumber))
  {
    return false;
  }
  for (const auto measure : { &Evaluation::fitness, &Evaluation::displacement_y_voxels,
                              &Evaluation::displacement_xy_voxels, &Evaluation::turns, &Evaluation::airborne_fraction })
  {
    if (!sameNumber(a.*measure, b.*measure))
    {
      return false;
    }
  }
  return !a.divergence || (a.divergence->step == b.divergence->step && a.divergence->bond == b.divergence->bond &&
                           sameNumber(a.divergence->strain, b.divergence->strain));
}

/// Spreads numbers evenly over 64 bits (the finaliser of SplitMix64).
uint64_t scatter(uint64_t number)
{
  number += 0x9e3779b97f4a7c15;
  number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9;
  number = (number ^ (number >> 27)) * 0x94d049bb133111eb;
  return number ^ (number >> 31);
}

template <class Container, class Value>
bool contains(const Container& container, const Value& value)
{
  return std::find(container.begin(), container.end(), value) != container.end();
}
}  // namespace

bool WorkLedger::Robot::involves(const std::string& worker) const
{
  const auto given = [&](const Opinion& opinion) { return opinion.worker == worker; };
  return contains(asked, worker) || std::any_of(opinions.begin(), opinions.end(), given);
}

/// Which robots are checked has no influence on any result, so this need not be better than fair.
bool WorkLedger::isChecked(const EvaluationRequest& request) const
{
  const uint64_t number = scatter(scatter(static_cast<uint64_t>(request.trial)) + static_cast<uint64_t>(request.id));
  return static_cast<double>(number >> 11) * 0x1p-53 < checked_fraction_;
}

/// Robots to be checked are first in line, so that second evaluations do not come after all others.
void WorkLedger::submit(std::vector<EvaluationRequest> requests)
{
  if (requests.empty())
  {
    return;
  }
  std::stable_partition(requests.begin(), requests.end(), [this](const auto& request) { return isChecked(request); });
  const int64_t group = next_number_;
  for (EvaluationRequest& request : requests)
  {
    const int64_t number = next_number_++;
    Robot& robot = robots_[number];
    robot.group = group;
    robot.wanted = isChecked(request) ? 2 : 1;
    robot.queued = robot.wanted;
    robot.request = std::move(request);
    queue_.insert(queue_.end(), robot.wanted, number);
    groups_[group].push_back(number);
  }
  unsettled_[group] = requests.size();
}

bool WorkLedger::hasWorkFor(const std::string& worker) const
{
  return std::any_of(queue_.begin(), queue_.end(),
                     [&](int64_t number) { return !robots_.at(number).involves(worker); });
}

std::vector<EvaluationRequest> WorkLedger::take(const std::string& worker, size_t most)
{
  std::vector<EvaluationRequest> requests;
  std::vector<int64_t>& under_way = under_way_[worker];
  for (auto entry = queue_.begin(); entry != queue_.end() && requests.size() < most;)
  {
    Robot& robot = robots_.at(*entry);
    if (robot.involves(worker))
    {
      ++entry;
      continue;
    }
    robot.asked.push_back(worker);
    --robot.queued;
    requests.push_back(robot.request);
    under_way.push_back(*entry);
    entry = queue_.erase(entry);
  }
  return requests;
}

void WorkLedger::deliver(const std::string& worker, const std::vector<Evaluation>& evaluations)
{
  const std::vector<int64_t> numbers = std::exchange(under_way_[worker], {});
  under_way_.erase(worker);
  for (size_t i = 0; i < numbers.size(); ++i)
  {
    const auto robot = robots_.find(numbers[i]);
    if (robot != robots_.end())  // else others were faster, and its group is complete
    {
      auto& asked = robot->second.asked;
      asked.erase(std::find(asked.begin(), asked.end(), worker));
      addOpinion(numbers[i], robot->second, { worker, evaluations[i] });
    }
  }
}

void WorkLedger::addOpinion(int64_t number, Robot& robot, Opinion opinion)
{
  const bool was_settled = robot.settled();
  robot.opinions.push_back(std::move(opinion));
  if (robot.verdict)
  {
    record(robot, robot.opinions.back());
  }
  else if (robot.opinions.size() > 1 && !robot.referred)
  {
    if (!equal(robot.opinions.back().evaluation, robot.opinions.front().evaluation))
    {
      refer(number, robot);
    }
    else
    {
      // The first ones have been recorded when the second came.
      const size_t first_new = robot.opinions.size() == 2 ? 0 : robot.opinions.size() - 1;
      for (size_t i = first_new; i < robot.opinions.size(); ++i)
      {
        record(robot, robot.opinions[i]);
      }
    }
  }
  if (robot.opinions.size() >= robot.wanted)
  {
    dequeue(number, robot);
  }
  settledChanged(robot, was_settled);
}

size_t WorkLedger::giveUp(const std::string& worker)
{
  const auto entry = under_way_.find(worker);
  if (entry == under_way_.end())
  {
    return 0;
  }
  const std::vector<int64_t> numbers = std::move(entry->second);
  under_way_.erase(entry);
  for (auto number = numbers.rbegin(); number != numbers.rend(); ++number)  // so that the oldest ends up in front
  {
    const auto robot = robots_.find(*number);
    if (robot != robots_.end())
    {
      auto& asked = robot->second.asked;
      asked.erase(std::find(asked.begin(), asked.end(), worker));
      enqueueMissing(*number, robot->second);
    }
  }
  return numbers.size();
}

void WorkLedger::doAgain(const std::string& worker)
{
  const auto entry = under_way_.find(worker);
  if (entry == under_way_.end())
  {
    return;
  }
  for (auto number = entry->second.rbegin(); number != entry->second.rend(); ++number)
  {
    const auto robot = robots_.find(*number);
    if (robot != robots_.end() && robot->second.opinions.size() < robot->second.wanted)
    {
      queue_.push_front(*number);
      ++robot->second.queued;
    }
  }
}

bool WorkLedger::isSuperseded(const std::string& worker) const
{
  const auto entry = under_way_.find(worker);
  return entry != under_way_.end() && std::all_of(entry->second.begin(), entry->second.end(),
                                                  [this](int64_t number)
                                                  {
                                                    const auto robot = robots_.find(number);
                                                    return robot == robots_.end() || robot->second.settled();
                                                  });
}

size_t WorkLedger::distrust(const std::string& worker)
{
  giveUp(worker);
  size_t voided = 0;
  for (auto& [number, robot] : robots_)
  {
    const auto by_worker = [&](const Opinion& opinion) { return opinion.worker == worker; };
    const auto opinion = std::find_if(robot.opinions.begin(), robot.opinions.end(), by_worker);
    if (opinion != robot.opinions.end() && !robot.verdict)
    {
      const bool was_settled = robot.settled();
      robot.opinions.erase(opinion);
      enqueueMissing(number, robot);
      settledChanged(robot, was_settled);
      ++voided;
    }
  }
  return voided;
}

/// Sees to it that as many opinions are under way or waiting as are wanted.
void WorkLedger::enqueueMissing(int64_t number, Robot& robot)
{
  while (robot.opinions.size() + robot.asked.size() + robot.queued < robot.wanted)
  {
    queue_.push_front(number);
    ++robot.queued;
  }
}

void WorkLedger::dequeue(int64_t number, Robot& robot)
{
  if (robot.queued > 0)
  {
    queue_.erase(std::remove(queue_.begin(), queue_.end(), number), queue_.end());
    robot.queued = 0;
  }
}

void WorkLedger::refer(const std::set<std::string>& usable_workers)
{
  if (usable_workers.empty())
  {
    return;
  }
  std::set<int64_t> hopeless;
  for (const int64_t number : queue_)
  {
    const Robot& robot = robots_.at(number);
    const auto could = [&](const std::string& worker) { return !robot.involves(worker); };
    if (robot.wanted == 2 && !robot.referred && std::none_of(usable_workers.begin(), usable_workers.end(), could))
    {
      hopeless.insert(number);
    }
  }
  for (const int64_t number : hopeless)
  {
    Robot& robot = robots_.at(number);
    robot.wanted = 1;  // besides the verdict
    dequeue(number, robot);
    refer(number, robot);
  }
}

void WorkLedger::refer(int64_t number, Robot& robot)
{
  robot.referred = true;
  referred_.push_back(number);
}

std::pair<int64_t, EvaluationRequest> WorkLedger::takeAsReferee()
{
  const int64_t number = referred_.front();
  referred_.pop_front();
  return { number, robots_.at(number).request };
}

void WorkLedger::judge(int64_t number, const Evaluation& evaluation)
{
  Robot& robot = robots_.at(number);
  robot.verdict = evaluation;
  robot.referred = false;
  for (const Opinion& opinion : robot.opinions)
  {
    record(robot, opinion);
  }
  if (!robot.opinions.empty())
  {
    robot.wanted = std::min(robot.wanted, robot.opinions.size());  // some may have been voided meanwhile
    dequeue(number, robot);
  }
  settledChanged(robot, false);
}

void WorkLedger::record(const Robot& robot, const Opinion& opinion)
{
  const Evaluation& right = robot.evaluation();
  comparisons_.push_back({ opinion.worker, robot.request.trial, robot.request.id, opinion.evaluation, right,
                           equal(opinion.evaluation, right) });
}

void WorkLedger::settledChanged(const Robot& robot, bool was_settled)
{
  if (robot.settled() == was_settled)
  {
    return;
  }
  size_t& unsettled = unsettled_.at(robot.group);
  unsettled = was_settled ? unsettled + 1 : unsettled - 1;
}

bool WorkLedger::hasResults() const
{
  return std::any_of(unsettled_.begin(), unsettled_.end(), [](const auto& group) { return group.second == 0; });
}

std::vector<EvaluationResult> WorkLedger::takeResults()
{
  std::vector<EvaluationResult> results;
  for (auto entry = unsettled_.begin(); entry != unsettled_.end();)
  {
    const auto [group, unsettled] = *entry;
    if (unsettled > 0)
    {
      ++entry;
      continue;
    }
    for (const int64_t number : groups_.at(group))
    {
      Robot& robot = robots_.at(number);
      results.push_back({ robot.request.trial, robot.request.id, robot.evaluation(),
                          robot.verdict ? REFEREE : robot.opinions.front().worker });
      robots_.erase(number);
    }
    groups_.erase(group);
    entry = unsettled_.erase(entry);
  }
  return results;
}

std::vector<Comparison> WorkLedger::takeComparisons()
{
  return std::exchange(comparisons_, {});
}
}  // namespace devo_evo
