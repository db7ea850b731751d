#include "study/speed.h"

#include "devo_evo/bodies/bodies.h"
#include "devo_evo/evolution/genome.h"
#include "devo_evo/rigid_body/quadruped.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace devo_evo
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr auto WARM_UP = std::chrono::milliseconds(200);
constexpr auto MEASURED = std::chrono::milliseconds(800);

std::vector<DevelopmentalProgram> randomRobots(const SoftBodySettings& body, int count)
{
  const EvolutionSettings evolution;
  const GenomeLayout layout = makeSoftBody(body)->layout(evolution);
  std::vector<DevelopmentalProgram> robots;
  for (int id = 0; id < count; ++id)
  {
    robots.push_back(bornGenome(evolution, layout, 1, 0, id, nullptr).program);
  }
  return robots;
}
}  // namespace

double evaluationsPerSecond(const SoftBodySettings& body, int threads, InstructionSet instruction_set)
{
  const int lanes = laneCount(instruction_set);
  const std::vector<DevelopmentalProgram> robots = randomRobots(body, lanes);
  const Clock::time_point start = Clock::now() + WARM_UP, end = start + MEASURED;
  std::atomic<int64_t> steps{ 0 };
  const auto simulate = [&]
  {
    auto simulation = makeSimulation(body, robots, instruction_set);
    int64_t counted = 0;
    for (Clock::time_point now = Clock::now(); now < end || counted == 0; now = Clock::now())
    {
      simulation = simulation->finished() ? makeSimulation(body, robots, instruction_set) : std::move(simulation);
      simulation->step();
      counted += now >= start ? 1 : 0;
    }
    steps += counted;
  };
  std::vector<std::thread> workers;
  for (int i = 1; i < threads; ++i)
  {
    workers.emplace_back(simulate);
  }
  simulate();
  for (std::thread& worker : workers)
  {
    worker.join();
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const double steps_of_a_life = (SETTLING_TIME + body.lifetime) / body.timeStep();
  return static_cast<double>(steps * lanes) / steps_of_a_life / seconds;
}

double quadrupedsPerSecond(const RigidBodySettings& world, int threads)
{
  RigidBodySettings endless = world;
  endless.lifetime = std::min(1000.0, 1e6 * world.time_step);  // within what settings allow
  QuadrupedProgram program;
  program.leg_length_initial.fill(0.5);
  program.leg_length_final.fill(0.5);
  QuadrupedSimulation simulation(endless, program);
  const Clock::time_point start = Clock::now();
  while (Clock::now() < start + MEASURED && !simulation.finished())
  {
    simulation.step();
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const auto steps_of_a_life = static_cast<double>(world.stepCount());
  return threads * static_cast<double>(simulation.stepCount()) / steps_of_a_life / seconds;
}
}  // namespace devo_evo
