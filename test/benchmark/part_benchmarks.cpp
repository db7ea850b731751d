#include "benchmark/part_benchmarks.h"

#include "benchmark/counted_parts.h"
#include "benchmark/fastest_slices.h"
#include "benchmark/instruction_sets.h"
#include "benchmark/kernel_parts.h"
#include "benchmark/life_scenes.h"
#include "benchmark/living_batch.h"
#include "devo_evo/soft_body/simulation.h"
#include "devo_evo/soft_body/text.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace devo_evo
{
namespace
{
constexpr int MOMENTS = 8;   // of each life
constexpr int ROUNDS = 200;  // of which the fastest counts
constexpr int MANY_LISTINGS = 10;
constexpr int LIMIT_ROUNDS = 1 << 20;

const std::array<const char*, KERNEL_PARTS> PART_NAMES = { "collisions", "deformation", "rotations",
                                                           "loads",      "floor",       "translation",
                                                           "rotation",   "actuation",   "book_keeping" };

const std::array<const char*, LIMITING_OPERATIONS> OPERATION_NAMES = { "multiply_add", "division", "square_root" };

/// What there is of one instruction set.
struct Target
{
  InstructionSet instruction_set;
  const Kernel* kernel;
  const KernelParts* parts;
  const ProcessorLimits* limits;  ///< null for one number at a time
};

bool fusesMultiplyAdd()
{
#if defined(__x86_64__)
  return scalarFmaKernel() != nullptr && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

Target targetOf(InstructionSet instruction_set)
{
  switch (instruction_set)
  {
    case InstructionSet::AVX512:
      return { instruction_set, avx512Kernel(), avx512KernelParts(), avx512Limits() };
    case InstructionSet::AVX2:
      return { instruction_set, avx2Kernel(), avx2KernelParts(), avx2Limits() };
    case InstructionSet::SCALAR:
      break;
  }
  return fusesMultiplyAdd() ? Target{ instruction_set, scalarFmaKernel(), scalarFmaKernelParts(), nullptr }
                            : Target{ instruction_set, scalarKernel(), scalarKernelParts(), nullptr };
}

using Robots = std::vector<DevelopmentalProgram>;

/// The robots that everything here is measured with, in groups that fill the lanes.
struct Groups
{
  explicit Groups(const Kernel& kernel)
  {
    const LifeScene scene = lifeScene("lifetime_10_s");
    settings = scene.settings;
    for (auto first = scene.robots.begin(); first != scene.robots.end(); first += kernel.lanes)
    {
      robots.emplace_back(first, first + kernel.lanes);
    }
  }

  SoftBodySettings settings;
  std::vector<Robots> robots;
};

/// @throw std::runtime_error unless the batch is where a simulation of the same robots has come to.
void checkLivesAsSimulated(LivingBatch& batch, const SoftBodySettings& settings, const Robots& robots,
                           const Target& target)
{
  const auto simulation = makeSimulation(settings, robots, target.instruction_set);
  while (!simulation->finished())
  {
    simulation->step();
  }
  for (int voxel = 0; voxel < settings.voxelCount(); ++voxel)
  {
    for (int robot = 0; robot < simulation->robotCount(); ++robot)
    {
      const double height = batch.state().voxels[(voxel * VOXEL_FIELDS + POSITION + 2) * target.kernel->lanes + robot];
      if (simulation->voxel(robot, voxel).position.z() != height)
      {
        throw std::runtime_error("test/benchmark/living_batch.cpp does not do what Simulation does");
      }
    }
  }
}

/// @throw std::runtime_error unless the parts together do what the kernel does.
void checkPartsMakeUpKernel(LivingBatch& batch, const Moment& moment, const Target& target)
{
  const auto bytes = [](const std::vector<BatchMemory::Row>& rows) { return rows.size() * sizeof(BatchMemory::Row); };
  batch.restore(moment);
  target.kernel->step(batch.model(), moment.clock, batch.state());
  const BatchMemory expected = batch.memory();
  batch.restore(moment);
  target.parts->step_until[BOOK_KEEPING](batch.model(), moment.clock, batch.state());
  const BatchMemory& found = batch.memory();
  if (std::memcmp(found.voxels.data(), expected.voxels.data(), bytes(found.voxels)) != 0 ||
      std::memcmp(found.bonds.data(), expected.bonds.data(), bytes(found.bonds)) != 0)
  {
    throw std::runtime_error("test/benchmark/kernel_parts-inl.h does not do what the kernel does");
  }
}

/// Moments spread over the lives of all groups.
std::vector<Moment> collectMoments(const Target& target)
{
  const Groups groups(*target.kernel);
  std::vector<Moment> moments;
  for (const Robots& robots : groups.robots)
  {
    LivingBatch batch(groups.settings, robots, *target.kernel);
    int taken = 0;
    while (!batch.finished())
    {
      const double due = SETTLING_TIME + groups.settings.lifetime * (taken + 0.5) / MOMENTS;
      const bool wanted = taken < MOMENTS && batch.time() > due;
      batch.step(wanted ? &moments : nullptr);
      taken += wanted ? 1 : 0;
    }
    checkLivesAsSimulated(batch, groups.settings, robots, target);
    checkPartsMakeUpKernel(batch, moments.back(), target);
  }
  return moments;
}

const std::vector<Moment>& momentsOf(const Target& target)
{
  static std::map<InstructionSet, std::vector<Moment>> moments;
  auto found = moments.find(target.instruction_set);
  if (found == moments.end())
  {
    found = moments.emplace(target.instruction_set, collectMoments(target)).first;
  }
  return found->second;
}

void nothing(const BodyModel&, const StepClock&, BatchState&)
{
}

using Clock = std::chrono::steady_clock;

/// Brings a batch to the step after a moment; by a step, so that the caches hold what they hold in a life.
void arriveAt(const Moment& moment, const Target& target, LivingBatch& batch)
{
  batch.restore(moment);
  target.kernel->step(batch.model(), moment.clock, batch.state());
}

Clock::duration timeOnce(StepFunction step, const Moment& moment, const Target& target, LivingBatch& batch)
{
  arriveAt(moment, target, batch);
  const Clock::time_point start = Clock::now();
  step(batch.model(), moment.clock, batch.state());
  return Clock::now() - start;
}

/// Of each step function the mean over the moments of the fastest of several rounds, without reading the clock [s].
/// They take turns, so that they are comparable even while the processor changes its frequency.
std::vector<double> secondsPerStep(const std::vector<StepFunction>& steps, const std::vector<Moment>& moments,
                                   const Target& target, LivingBatch& batch)
{
  std::vector<double> seconds(steps.size(), 0.0);
  for (const Moment& moment : moments)
  {
    Clock::duration overhead = Clock::duration::max();
    std::vector<Clock::duration> fastest(steps.size(), Clock::duration::max());
    for (int round = 0; round < ROUNDS; ++round)
    {
      overhead = std::min(overhead, timeOnce(nothing, moment, target, batch));
      for (size_t i = 0; i < steps.size(); ++i)
      {
        fastest[i] = std::min(fastest[i], timeOnce(steps[i], moment, target, batch));
      }
    }
    for (size_t i = 0; i < steps.size(); ++i)
    {
      seconds[i] += std::chrono::duration<double>(fastest[i] - overhead).count() / static_cast<double>(moments.size());
    }
  }
  return seconds;
}

/// Mean over the moments of what a step until a part takes.
OperationCounts operationsPerStep(KernelPart part, const std::vector<Moment>& moments, const Target& target,
                                  LivingBatch& batch)
{
  OperationCounts sum;
  const auto weight = 1.0 / static_cast<double>(moments.size());
  for (const Moment& moment : moments)
  {
    arriveAt(moment, target, batch);
    const OperationCounts counts =
        countOperations(part, target.kernel->lanes, batch.model(), moment.clock, batch.state());
    sum.multiply_adds += weight * counts.multiply_adds;
    sum.simple += weight * counts.simple;
    sum.divisions += weight * counts.divisions;
    sum.square_roots += weight * counts.square_roots;
    sum.selections += weight * counts.selections;
  }
  return sum;
}

void runParts(benchmark::State& state, const Target& target)
{
  const std::vector<Moment>& moments = momentsOf(target);
  const Groups groups(*target.kernel);
  LivingBatch batch(groups.settings, groups.robots.front(), *target.kernel);
  std::vector<StepFunction> steps(target.parts->step_until, target.parts->step_until + KERNEL_PARTS);
  steps.push_back(target.kernel->step);
  std::vector<double> seconds;
  for (auto _ : state)
  {
    seconds = secondsPerStep(steps, moments, target, batch);
    state.SetIterationTime(seconds.back());
  }
  for (int part = 0; part < KERNEL_PARTS; ++part)
  {
    const std::string name = std::string("until_") + PART_NAMES[static_cast<size_t>(part)];
    const OperationCounts counts = operationsPerStep(static_cast<KernelPart>(part), moments, target, batch);
    state.counters[name + ".us"] = 1e6 * seconds[static_cast<size_t>(part)];
    state.counters[name + ".multiply_adds"] = counts.multiply_adds;
    state.counters[name + ".simple"] = counts.simple;
    state.counters[name + ".divisions"] = counts.divisions;
    state.counters[name + ".square_roots"] = counts.square_roots;
    state.counters[name + ".selections"] = counts.selections;
  }
  state.counters["kernel.us"] = 1e6 * seconds.back();
  state.counters["bonds"] = static_cast<double>(moments.front().memory.small_angle.size());
  state.counters["voxels"] = groups.settings.voxelCount();
}

void runLoop(benchmark::State& state, int listings, const Target& target, const std::shared_ptr<FastestSlices>& slices)
{
  const Groups groups(*target.kernel);
  int64_t steps = 0;
  for (auto _ : state)
  {
    slices->begin();
    for (const Robots& robots : groups.robots)
    {
      LivingBatch batch(groups.settings, robots, *target.kernel, listings);
      while (!batch.finished())
      {
        batch.step();
        slices->took(batch.stepCount());
      }
      slices->endSlice();
      steps += batch.stepCount();
    }
    state.SetIterationTime(slices->sum());
  }
  using benchmark::Counter;
  state.counters["us_per_step"] =
      Counter(1e-6 * static_cast<double>(steps), Counter::Flags(Counter::kIsRate | Counter::kInvert));
}

void runLimit(benchmark::State& state, LimitFunction function, int operations, int lanes)
{
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(function(LIMIT_ROUNDS));
  }
  using benchmark::Counter;
  const double count = static_cast<double>(operations) * LIMIT_ROUNDS;
  state.counters["ns_per_operation"] = Counter(1e-9 * count, Counter::Flags(Counter::kIsRate | Counter::kInvert));
  state.counters["lanes"] = lanes;
}

template <class Function, class... Arguments>
benchmark::internal::Benchmark* add(const std::string& name, Function function, Arguments... arguments)
{
  return benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

void registerLimits(const std::string& instruction_set, const ProcessorLimits& limits)
{
  for (int operation = 0; operation < LIMITING_OPERATIONS; ++operation)
  {
    const std::string name = "limits/" + instruction_set + "/" + OPERATION_NAMES[static_cast<size_t>(operation)];
    add(name + "/independent", runLimit, limits.independent[operation], ProcessorLimits::INDEPENDENT, limits.lanes);
    add(name + "/dependent", runLimit, limits.dependent[operation], 1, limits.lanes);
  }
}
}  // namespace

void registerPartBenchmarks()
{
  for (const InstructionSet instruction_set : measuredInstructionSets())
  {
    const Target target = targetOf(instruction_set);
    const std::string name = toString(instruction_set);
    add("parts/" + name, runParts, target)->UseManualTime();
    for (const int listings : { 1, MANY_LISTINGS })
    {
      add("loop/" + name + "/listings:" + toText(listings), runLoop, listings, target,
          std::make_shared<FastestSlices>())
          ->UseManualTime();
    }
    if (target.limits != nullptr)
    {
      registerLimits(name, *target.limits);
    }
  }
}
}  // namespace devo_evo
