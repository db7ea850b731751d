#include "benchmark/life_benchmarks.h"

#include "benchmark/fastest_slices.h"
#include "benchmark/instruction_sets.h"
#include "benchmark/known_results.h"
#include "benchmark/life_scenes.h"
#include "devo_evo/soft_body/lattice.h"
#include "devo_evo/soft_body/simulation.h"
#include "devo_evo/soft_body/text.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>

namespace devo_evo
{
namespace
{
constexpr double WARM_UP = 0.05;         // [s] of a life
constexpr double USUAL_LIFETIME = 10.0;  // [s], for which times of an evaluation are given

/// Steps from the start of the simulation to the end of a life that ends regularly.
int64_t stepsOfLife(const SoftBodySettings& settings)
{
  int64_t steps = 0;
  for (double time = 0.0; time <= SETTLING_TIME + settings.lifetime; time += settings.timeStep())
  {
    ++steps;
  }
  return steps;
}

void warmUp(const LifeScene& scene, InstructionSet instruction_set)
{
  SoftBodySettings briefly = scene.settings;
  briefly.lifetime = WARM_UP;
  evaluate(briefly, scene.robots, instruction_set);
}

/// Who diverges is simulated for fewer steps than report() takes for granted.
void checkAllLivedOn(const LifeScene& scene, const std::vector<Evaluation>& evaluations)
{
  if (!std::all_of(evaluations.begin(), evaluations.end(), [](const Evaluation& each) { return each.valid; }))
  {
    throw std::runtime_error("a robot of scene " + scene.name + " diverges: take others");
  }
}

/// What evaluate() does, in slices.
std::vector<Evaluation> evaluateInSlices(const LifeScene& scene, InstructionSet instruction_set, FastestSlices& slices)
{
  const size_t lanes = static_cast<size_t>(laneCount(instruction_set));
  std::vector<Evaluation> evaluations;
  slices.begin();
  for (size_t first = 0; first < scene.robots.size(); first += lanes)
  {
    const auto begin = scene.robots.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(lanes, scene.robots.size() - first));
    const auto simulation = makeSimulation(scene.settings, { begin, end }, instruction_set);
    while (!simulation->finished())
    {
      simulation->step();
      slices.took(simulation->stepCount());
    }
    for (int robot = 0; robot < simulation->robotCount(); ++robot)
    {
      evaluations.push_back(simulation->evaluation(robot));
    }
    slices.endSlice();
  }
  return evaluations;
}

/// Counters are per CPU second of the one thread that works.
void report(benchmark::State& state, const LifeScene& scene, InstructionSet instruction_set)
{
  using benchmark::Counter;
  SoftBodySettings usual = scene.settings;
  usual.lifetime = USUAL_LIFETIME;
  const double steps = static_cast<double>(stepsOfLife(scene.settings));
  const double steps_of_usual_life = static_cast<double>(stepsOfLife(usual));
  const double robots = static_cast<double>(scene.robots.size());
  const double lanes = laneCount(instruction_set);
  const double groups =
      static_cast<double>((scene.robots.size() + static_cast<size_t>(lanes) - 1) / static_cast<size_t>(lanes));
  const double bonds = static_cast<double>(Lattice(scene.settings).bonds().size());
  const double evaluations = robots * steps / steps_of_usual_life;
  const double nanosecond = 1e-9;
  const auto rate = [&state](double count)
  { return Counter(count, Counter::kIsIterationInvariantRate, Counter::kIs1000); };
  const auto inverse = [&state](double count)
  { return Counter(count, Counter::Flags(Counter::kIsIterationInvariantRate | Counter::kInvert), Counter::kIs1000); };

  state.counters["robots"] = robots;
  state.counters["voxels"] = scene.settings.voxelCount();
  state.counters["lifetime_s"] = scene.settings.lifetime;
  state.counters["evaluations_per_s"] = rate(evaluations);
  state.counters["s_per_evaluation"] = inverse(evaluations);
  state.counters["voxel_steps_per_s"] = rate(robots * steps * scene.settings.voxelCount());
  state.counters["times_real_time"] = rate(robots * (SETTLING_TIME + scene.settings.lifetime));
  state.counters["us_per_step"] = inverse(groups * steps * 1e-6);
  state.counters["ns_per_bond_and_robot"] = inverse(robots * steps * bonds * nanosecond);
  state.counters["ns_per_bond_and_group"] = inverse(groups * steps * bonds * nanosecond);
}

void runLives(benchmark::State& state, const LifeScene& scene, InstructionSet instruction_set,
              const std::shared_ptr<FastestSlices>& slices)
{
  warmUp(scene, instruction_set);
  std::vector<Evaluation> evaluations;
  for (auto _ : state)
  {
    evaluations = evaluateInSlices(scene, instruction_set, *slices);
    state.SetIterationTime(slices->sum());
  }
  state.counters["whole_s"] = slices->whole();
  verifyResults(scene.name, combinedHash(evaluations));
  checkAllLivedOn(scene, evaluations);
  report(state, scene, instruction_set);
}
}  // namespace

void registerLifeBenchmarks()
{
  for (const LifeScene& scene : lifeScenes())
  {
    for (const InstructionSet instruction_set : measuredInstructionSets())
    {
      const std::string name = "lives/" + scene.name + "/" + toString(instruction_set);
      benchmark::RegisterBenchmark(name.c_str(), runLives, scene, instruction_set, std::make_shared<FastestSlices>())
          ->Iterations(1)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
    }
  }
}

void printLifeHashes()
{
  for (const LifeScene& scene : lifeScenes())
  {
    std::cout << scene.name << " " << hashToString(combinedHash(evaluate(scene.settings, scene.robots))) << std::endl;
  }
}
}  // namespace devo_evo
