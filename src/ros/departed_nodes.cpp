#include "ros/departed_nodes.h"

#include "ros/master_calls.h"

#include <ros/console.h>

#include <vector>

namespace devo_evo
{
namespace
{
using XmlRpc::XmlRpcValue;

/// What the node has registered, in one of the three lists of getSystemState: publishers, subscribers, services.
std::vector<std::string> registeredBy(const std::string& node, XmlRpcValue& list)
{
  std::vector<std::string> names;
  for (int i = 0; i < list.size(); ++i)
  {
    for (int k = 0; k < list[i][1].size(); ++k)
    {
      if (std::string(list[i][1][k]) == node)
      {
        names.push_back(list[i][0]);
      }
    }
  }
  return names;
}

std::vector<std::string> publishersOf(const std::string& topic, XmlRpcValue& publishers)
{
  std::vector<std::string> nodes;
  for (int i = 0; i < publishers.size(); ++i)
  {
    for (int k = 0; std::string(publishers[i][0]) == topic && k < publishers[i][1].size(); ++k)
    {
      nodes.push_back(publishers[i][1][k]);
    }
  }
  return nodes;
}

void strikeOff(const std::string& node, XmlRpcValue& state)
{
  XmlRpcValue uri;
  XmlRpcValue address;
  XmlRpcValue done;
  if (!callMaster("lookupNode", { node }, uri))
  {
    return;
  }
  for (const std::string& service : registeredBy(node, state[2]))
  {
    if (callMaster("lookupService", { service }, address))
    {
      callMaster("unregisterService", { service, std::string(address) }, done, node);
    }
  }
  for (const std::string& topic : registeredBy(node, state[1]))
  {
    callMaster("unregisterSubscriber", { topic, std::string(uri) }, done, node);
  }
  for (const std::string& topic : registeredBy(node, state[0]))
  {
    callMaster("unregisterPublisher", { topic, std::string(uri) }, done, node);
  }
}
}  // namespace

void SignsOfLife::note(const std::string& node, Clock::duration lasts)
{
  constexpr size_t most = 4096;
  std::lock_guard<std::mutex> lock(mutex_);
  listening_ = true;
  if (until_.size() < most || until_.count(node) > 0)
  {
    until_[node] = Clock::now() + lasts;
  }
}

void SignsOfLife::stopListening()
{
  std::lock_guard<std::mutex> lock(mutex_);
  listening_ = false;
  until_.clear();
}

std::optional<std::set<std::string>> SignsOfLife::living()
{
  std::lock_guard<std::mutex> lock(mutex_);
  if (!listening_)
  {
    return std::nullopt;
  }
  const Clock::time_point now = Clock::now();
  std::set<std::string> names;
  for (auto node = until_.begin(); node != until_.end();)
  {
    if (node->second > now)
    {
      names.insert(node->first);
      ++node;
    }
    else
    {
      node = until_.erase(node);
    }
  }
  return names;
}

void DepartedNodes::check(const std::optional<std::set<std::string>>& living)
{
  XmlRpcValue state;
  if (!living || !callMaster("getSystemState", {}, state))
  {
    silent_checks_.clear();
    return;
  }
  std::map<std::string, int> silent_checks;
  for (const std::string& node : publishersOf(topic_, state[0]))
  {
    if (living->count(node) > 0)
    {
      continue;
    }
    const int checks = silent_checks_[node] + 1;
    silent_checks[node] = checks;
    if (checks >= patience_)
    {
      ROS_INFO_STREAM("took " << node << " off the ROS master's books: nothing was heard of it for long");
      strikeOff(node, state);
    }
  }
  silent_checks_ = std::move(silent_checks);
}
}  // namespace devo_evo
