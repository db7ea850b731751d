#include "ros/subscribers.h"

#include <ros/master.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <algorithm>
#include <map>
#include <string>
#include <thread>

namespace devo_evo
{
namespace
{
constexpr std::chrono::milliseconds PERIOD{ 20 };

/// How many nodes have subscribed to each topic; nothing if the master does not answer.
std::map<std::string, int> subscriberCounts()
{
  XmlRpc::XmlRpcValue request, response, state;
  request[0] = ros::this_node::getName();
  std::map<std::string, int> counts;
  if (!ros::master::execute("getSystemState", request, response, state, false))
  {
    return counts;
  }
  XmlRpc::XmlRpcValue& subscribers = state[1];
  for (int i = 0; i < subscribers.size(); ++i)
  {
    counts[static_cast<std::string>(subscribers[i][0])] = subscribers[i][1].size();
  }
  return counts;
}
}  // namespace

bool awaitSubscribers(const std::vector<ros::Publisher>& publishers, std::chrono::duration<double> longest,
                      const std::string& wanted, const std::function<bool()>& given_up)
{
  const auto end = std::chrono::steady_clock::now() + longest;
  for (;;)
  {
    const std::map<std::string, int> counts = subscriberCounts();
    const auto connected = [&](const ros::Publisher& publisher)
    {
      const auto count = counts.find(publisher.getTopic());
      return count == counts.end() || static_cast<int>(publisher.getNumSubscribers()) >= count->second;
    };
    if ((wanted.empty() || counts.count(wanted) == 1) && std::all_of(publishers.begin(), publishers.end(), connected))
    {
      return true;
    }
    if (std::chrono::steady_clock::now() > end || (given_up && given_up()))
    {
      return false;
    }
    std::this_thread::sleep_for(PERIOD);
  }
}
}  // namespace devo_evo
