#include "ros/node_main.h"

#include <gtest/gtest.h>
#include <ros/assert.h>

namespace devo_evo
{
namespace
{
TEST(NodeMain, AFailedAssertionOfRosDoesNotEndANode)
{
  const auto fail_twice = []
  {
    runNode(
        []
        {
          ROS_ISSUE_BREAK();
          ROS_ISSUE_BREAK();
          return 0;
        });
    std::_Exit(7);
  };
  EXPECT_EXIT(fail_twice(), testing::ExitedWithCode(7), "");
}

TEST(NodeMain, WhatABodyThrowsIsTheStatusOfItsProcess)
{
  EXPECT_EQ(runNode([]() -> int { throw std::runtime_error("a test's own error"); }), 1);
  EXPECT_EQ(runNode([] { return 3; }), 3);
}
}  // namespace
}  // namespace devo_evo
