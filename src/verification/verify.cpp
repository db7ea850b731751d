#include "devo_evo/verification/verify.h"

#include "devo_evo/soft_body/text.h"
#include "verification/trial_replay.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace devo_evo
{
namespace
{
/// Which individuals of a scope are simulated.
class ChosenLives
{
public:
  ChosenLives(const Archive& archive, const VerificationScope& scope) : scope_(scope)
  {
    for (const int64_t trial : archive.trials())
    {
      before_[trial] = total_;
      total_ += archive.extentOf(trial).next_id;
      if (!scope.all && !scope.lineage_of)
      {
        chosen_.emplace(trial, archive.championOf(trial));
      }
    }
    if (scope.lineage_of)
    {
      addLineage(archive, *scope.lineage_of);
    }
  }

  bool has(const Individual& individual) const
  {
    if (scope_.all || chosen_.count({ individual.trial, individual.id }) != 0)
    {
      return true;
    }
    if (scope_.lineage_of)
    {
      return false;
    }
    const int64_t number = before_.at(individual.trial) + individual.id;
    const int64_t sample = std::min(scope_.sample, total_);
    return (number + 1) * sample / total_ > number * sample / total_;  // evenly spread
  }

private:
  void addLineage(const Archive& archive, int64_t trial)
  {
    for (int64_t id = archive.championOf(trial); id != Individual::NO_PARENT;)
    {
      chosen_.emplace(trial, id);
      const auto row = archive.readIndividuals(trial, id, 1);
      id = row.empty() ? Individual::NO_PARENT : row.front().individual.parent;
    }
  }

  const VerificationScope scope_;
  std::set<std::pair<int64_t, int64_t>> chosen_;
  std::map<int64_t, int64_t> before_;  ///< how many individuals earlier trials have, by trial
  int64_t total_ = 0;
};

/// Hands individuals to the farm and compares what comes back.
class Lives
{
public:
  Lives(Farm& farm, std::shared_ptr<const Body> body) : farm_(farm), body_(std::move(body)) {}

  void repeat(const std::vector<Individual>& individuals)
  {
    std::vector<EvaluationRequest> requests;
    for (const Individual& individual : individuals)
    {
      const std::pair<int64_t, int64_t> name(individual.trial, individual.id);
      if (pending_.emplace(name, individual).second)
      {
        requests.push_back({ individual.trial, individual.id, individual.genome.program });
      }
    }
    farm_.submit(std::move(requests));
  }

  void collect(std::chrono::milliseconds timeout)
  {
    for (const EvaluationResult& result : farm_.collect(timeout))
    {
      const auto individual = pending_.extract({ result.trial, result.id });
      if (individual.empty())
      {
        continue;
      }
      ++repeated_;
      try
      {
        compareLife(individual.mapped(), result.evaluation, *body_);
      }
      catch (const Offence& offence)
      {
        offences_.push_back(offence);
      }
    }
  }

  size_t pending() const { return pending_.size(); }
  int64_t repeated() const { return repeated_; }
  const std::vector<Offence>& offences() const { return offences_; }

private:
  Farm& farm_;
  const std::shared_ptr<const Body> body_;
  std::map<std::pair<int64_t, int64_t>, Individual> pending_;
  std::vector<Offence> offences_;
  int64_t repeated_ = 0;
};

/// Offences against an individual go before those against its generation, which follow from them.
bool comesBefore(const Offence& a, const Offence& b)
{
  const auto key = [](const Offence& offence)
  { return std::make_tuple(offence.trial, offence.generation, offence.id < 0 ? INT64_MAX : offence.id); };
  return key(a) < key(b);
}

class Verifier
{
public:
  Verifier(const Archive& archive, const VerificationScope& scope, Farm& farm,
           const std::function<bool(const Verification&)>& progress)
    : archive_(archive)
    , settings_(archive.settings())
    , chosen_(archive, scope)
    , lives_(farm, makeBody(settings_.body))
    , progress_(progress)
  {
  }

  Verification run()
  {
    if (const auto damage = archive_.findDamage())
    {
      offences_.push_back(*damage);
    }
    for (const int64_t trial : archive_.trials())
    {
      if (!goOn())
      {
        break;
      }
      replay(trial);
    }
    while (lives_.pending() > 0 && report_.complete)
    {
      collect(std::chrono::milliseconds(100));
    }
    offences_.insert(offences_.end(), lives_.offences().begin(), lives_.offences().end());
    if (!offences_.empty())
    {
      report_.offence = *std::min_element(offences_.begin(), offences_.end(), comesBefore);
    }
    report_.simulated = lives_.repeated();
    return report_;
  }

private:
  bool goOn() const { return report_.complete && offences_.empty() && lives_.offences().empty(); }

  void replay(int64_t trial)
  {
    try
    {
      TrialReplay replay(archive_, settings_, trial);
      ++report_.trials;
      const int64_t genomes_before = report_.genomes;
      while (!replay.finished() && goOn())
      {
        replayGeneration(replay);
        report_.genomes = genomes_before + replay.storedGenomes();
      }
    }
    catch (const Offence& offence)
    {
      offences_.push_back(offence);
    }
  }

  void replayGeneration(TrialReplay& replay)
  {
    std::vector<Individual> lives;
    for (const ArchivedIndividual& newcomer : replay.nextGeneration())
    {
      ++report_.individuals;
      if (chosen_.has(newcomer.individual))
      {
        lives.push_back(newcomer.individual);
      }
    }
    lives_.repeat(lives);
    try
    {
      replay.select();
    }
    catch (const Offence&)
    {
      // Most likely somebody's fitness is not what it was: find out whose.
      lives_.repeat(replay.candidates());
      throw;
    }
    ++report_.generations;
    do
    {
      collect(std::chrono::milliseconds(lives_.pending() > MOST_PENDING ? 100 : 0));
    } while (lives_.pending() > MOST_PENDING && report_.complete);
  }

  void collect(std::chrono::milliseconds timeout)
  {
    lives_.collect(timeout);
    report_.simulated = lives_.repeated();
    report_.complete = progress_(report_);
  }

  static constexpr size_t MOST_PENDING = 2000;  // bounds the memory; enough to keep many cores busy

  const Archive& archive_;
  const ExperimentSettings settings_;
  const ChosenLives chosen_;
  Lives lives_;
  const std::function<bool(const Verification&)>& progress_;
  Verification report_;
  std::vector<Offence> offences_;
};
}  // namespace

Verification verify(const Archive& archive, const VerificationScope& scope, Farm& farm,
                    const std::function<bool(const Verification&)>& progress)
{
  return Verifier(archive, scope, farm, progress).run();
}
}  // namespace devo_evo
