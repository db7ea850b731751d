#include "ros/master_watch.h"

#include <ros/connection_manager.h>
#include <ros/console.h>
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

enum class Acquaintance
{
  KNOWN,
  UNKNOWN,
  NO_MASTER
};

XmlRpcValue listOf(const std::vector<std::string>& texts)
{
  XmlRpcValue list;
  list.setSize(0);
  for (size_t i = 0; i < texts.size(); ++i)
  {
    list[static_cast<int>(i)] = texts[i];
  }
  return list;
}

std::string ownUri()
{
  return ros::XMLRPCManager::instance()->getServerURI();
}

Acquaintance askMaster()
{
  XmlRpcValue response;
  XmlRpcValue uri;
  const std::string& name = ros::this_node::getName();
  if (ros::master::execute("lookupNode", listOf({ name, name }), response, uri, false))
  {
    return Acquaintance::KNOWN;
  }
  return response.getType() == XmlRpcValue::TypeArray ? Acquaintance::UNKNOWN : Acquaintance::NO_MASTER;
}

/// @return whether the master has taken it.
bool tellMaster(const std::string& method, const std::vector<std::string>& arguments, XmlRpcValue& answer)
{
  XmlRpcValue response;
  return ros::master::execute(method, listOf(arguments), response, answer, false);
}

bool registerPublication(const std::string& topic)
{
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
  XmlRpcValue subscribers;  // they connect by themselves
  return !publication ||
         tellMaster("registerPublisher", { ros::this_node::getName(), topic, publication->getDataType(), ownUri() },
                    subscribers);
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
  XmlRpcValue request = listOf({ "/master", topic });
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
  if (!tellMaster("registerSubscriber", { ros::this_node::getName(), topic, "*", ownUri() }, publishers))
  {
    return false;
  }
  if (publishers.getType() == XmlRpcValue::TypeArray && publishers.size() > 0)
  {
    connectTo(topic, publishers);
  }
  return true;
}

bool registerService(const std::string& service)
{
  const std::string address =
      "rosrpc://" + ros::network::getHost() + ":" + std::to_string(ros::ConnectionManager::instance()->getTCPPort());
  XmlRpcValue answer;
  return tellMaster("registerService", { ros::this_node::getName(), service, address, ownUri() }, answer);
}
}  // namespace

class MasterWatch::State
{
public:
  explicit State(std::vector<std::string> services) : services_(std::move(services)) {}

  void run()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!changed_.wait_for(lock, PERIOD, [this] { return closing_; }))
    {
      lock.unlock();
      look();
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
    const Acquaintance acquaintance = askMaster();
    if (acquaintance == Acquaintance::NO_MASTER && !missing_)
    {
      missing_ = true;
      ROS_WARN_STREAM("the ROS master at " << ros::master::getURI()
                                           << " does not answer. What is connected goes on; what starts now joins when "
                                              "it is back. If it has ended, start it again: roscore -p "
                                           << ros::master::getPort());
    }
    else if (acquaintance == Acquaintance::UNKNOWN && registerAll())
    {
      missing_ = false;
      ROS_WARN_STREAM("the ROS master at " << ros::master::getURI() << " was started anew; registered with it again");
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
      registered = registered && registerService(service);
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
  std::mutex mutex_;
  std::condition_variable changed_;
  bool closing_ = false;
  bool ended_ = false;
  bool missing_ = false;  // of the thread alone
};

MasterWatch::MasterWatch(std::vector<std::string> services) : state_(std::make_shared<State>(std::move(services)))
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
