#include "rviz_plugin/player_client.h"

#include "ros/checked_subscriber.h"

#include <ros/callback_queue.h>
#include <ros/names.h>
#include <ros/service.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>

#include <mutex>
#include <utility>

namespace devo_evo
{
namespace
{
constexpr std::chrono::seconds PATIENCE{ 5 };  // with a player that does not answer; it may look for a robot for 3 s

/// Takes what is given in `later` over into `request`.
void merge(Show::Request& request, const Show::Request& later)
{
  const bool another_robot = !(later.individual.empty() && later.output.empty() && later.genome_file.empty());
  if (another_robot)
  {
    request.individual = later.individual;
    request.output = later.output;
    request.genome_file = later.genome_file;
  }
  request.colour = later.colour.empty() ? request.colour : later.colour;
  request.speed = later.speed == 0.0 ? request.speed : later.speed;
}

/// Whether a panel has to look different after this state. Time and place in a life do not matter.
bool differs(const PlayerState& a, const PlayerState& b)
{
  return a.individual != b.individual || a.trial != b.trial || a.id != b.id || a.paused != b.paused ||
         a.speed != b.speed || a.colour != b.colour || a.record != b.record;
}
}  // namespace

/// What talks with the player. Made, used and destroyed in the background, except for giveUp().
class PlayerClient::Link
{
public:
  explicit Link(std::string player) : player_(std::move(player)) {}

  /// @param hear called in a thread of ours.
  void subscribe(const std::function<void(const PlayerState&)>& hear)
  {
    ros::NodeHandle node;
    node.setCallbackQueue(&queue_);
    subscriber_ = subscribeChecked<PlayerState>(node, player_ + "/state", 10, hear);
    spinner_.start();
  }

  void unsubscribe()
  {
    spinner_.stop();
    subscriber_.shutdown();
  }

  /// @return what went wrong; empty: nothing.
  template <class Service>
  std::string call(const std::string& name, const typename Service::Request& request)
  {
    const std::string service = player_ + "/" + name;
    if (!ros::service::exists(service, false))
    {
      return "no player offers " + service + "; start one: roslaunch devo_evo watch.launch";
    }
    ros::NodeHandle node;
    ros::ServiceClient client = node.serviceClient<Service>(service, true);  // only such a call can be ended
    {
      std::lock_guard<std::mutex> lock(mutex_);
      client_ = client;
    }
    ros::SerializedMessage received;
    if (!client.call(ros::serialization::serializeMessage(request), received, ros::service_traits::md5sum<Service>()))
    {
      return "the player did not answer on " + service;
    }
    try
    {
      const auto answer = readMessage<typename Service::Response>(received);
      return answer.success ? "" : answer.message.empty() ? "the player refuses, and does not say why" : answer.message;
    }
    catch (const InvalidInput& error)
    {
      return "the answer on " + service + " makes no sense: " + error.what();
    }
  }

  /// Ends the call under way; from any thread.
  void giveUp()
  {
    std::lock_guard<std::mutex> lock(mutex_);
    client_.shutdown();
  }

private:
  const std::string player_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{ 1, &queue_ };
  ros::Subscriber subscriber_;
  std::mutex mutex_;
  ros::ServiceClient client_;  ///< guarded by mutex_
};

PlayerClient::PlayerClient(const std::string& player, Callbacks callbacks)
  : callbacks_(std::move(callbacks)), link_(std::make_shared<Link>(player))
{
  patience_.setSingleShot(true);
  QObject::connect(&patience_, &QTimer::timeout, [this] { giveUp(); });
  const auto post = jobs_.poster();
  jobs_.run(
      [this, link = link_, post]
      {
        link->subscribe([this, post](const PlayerState& state) { post([this, state] { hear(state); }); });
        return nullptr;
      });
}

PlayerClient::~PlayerClient()
{
  link_->giveUp();
  jobs_.run(
      [link = link_]
      {
        link->unsubscribe();
        return nullptr;
      });
}

void PlayerClient::show(const Show::Request& request)
{
  if (!waiting_.show)
  {
    waiting_.show = Show::Request();
  }
  merge(*waiting_.show, request);
  passOn();
}

void PlayerClient::setPaused(bool paused)
{
  waiting_.paused = paused;
  passOn();
}

void PlayerClient::passOn()
{
  if (under_way_ || !(waiting_.show || waiting_.paused))
  {
    return;
  }
  under_way_ = true;
  patience_.start(PATIENCE);
  const auto call = [this, link = link_, orders = std::exchange(waiting_, Orders())]() -> BackgroundJobs::Outcome
  {
    std::string error = orders.show ? link->call<Show>("show", *orders.show) : "";
    if (error.empty() && orders.paused)
    {
      error = link->call<std_srvs::Trigger>(*orders.paused ? "pause" : "resume", {});
    }
    return [this, error] { answered(error); };
  };
  jobs_.run(call);
}

void PlayerClient::answered(const std::string& error)
{
  patience_.stop();
  under_way_ = false;
  passOn();
  callbacks_.answers(error);
}

void PlayerClient::giveUp()
{
  callbacks_.answers("the player has not answered for " + std::to_string(PATIENCE.count()) + " s");
  link_->giveUp();
}

void PlayerClient::hear(const PlayerState& state)
{
  const bool news = !last_ || differs(*last_, state);
  last_ = state;
  if (news)
  {
    callbacks_.shows(state);
  }
}
}  // namespace devo_evo
