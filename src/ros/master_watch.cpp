#include "ros/master_watch.h"

#include "ros/master_calls.h"

#include <ros/connection_manager.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/publication.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>
#include <ros/xmlrpc_manager.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace devo_evo
{
namespace
{
using XmlRpc::XmlRpcValue;

constexpr std::chrono::seconds PERIOD{ 2 };
constexpr std::chrono::seconds CLOSE_TIMEOUT{ 2 };
constexpr int LOOKS_PER_CHECK = 2;  // so that those who are gone are looked for every four seconds,
constexpr int PATIENCE = 5;         // and are taken off after twenty

enum class Acquaintance
{
  KNOWN,
  UNKNOWN,
  NO_MASTER
};

std::string ownUri()
{
  return ros::XMLRPCManager::instance()->getServerURI();
}

/// @param service of this node, if it has one: a node that was taken off the master's books may keep its name there.
Acquaintance askMaster(const std::string& service)
{
  XmlRpcValue response;
  XmlRpcValue uri;
  if (callMaster("lookupNode", { ros::this_node::getName() }, uri, "", response) &&
      (service.empty() || callMaster("lookupService", { service }, uri, "", response)))
  {
    return Acquaintance::KNOWN;
  }
  return response.getType() == XmlRpcValue::TypeArray ? Acquaintance::UNKNOWN : Acquaintance::NO_MASTER;
}

bool registerPublication(const std::string& topic)
{
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
  XmlRpcValue subscribers;  // they connect by themselves
  return !publication || callMaster("registerPublisher", { topic, publication->getDataType(), ownUri() }, subscribers);
}

/// Hands the publishers that have registered before us to roscpp, by the call with which the master tells of later
/// ones.
void connectTo(const std::string& topic, const XmlRpcValue& publishers)
{
  std::string host;
  uint32_t port = 0;
  if (!ros::network::splitURI(ownUri(), host, port))
  {
    return;
  }
  XmlRpcValue request;
  request[0] = "/master";
  request[1] = topic;
  request[2] = publishers;
  XmlRpcValue response;
  XmlRpc::XmlRpcClient* const client =
      ros::XMLRPCManager::instance()->getXMLRPCClient(host, static_cast<int>(port), "/");
  client->execute("publisherUpdate", request, response);
  ros::XMLRPCManager::instance()->releaseXMLRPCClient(client);
}

bool registerSubscription(const std::string& topic)
{
  XmlRpcValue publishers;
  if (!callMaster("registerSubscriber", { topic, "*", ownUri() }, publishers))
  {
    return false;
  }
  if (publishers.getType() == XmlRpcValue::TypeArray && publishers.size() > 0)
  {
    connectTo(topic, publishers);
  }
  return true;
}

bool registerService(const std::string& service, const std::string& address)
{
  XmlRpcValue answer;
  return callMaster("registerService", { service, address, ownUri() }, answer);
}

/// Of this node's services.
std::string serviceAddress()
{
  return "rosrpc://" + ros::network::getHost() + ":" + std::to_string(ros::ConnectionManager::instance()->getTCPPort());
}
}  // namespace

class MasterWatch::State
{
public:
  State(std::vector<std::string> services, std::shared_ptr<SignsOfLife> signs_of_life, const std::string& topic)
    : services_(std::move(services)), signs_of_life_(std::move(signs_of_life)), departed_(topic, PATIENCE)
  {
  }

  void run()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!changed_.wait_for(lock, PERIOD, [this] { return closing_; }))
    {
      lock.unlock();
      look();
      if (signs_of_life_ && !missing_ && ++looks_ % LOOKS_PER_CHECK == 0)
      {
        departed_.check(signs_of_life_->living());
      }
      lock.lock();
    }
    ended_ = true;
    changed_.notify_all();
  }

  bool close()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    closing_ = true;
    changed_.notify_all();
    return changed_.wait_for(lock, CLOSE_TIMEOUT, [this] { return ended_; });
  }

private:
  void look()
  {
    const Acquaintance acquaintance = askMaster(services_.empty() ? "" : services_.front());
    if (acquaintance == Acquaintance::NO_MASTER && !missing_)
    {
      missing_ = true;
      ROS_WARN_STREAM("the ROS master at " << ros::master::getURI()
                                           << " does not answer. What is connected goes on; what starts now joins when "
                                              "it is back. If it has ended, start it again: roscore -p "
                                           << ros::master::getPort());
    }
    else if (acquaintance == Acquaintance::UNKNOWN && !ros::isShuttingDown() && registerAll())
    {
      missing_ = false;
      ROS_WARN_STREAM("the ROS master at " << ros::master::getURI()
                                           << " did not know this node: it was started anew, or this host was out of "
                                              "reach for long; registered with it again");
    }
    else if (acquaintance == Acquaintance::KNOWN && missing_)
    {
      missing_ = false;
      ROS_INFO_STREAM("the ROS master at " << ros::master::getURI() << " answers again");
    }
  }

  /// @return false if the master went away meanwhile: once more, then.
  bool registerAll() const
  {
    std::vector<std::string> publications;
    std::vector<std::string> subscriptions;
    ros::this_node::getAdvertisedTopics(publications);
    ros::this_node::getSubscribedTopics(subscriptions);
    bool registered = true;
    for (const std::string& service : services_)
    {
      registered = registered && registerService(service, address_);
    }
    for (const std::string& topic : publications)
    {
      registered = registered && registerPublication(topic);
    }
    for (const std::string& topic : subscriptions)
    {
      registered = registered && registerSubscription(topic);
    }
    return registered;
  }

  const std::vector<std::string> services_;
  const std::string address_ = serviceAddress();  // roscpp has none any more once it shuts down
  const std::shared_ptr<SignsOfLife> signs_of_life_;
  DepartedNodes departed_;  // this, and what else has no lock, is of the thread alone
  int looks_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool closing_ = false;
  bool ended_ = false;
  bool missing_ = false;
};

MasterWatch::MasterWatch(std::vector<std::string> services, std::shared_ptr<SignsOfLife> signs_of_life,
                         const std::string& topic)
  : state_(std::make_shared<State>(std::move(services), std::move(signs_of_life), topic))
{
  std::thread([state = state_] { state->run(); }).detach();
}

MasterWatch::~MasterWatch()
{
  close();
}

bool MasterWatch::close()
{
  return state_->close();
}
}  // namespace devo_evo
