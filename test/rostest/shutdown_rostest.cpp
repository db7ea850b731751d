// What goes on in a node in which ROS has shut down (shutdown.test): a program of its own, since that happens but once.

#include "ros/master_calls.h"
#include "ros/master_watch.h"

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <chrono>
#include <string>
#include <thread>

namespace devo_evo
{
namespace
{
using std::chrono::steady_clock;

constexpr std::chrono::seconds TWO_LOOKS{ 5 };  // of a watch that looks every two seconds

bool masterKnows(const std::string& service)
{
  XmlRpc::XmlRpcValue address;
  XmlRpc::XmlRpcValue response;
  const bool known = callMaster("lookupService", { service }, address, "", response);
  EXPECT_EQ(response.getType(), XmlRpc::XmlRpcValue::TypeArray) << "the master does not answer";
  return known;
}

bool succeed(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& /*response*/)
{
  return true;
}

TEST(Shutdown, AWatchOfTheMasterDoesNotRegisterANodeThatEnds)
{
  ros::NodeHandle node;
  const ros::ServiceServer server = node.advertiseService("service", succeed);
  const std::string service = server.getService();
  const MasterWatch watch({ service });
  ASSERT_TRUE(masterKnows(service));
  ros::shutdown();
  for (const auto end = steady_clock::now() + TWO_LOOKS; steady_clock::now() < end;)
  {
    ASSERT_FALSE(masterKnows(service));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}
}  // namespace
}  // namespace devo_evo

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "shutdown_rostest");
  return RUN_ALL_TESTS();
}
