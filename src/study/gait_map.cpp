#include "devo_evo/study/gait_map.h"

#include "devo_evo/evolution/random.h"
#include "devo_evo/soft_body/simulation.h"
#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>

namespace devo_evo
{
namespace
{
constexpr double LEG_STEP = 0.5;     // standard deviation of a change, half the range
constexpr double WEIGHT_STEP = 1.0;  // likewise

RandomStream streamOf(const GaitSearch& search, RandomPurpose purpose, int64_t gait, int64_t number)
{
  return { search.seed, "gait map", gait, 0, number, purpose };
}

/// Without development: the final values follow the initial ones.
QuadrupedProgram withoutDevelopment(QuadrupedProgram program)
{
  program.leg_length_final = program.leg_length_initial;
  program.weight_final = program.weight_initial;
  return program;
}

QuadrupedProgram randomProgram(RandomStream random)
{
  QuadrupedProgram program;
  for (double& length : program.leg_length_initial)
  {
    length = random.uniform();
  }
  for (double& weight : program.weight_initial)
  {
    weight = random.uniform(-1.0, 1.0);
  }
  return withoutDevelopment(program);
}

template <size_t N>
void mutateOneOnAverage(std::array<double, N>& values, double step, double low, RandomStream& random)
{
  for (double& value : values)
  {
    const bool changes = random.uniform() < 1.0 / N;
    const double deviate = random.normal();
    value = changes ? std::clamp(value + step * deviate, low, 1.0) : value;
  }
}

QuadrupedProgram mutated(QuadrupedProgram program, RandomStream random)
{
  mutateOneOnAverage(program.leg_length_initial, LEG_STEP, 0.0, random);
  mutateOneOnAverage(program.weight_initial, WEIGHT_STEP, -1.0, random);
  return withoutDevelopment(program);
}

QuadrupedProgram mutatedControl(QuadrupedProgram program, RandomStream random)
{
  mutateOneOnAverage(program.weight_initial, WEIGHT_STEP, -1.0, random);
  mutateOneOnAverage(program.weight_final, WEIGHT_STEP, -1.0, random);
  return program;
}

/// Born with its legs half out, which it draws in over its life.
QuadrupedProgram drawingIn(QuadrupedProgram program)
{
  program.leg_length_initial.fill(0.5);
  program.leg_length_final.fill(0.0);
  return program;
}

double turnsOf(const QuadrupedEvaluation& evaluation)
{
  return evaluation.valid ? evaluation.turns : -std::numeric_limits<double>::infinity();
}

/// How good a robot is at a gait, to be compared in its order: whether it has it at all, then its fitness. Who does not
/// roll yet is the closer to it the more it turns; who does not walk yet, the less its abdomen lies on the floor.
std::pair<bool, double> skill(Gait gait, const QuadrupedEvaluation& evaluation)
{
  if (gaitOf(evaluation) == gait)
  {
    return { true, evaluation.fitness };
  }
  const bool lies = gait == Gait::WALKING && evaluation.valid;
  return { false, lies ? -evaluation.abdomen_contact : turnsOf(evaluation) };
}

constexpr int64_t DRAWING_IN = 2;  // beside the gaits: which random numbers its climb has

/// The search of one world.
class Search
{
public:
  Search(const RigidBodySettings& world, const GaitSearch& search, const std::atomic<bool>* stop)
    : search_(search), stop_(stop)
  {
    cell_.world = world;
  }

  GaitMapCell run()
  {
    RigidBodySettings without_protrusion = cell_.world;
    without_protrusion.leg_residual = 0.0;
    cell_.passive = live(cell_.world, QuadrupedProgram()).evaluation;
    cell_.smooth = live(without_protrusion, QuadrupedProgram()).evaluation;
    std::vector<QuadrupedProgram> beginners = search_.known;
    for (int64_t number = 0; number < search_.random_robots; ++number)
    {
      beginners.push_back(randomProgram(streamOf(search_, RandomPurpose::GAIT_MAP_ROBOT, 0, number)));
    }
    const std::vector<LivedQuadruped> constant = liveAll(beginners, withoutDevelopment);
    cell_.walking = bestOf(Gait::WALKING, constant);
    cell_.rolling = bestOf(Gait::ROLLING, constant);
    const auto turns_less = [](const LivedQuadruped& a, const LivedQuadruped& b)
    { return turnsOf(a.evaluation) < turnsOf(b.evaluation); };
    cell_.drawing_in =
        climb(liveAll(beginners, drawingIn), turns_less, mutatedControl, DRAWING_IN, 2 * search_.climbing_steps);
    return cell_;
  }

private:
  LivedQuadruped live(const RigidBodySettings& world, const QuadrupedProgram& program)
  {
    ++cell_.evaluations;
    return { program, evaluateQuadruped(world, program, stop_) };
  }

  template <class Change>
  std::vector<LivedQuadruped> liveAll(const std::vector<QuadrupedProgram>& programs, Change change)
  {
    std::vector<LivedQuadruped> lived;
    for (const QuadrupedProgram& program : programs)
    {
      lived.push_back(live(cell_.world, change(program)));
    }
    return lived;
  }

  /// @return the best at a gait, if it has it.
  std::optional<LivedQuadruped> bestOf(Gait gait, const std::vector<LivedQuadruped>& beginners)
  {
    const auto worse = [gait](const LivedQuadruped& a, const LivedQuadruped& b)
    { return skill(gait, a.evaluation) < skill(gait, b.evaluation); };
    const LivedQuadruped best = climb(beginners, worse, mutated, static_cast<int64_t>(gait), search_.climbing_steps);
    return gaitOf(best.evaluation) == gait ? std::optional<LivedQuadruped>(best) : std::nullopt;
  }

  /// A hill climb from the best. @pre there are beginners.
  template <class Worse, class Mutate>
  LivedQuadruped climb(const std::vector<LivedQuadruped>& beginners, Worse worse, Mutate mutate, int64_t number,
                       int64_t steps)
  {
    LivedQuadruped best = *std::max_element(beginners.begin(), beginners.end(), worse);
    for (int64_t step = 0; step < steps; ++step)
    {
      const LivedQuadruped next =
          live(cell_.world, mutate(best.program, streamOf(search_, RandomPurpose::GAIT_MAP_STEP, number, step)));
      best = worse(next, best) ? best : next;
    }
    return best;
  }

  const GaitSearch& search_;
  const std::atomic<bool>* const stop_;
  GaitMapCell cell_;
};

std::vector<GaitMapCell> worldsOf(const RigidBodySettings& world, const std::vector<double>& slopes,
                                  const std::vector<double>& residuals)
{
  std::vector<GaitMapCell> cells;
  for (const double slope : slopes)
  {
    for (const double residual : residuals)
    {
      GaitMapCell cell;
      cell.world = world;
      cell.world.slope = slope;
      cell.world.leg_residual = residual;
      cell.world.validate();
      cells.push_back(cell);
    }
  }
  return cells;
}

/// The worlds of a map, searched by several threads.
class MapWork
{
public:
  MapWork(std::vector<GaitMapCell> cells, const GaitSearch& search, GaitMapObserver& observer)
    : cells_(std::move(cells)), search_(search), observer_(observer)
  {
  }

  std::vector<GaitMapCell> run(int threads)
  {
    std::vector<std::thread> workers;
    working_ = threads;
    for (int i = 0; i < threads; ++i)
    {
      workers.emplace_back(&MapWork::work, this);
    }
    watch();
    for (std::thread& worker : workers)
    {
      worker.join();
    }
    if (failure_)
    {
      std::rethrow_exception(failure_);
    }
    return cells_;
  }

private:
  void work()
  {
    try
    {
      for (size_t i = next_++; i < cells_.size() && !stop_; i = next_++)
      {
        cells_[i] = searchGaits(cells_[i].world, search_, &stop_);
        const std::lock_guard<std::mutex> lock(mutex_);
        observer_.cellDone(cells_[i]);
      }
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      failure_ = failure_ ? failure_ : std::current_exception();
      stop_ = true;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    --working_;
    changed_.notify_all();
  }

  /// Asks the observer until all work is done.
  void watch()
  {
    constexpr std::chrono::milliseconds period{ 100 };
    std::unique_lock<std::mutex> lock(mutex_);
    while (!changed_.wait_for(lock, period, [this] { return working_ == 0; }))
    {
      if (observer_.stopRequested() && !stop_)
      {
        failure_ = failure_ ? failure_ : std::make_exception_ptr(EvaluationAbandoned());
        stop_ = true;
      }
    }
  }

  std::vector<GaitMapCell> cells_;
  const GaitSearch& search_;
  GaitMapObserver& observer_;
  std::atomic<size_t> next_{ 0 };
  std::atomic<bool> stop_{ false };
  std::mutex mutex_;
  std::condition_variable changed_;
  int working_ = 0;             ///< threads at work; guarded by mutex_
  std::exception_ptr failure_;  ///< the first; guarded by mutex_
};
}  // namespace

std::optional<Gait> gaitOf(const QuadrupedEvaluation& evaluation)
{
  constexpr double mostly = 0.5, turned_over = 0.5;
  if (!evaluation.valid)
  {
    return std::nullopt;
  }
  if (evaluation.turns >= 1.0)
  {
    return Gait::ROLLING;
  }
  const bool on_legs = evaluation.abdomen_contact < mostly;
  return on_legs && std::abs(evaluation.turns) < turned_over ? std::optional<Gait>(Gait::WALKING) : std::nullopt;
}

PaperObservations observe(const GaitMapCell& cell)
{
  constexpr double clearly = 1.1;
  const double walking_speed = cell.walking ? cell.walking->evaluation.descent / cell.world.lifetime : 0.0;
  const QuadrupedEvaluation& drawing_in = cell.drawing_in.evaluation;
  PaperObservations seen;
  seen.walks = cell.walking && cell.walking->evaluation.descent >= 2.0 * cell.world.abdomen_radius;
  seen.rolls_better =
      cell.walking && cell.rolling && cell.rolling->evaluation.fitness > clearly * cell.walking->evaluation.fitness;
  seen.protruding_hinders = cell.rolling && clearly * cell.passive.descent < cell.smooth.descent &&
                            cell.rolling->evaluation.descent > cell.passive.descent;
  seen.drawing_in_rolls = drawing_in.first_roll_s && *drawing_in.first_roll_s > 0.5 * cell.world.lifetime &&
                          drawing_in.velocity.back() > walking_speed;
  return seen;
}

void GaitSearch::validate() const
{
  constexpr int64_t most = 1000000;
  const auto check = [](const char* name, int64_t value)
  {
    if (value < 0 || value > most)
    {
      throw InvalidInput(std::string(name) + " is " + toText(value) + "; it must lie within 0 to " + toText(most));
    }
  };
  check("random_robots", random_robots);
  check("climbing_steps", climbing_steps);
  if (known.empty() && random_robots == 0)
  {
    throw InvalidInput("there are no known robots and random_robots is 0; a search begins with at least one robot");
  }
  std::for_each(known.begin(), known.end(), [](const QuadrupedProgram& program) { devo_evo::validate(program); });
}

GaitMapCell searchGaits(const RigidBodySettings& world, const GaitSearch& search, const std::atomic<bool>* stop)
{
  search.validate();
  return Search(world, search, stop).run();
}

std::vector<GaitMapCell> mapGaits(const RigidBodySettings& world, const std::vector<double>& slopes,
                                  const std::vector<double>& residuals, const GaitSearch& search, int threads,
                                  GaitMapObserver& observer)
{
  search.validate();
  return MapWork(worldsOf(world, slopes, residuals), search, observer).run(threads);
}
}  // namespace devo_evo
