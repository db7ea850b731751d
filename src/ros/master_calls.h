#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>
#include <vector>

namespace devo_evo
{
/// Calls a method of the ROS master's, once. Takes minutes if the network loses packets, and cannot be interrupted.
/// @param arguments besides the first one, which is the name of the node that calls: `caller`, or this one.
/// @param answer what the master says. @return whether it has done what was asked.
bool callMaster(const std::string& method, const std::vector<std::string>& arguments, XmlRpc::XmlRpcValue& answer,
                const std::string& caller = "");

/// The same, for who must know whether the master has answered at all: `response` is a list if so.
bool callMaster(const std::string& method, const std::vector<std::string>& arguments, XmlRpc::XmlRpcValue& answer,
                const std::string& caller, XmlRpc::XmlRpcValue& response);
}  // namespace devo_evo
