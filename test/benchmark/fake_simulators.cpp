// Many simulators in one process that simulate nothing: they answer after the time that true ones take, so that an
// evolver can be tried with more processors than there are. Used by scripts/benchmark_farm.
//
// Usage: fake_simulators COUNT BATCH_MILLISECONDS
//
// Says every second how large a share of that second the simulators had work, and how many evaluations they made.

#include "devo_evo/soft_body/simulation.h"
#include "devo_evo/soft_body/text.h"
#include "ros/checked_service.h"
#include "ros/conversions.h"
#include "ros/message_reader.h"
#include "ros/node_main.h"

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <iostream>
#include <memory>
#include <numeric>
#include <thread>

namespace devo_evo
{
namespace
{
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int LANES = 8;
constexpr double ANNOUNCEMENT_PERIOD = 0.5;

double mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// An evaluation that might be one, and depends on the robot alone.
Evaluation inventedEvaluation(const DevelopmentalProgram& robot, const SoftBodySettings& settings)
{
  Evaluation evaluation;
  evaluation.valid = true;
  evaluation.fitness = mean(robot.morphology_final) + mean(robot.control_final);
  evaluation.displacement_y_voxels = evaluation.fitness * settings.grid_y;
  evaluation.displacement_xy_voxels = std::abs(evaluation.displacement_y_voxels);
  evaluation.turns = 0.0;
  evaluation.airborne_fraction = 0.0;
  evaluation.velocity_body_lengths_per_s.assign(static_cast<size_t>(settings.lifetime / 0.5), 0.1);
  std::memcpy(&evaluation.state_hash, &evaluation.fitness, sizeof evaluation.state_hash);
  return evaluation;
}

/// What all of them have done.
struct Work
{
  std::atomic<int64_t> busy_ns{ 0 };
  std::atomic<int64_t> evaluations{ 0 };
  std::atomic<int64_t> batches{ 0 };
};

class FakeSimulator
{
public:
  FakeSimulator(const std::string& name, uint64_t fingerprint, Seconds batch_time, Work& work)
    : batch_time_(batch_time), work_(work), node_(name), thread_(1, &requests_)
  {
    node_.setCallbackQueue(&requests_);
    service_ = advertiseCheckedService<EvaluateGenomes>(
        node_, "evaluate",
        [this](const auto& request, const auto& /*caller*/, auto& response)
        { return answer(readMessage<EvaluateGenomes::Request>(request), response); });
    announcement_.name = ros::names::resolve(name);
    announcement_.service = service_.getService();
    announcement_.host = "fake";
    announcement_.engines.resize(1);
    announcement_.engines[0].body = "soft";
    announcement_.engines[0].fingerprint = fingerprint;
    announcement_.instruction_set = "avx512";
    announcement_.lanes = LANES;
    announcement_.period = ANNOUNCEMENT_PERIOD;
    thread_.start();
  }

  const SimulatorAnnouncement& announcement() const { return announcement_; }

private:
  bool answer(const EvaluateGenomes::Request& request, EvaluateGenomes::Response& response)
  {
    const Clock::time_point begin = Clock::now();
    const SoftBodySettings settings = fromMsg(request.settings).soft;
    const std::shared_ptr<const Body> body = makeSoftBody(settings);
    for (const EvaluationRequest& robot : robotsOf(request, *body))
    {
      response.evaluations.push_back(toMsg(inventedEvaluation(robot.program, settings), robot.trial, robot.id, *body));
    }
    if (!request.genomes.empty())
    {
      std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(batch_time_));
      work_.busy_ns += static_cast<int64_t>(1e9 * batch_time_.count());
      work_.evaluations += static_cast<int64_t>(request.genomes.size());
      ++work_.batches;
    }
    return true;
  }

  const Seconds batch_time_;
  Work& work_;
  SimulatorAnnouncement announcement_;
  ros::NodeHandle node_;
  ros::CallbackQueue requests_;
  ros::ServiceServer service_;
  ros::AsyncSpinner thread_;
};

/// Announces all of them, and says once a second what they have done.
void run(const std::vector<std::unique_ptr<FakeSimulator>>& simulators, Work& work)
{
  ros::NodeHandle node;
  const ros::Publisher announcements = node.advertise<SimulatorAnnouncement>("simulators", 10000);
  Clock::time_point last = Clock::now();
  while (ros::ok())
  {
    for (const auto& simulator : simulators)
    {
      announcements.publish(simulator->announcement());
    }
    ros::WallDuration(ANNOUNCEMENT_PERIOD).sleep();
    const Seconds elapsed = Clock::now() - last;
    if (elapsed.count() >= 1.0)
    {
      last = Clock::now();
      const double capacity_ns = 1e9 * elapsed.count() * static_cast<double>(simulators.size());
      const int64_t batches = std::max<int64_t>(1, work.batches.exchange(0));
      const auto evaluations = static_cast<double>(work.evaluations.exchange(0));
      std::cout << "busy " << toText(static_cast<double>(work.busy_ns.exchange(0)) / capacity_ns) << " evaluations/s "
                << toText(evaluations / elapsed.count()) << " robots per batch "
                << toText(evaluations / static_cast<double>(batches)) << std::endl;
    }
  }
}
}  // namespace
}  // namespace devo_evo

int main(int argc, char** argv)
{
  using namespace devo_evo;
  ros::init(argc, argv, "fake_simulators", ros::init_options::AnonymousName);
  if (argc != 3)
  {
    std::cerr << "usage: fake_simulators COUNT BATCH_MILLISECONDS\n";
    return 2;
  }
  return runNode(
      [&]
      {
        ros::start();
        const std::chrono::milliseconds batch_time(std::stoi(argv[2]));
        const uint64_t fingerprint = engineFingerprint();
        Work work;
        std::vector<std::unique_ptr<FakeSimulator>> simulators;
        for (int i = 0; i < std::stoi(argv[1]); ++i)
        {
          simulators.push_back(std::make_unique<FakeSimulator>("fake_" + toText(i), fingerprint, batch_time, work));
        }
        ros::AsyncSpinner callbacks(1);
        callbacks.start();
        run(simulators, work);
        return 0;
      });
}
