#include "devo_evo/experiment/experiment.h"

#include "devo_evo/evolution/trial.h"
#include "experiment/evaluator_tally.h"
#include "experiment/rate_meter.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace devo_evo
{
namespace
{
using Clock = RateMeter::Clock;

using KnownEvaluations = std::map<Hash128, Evaluation>;

KnownEvaluations evaluationsOf(const std::vector<Individual>& individuals)
{
  KnownEvaluations known;
  for (const Individual& individual : individuals)
  {
    known.emplace(phenotypeHash(individual.genome.program), *individual.evaluation);
  }
  return known;
}
}  // namespace

/// One call of run(): the trials and who is being simulated for them.
class Experiment::Run
{
public:
  explicit Run(Experiment& experiment)
    : experiment_(experiment)
    , settings_(experiment.settings_)
    , evaluation_rate_(Clock::now(), std::chrono::seconds(10))
    , generation_rate_(Clock::now(), std::chrono::minutes(10))
  {
    const std::shared_ptr<const Body> body = makeBody(settings_.body);
    auto states = experiment_.archive_.trialStates();
    for (int64_t number = 1; number <= settings_.trials; ++number)
    {
      const auto state = states.find(number);
      if (state == states.end())
      {
        trials_.emplace(number, Trial(settings_.evolution, *body, number));
        generations_left_ += settings_.generations + 1;
        continue;
      }
      trials_.emplace(number, Trial(settings_.evolution, *body, number, state->second.generation,
                                    std::move(state->second.survivors), state->second.next_id));
      generations_left_ += std::max<int64_t>(0, settings_.generations - state->second.generation);
    }
  }

  RunOutcome run()
  {
    while (!experiment_.stop_now_ && !done())
    {
      bool wait = true;
      for (auto& [number, progress] : trials_)
      {
        advance(progress);
        wait = wait && !readyToSelect(progress);
      }
      commitFinished();
      for (const EvaluationResult& result : experiment_.farm_.collect(std::chrono::milliseconds(wait ? 100 : 0)))
      {
        take(result);
      }
      experiment_.observer_.tick();
    }
    return generations_left_ == 0 ? RunOutcome::FINISHED : RunOutcome::STOPPED;
  }

private:
  /// A trial, between two generations or in one.
  struct Progress
  {
    explicit Progress(Trial a_trial) : trial(std::move(a_trial)) {}

    Trial trial;
    bool running = false;                             ///< whether a generation has been started and not selected
    std::map<int64_t, std::vector<int64_t>> awaited;  ///< by the id under simulation: all of the same phenotype
    int64_t simulated = 0;                            ///< in this generation, by the farm
  };

  static bool readyToSelect(const Progress& progress) { return progress.running && progress.awaited.empty(); }

  bool done() const
  {
    const bool at_rest =
        std::none_of(trials_.begin(), trials_.end(), [](const auto& each) { return each.second.running; });
    return at_rest && (generations_left_ == 0 || experiment_.stop_after_generation_);
  }

  /// Whether the trial's next generation may begin.
  bool mayStart(const Progress& progress) const
  {
    const bool founders = !progress.trial.awaiting().empty();
    return !progress.running && !experiment_.paused_ && !experiment_.stop_after_generation_ &&
           (founders || progress.trial.generation() < settings_.generations);
  }

  void advance(Progress& progress)
  {
    if (readyToSelect(progress))
    {
      finishGeneration(progress);
    }
    else if (mayStart(progress))
    {
      startGeneration(progress, {});
    }
  }

  /// @param uncommitted evaluations that the archive does not know yet.
  void startGeneration(Progress& progress, const KnownEvaluations& uncommitted)
  {
    Trial& trial = progress.trial;
    if (trial.awaiting().empty())  // else they are the founders
    {
      trial.breed();
    }
    progress.running = true;
    progress.simulated = 0;
    std::vector<EvaluationRequest> requests;
    std::map<Hash128, int64_t> requested;
    for (const int64_t id : trial.awaiting())
    {
      const DevelopmentalProgram& program = trial.individual(id).genome.program;
      const Hash128 phenotype = phenotypeHash(program);
      const auto twin = requested.find(phenotype);
      if (twin != requested.end())
      {
        progress.awaited[twin->second].push_back(id);
      }
      else if (const auto known = findEvaluation(phenotype, uncommitted))
      {
        trial.setEvaluation(id, *known);
      }
      else
      {
        requested.emplace(phenotype, id);
        progress.awaited[id] = { id };
        requests.push_back({ trial.number(), id, program });
      }
    }
    experiment_.farm_.submit(std::move(requests));
  }

  std::optional<Evaluation> findEvaluation(const Hash128& phenotype, const KnownEvaluations& uncommitted) const
  {
    const auto known = uncommitted.find(phenotype);
    return known != uncommitted.end() ? known->second : experiment_.archive_.findEvaluation(phenotype);
  }

  /// Results that nobody waits for (left over from an earlier run, or come twice) are let pass.
  void take(const EvaluationResult& result)
  {
    const auto trial = trials_.find(result.trial);
    if (trial == trials_.end())
    {
      return;
    }
    Progress& progress = trial->second;
    const auto twins = progress.awaited.find(result.id);
    if (twins == progress.awaited.end())
    {
      return;
    }
    for (const int64_t id : twins->second)
    {
      progress.trial.setEvaluation(id, result.evaluation);
    }
    progress.awaited.erase(twins);
    evaluators_.count(result.worker);
    ++progress.simulated;
    ++total_evaluations_;
    evaluation_rate_.add(Clock::now(), 1);
  }

  /// The next generation is handed to the farm before this one is committed, so that nobody idles while the disk works.
  void finishGeneration(Progress& progress)
  {
    GenerationRecord record = progress.trial.select();
    const Individual champion = progress.trial.individual(record.champion);
    const int64_t simulated = progress.simulated;
    progress.running = false;
    if (mayStart(progress))
    {
      startGeneration(progress, evaluationsOf(record.newcomers));
    }
    finished_.push_back(std::move(record));
    reports_.push_back({ champion, simulated });
  }

  /// All trials' at once: a disk that must be sure of what it has written takes as long for one as for many.
  void commitFinished()
  {
    if (finished_.empty())
    {
      return;
    }
    experiment_.archive_.noteEvaluators(evaluators_.evaluators(experiment_.farm_.status()));
    experiment_.archive_.commitGenerations(finished_);
    for (size_t i = 0; i < finished_.size(); ++i)
    {
      --generations_left_;
      generation_rate_.add(Clock::now(), 1);
      experiment_.observer_.generationCommitted({ finished_[i], reports_[i].champion, reports_[i].simulated,
                                                  total_evaluations_, evaluation_rate_.rate(),
                                                  static_cast<double>(generations_left_) / generation_rate_.rate() });
    }
    finished_.clear();
    reports_.clear();
  }

  /// What is to be told of a finished generation besides its record.
  struct Report
  {
    Individual champion;
    int64_t simulated;
  };

  Experiment& experiment_;
  const ExperimentSettings& settings_;
  std::map<int64_t, Progress> trials_;      ///< by number
  std::vector<GenerationRecord> finished_;  ///< selected and not committed yet
  std::vector<Report> reports_;             ///< of these
  int64_t generations_left_ = 0;            ///< to commit, in all trials
  int64_t total_evaluations_ = 0;
  EvaluatorTally evaluators_;
  RateMeter evaluation_rate_;
  RateMeter generation_rate_;
};

Experiment::Experiment(const ExperimentSettings& settings, Archive& archive, Farm& farm, ExperimentObserver& observer)
  : settings_(settings), archive_(archive), farm_(farm), observer_(observer)
{
  settings.validate();
}

RunOutcome Experiment::run()
{
  return Run(*this).run();
}
}  // namespace devo_evo
