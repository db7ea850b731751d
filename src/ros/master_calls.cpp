#include "ros/master_calls.h"

#include <ros/master.h>
#include <ros/this_node.h>

namespace devo_evo
{
using XmlRpc::XmlRpcValue;

bool callMaster(const std::string& method, const std::vector<std::string>& arguments, XmlRpcValue& answer,
                const std::string& caller, XmlRpcValue& response)
{
  XmlRpcValue request;
  request[0] = caller.empty() ? ros::this_node::getName() : caller;
  for (size_t i = 0; i < arguments.size(); ++i)
  {
    request[static_cast<int>(i + 1)] = arguments[i];
  }
  return ros::master::execute(method, request, response, answer, false);
}

bool callMaster(const std::string& method, const std::vector<std::string>& arguments, XmlRpcValue& answer,
                const std::string& caller)
{
  XmlRpcValue response;
  return callMaster(method, arguments, answer, caller, response);
}
}  // namespace devo_evo
