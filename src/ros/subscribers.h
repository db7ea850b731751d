#pragma once

#include <ros/publisher.h>

#include <chrono>
#include <functional>
#include <vector>

namespace devo_evo
{
/// Waits until all nodes that have subscribed to some topics, as the master knows, are connected to our publishers of
/// them: what is published before would not reach them. A subscriber that died without a word stays known to the
/// master, so there is a limit.
/// @param wanted a topic that somebody must have subscribed to, or empty.
/// @param given_up if given, ends the wait once it is true.
/// @return whether they are connected.
bool awaitSubscribers(const std::vector<ros::Publisher>& publishers, std::chrono::duration<double> longest,
                      const std::string& wanted = "", const std::function<bool()>& given_up = {});
}  // namespace devo_evo
