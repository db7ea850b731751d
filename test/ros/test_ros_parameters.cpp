#include "ros/parameters.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <functional>

#include <unistd.h>

namespace devo_evo
{
namespace
{
using XmlRpc::XmlRpcValue;

XmlRpcValue entry(const std::string& name, const XmlRpcValue& value)
{
  XmlRpcValue group;
  group[name] = value;
  return group;
}

std::string complaint(const XmlRpcValue& group)
{
  try
  {
    parametersFrom(group, "parameters of /evolver");
  }
  catch (const InvalidInput& e)
  {
    return e.what();
  }
  return "";
}

class YamlFile
{
public:
  explicit YamlFile(const std::string& text) : path("/tmp/devo_evo_" + std::to_string(getpid()) + ".yaml")
  {
    std::ofstream(path) << text;
  }
  ~YamlFile() { std::remove(path.c_str()); }

  const std::string path;
};

TEST(RosParameters, TypedValuesAreTaken)
{
  XmlRpcValue group;
  group["trials"] = 3;
  group["lifetime"] = 2.5;
  group["gravity"] = 1;  // a whole number will do for a real one
  group["treatment"] = "evo";
  group["self_collision"] = false;
  group["grid"][0] = 2;
  group["grid"][1] = 3;
  group["grid"][2] = 4;
  const ExperimentSettings settings = parametersFrom(group, "").experiment;
  EXPECT_EQ(settings.trials, 3);
  EXPECT_EQ(settings.body.soft.lifetime, 2.5);
  EXPECT_EQ(settings.body.soft.gravity, 1.0);
  EXPECT_EQ(settings.evolution.treatment, Treatment::EVO);
  EXPECT_FALSE(settings.body.soft.self_collision);
  EXPECT_EQ(settings.body.soft.grid_z, 4);
}

TEST(RosParameters, TextIsTakenForEveryType)
{
  XmlRpcValue group;
  group["seed"] = "9223372036854775807";  // more than the parameter server's integers can hold
  group["lifetime"] = "2.5";
  group["mutation_rate"] = "0.125";
  group["grid"] = "2x3x4";
  const ExperimentSettings settings = parametersFrom(group, "").experiment;
  EXPECT_EQ(settings.evolution.seed, INT64_MAX);
  EXPECT_EQ(settings.body.soft.lifetime, 2.5);
  EXPECT_EQ(settings.evolution.mutation_rate, 0.125);
  EXPECT_EQ(settings.body.soft.grid_y, 3);
}

TEST(RosParameters, ArgumentsGoBeforeTheFileAndTheFileBeforeTheDefaults)
{
  const YamlFile yaml("trials: 7\nseed: 9000000000000000000\n");
  XmlRpcValue group;
  group["config"] = yaml.path;
  group["trials"] = "8";
  const ExperimentSettings settings = parametersFrom(group, "").experiment;
  EXPECT_EQ(settings.trials, 8);
  EXPECT_EQ(settings.evolution.seed, 9000000000000000000);
  EXPECT_EQ(settings.evolution.population, 30);
}

TEST(RosParameters, WhatIsWrongIsNamedWithKeyValueAndWhatIsAllowed)
{
  EXPECT_EQ(complaint(entry("sed", 1)), "parameters of /evolver: there is no parameter \"sed\"; the closest is seed");
  EXPECT_EQ(complaint(entry("lifetime", "long")),
            "parameters of /evolver: lifetime is \"long\"; it must be a number within 0.001 to 1000 s");
  EXPECT_EQ(complaint(entry("population", 1)),
            "parameters of /evolver: population is 1; it must be a whole number within 2 to 10000");
  EXPECT_EQ(complaint(entry("trials", 1.5)),
            "parameters of /evolver: trials is 1.5; it must be a whole number within 1 to 10000");
  EXPECT_EQ(complaint(entry("lifetime", "0,5")),
            "parameters of /evolver: lifetime is \"0,5\"; it must be a number within 0.001 to 1000 s");
}

TEST(RosParameters, GroupsAndMixedListsAreRefused)
{
  EXPECT_EQ(
      complaint(entry("lifetime", entry("a", 1))),
      "parameters of /evolver: lifetime is a group of parameters or binary data; it must be a number within 0.001 "
      "to 1000");
  XmlRpcValue list;
  list[0] = 4;
  list[1] = "x";
  EXPECT_EQ(complaint(entry("grid", list)).find("parameters of /evolver: grid is a list of something else than"), 0u);
}

TEST(RosParameters, AnErrorInTheFileIsNamedWithItsLine)
{
  const YamlFile yaml("trials: 7\npopulation: many\n");
  EXPECT_EQ(complaint(entry("config", yaml.path)),
            yaml.path + ":2: population is \"many\"; it must be a whole number within 2 to 10000");
  EXPECT_EQ(complaint(entry("config", "experiment.yaml")),
            "parameters of /evolver: config is \"experiment.yaml\"; it must be the absolute path of a YAML file");
}
}  // namespace
}  // namespace devo_evo
