#include "cli/commands.h"

#include "devo_evo/explanation/explanation.h"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <set>
#include <string>

namespace devo_evo
{
namespace
{
struct ExplainArguments
{
  std::string name;
  bool json = false;
};

std::string asJson(const std::vector<Explanation>& found)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Explanation& each : found)
  {
    nlohmann::ordered_json facts;
    for (const auto& [label, text] : each.facts)
    {
      facts[label] = text;
    }
    json.push_back({ { "name", each.name }, { "place", each.place }, { "facts", facts } });
  }
  return json.dump(2) + "\n";
}

std::string asText(const std::vector<Explanation>& found)
{
  std::string text;
  for (const Explanation& each : found)
  {
    text += (text.empty() ? "" : "\n") + each.name + ", " + each.place + "\n";
    for (const auto& [label, fact] : each.facts)
    {
      text += "    " + label + ": " + fact + "\n";
    }
  }
  return text;
}

std::string allNames()
{
  std::set<std::string> names;
  for (const Explanation& each : explanations())
  {
    names.insert(each.name);
  }
  std::string text;
  for (const std::string& name : names)
  {
    text += name + "\n";
  }
  return text;
}
}  // namespace

void addExplainCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand(
      "explain", "Say what a measure, column, parameter or message field means, its unit and formula.");
  const auto arguments = std::make_shared<ExplainArguments>();
  app->add_option("NAME", arguments->name,
                  "like fitness, individuals.parent or lifetime; without it, all names are listed");
  app->add_flag("--json", arguments->json, "print JSON");
  app->callback(
      [=, &command]
      {
        command = [=]
        {
          const bool all = arguments->name.empty();
          const auto found = all ? explanations() : explain(arguments->name);
          std::cout << (arguments->json ? asJson(found) : all ? allNames() : asText(found));
          return EXIT_OK;
        };
      });
}
}  // namespace devo_evo
