#include "cli/commands.h"

#include "devo_evo/soft_body/text.h"
#include "devo_evo/verification/compare.h"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <string>

namespace devo_evo
{
namespace
{
struct DiffArguments
{
  std::string a;
  std::string b;
  bool json = false;
};

using Json = nlohmann::ordered_json;

Json asJson(const std::vector<FieldDifference>& fields)
{
  Json json = Json::array();
  for (const FieldDifference& field : fields)
  {
    json.push_back({ { "field", field.field }, { "a", field.a }, { "b", field.b } });
  }
  return json;
}

std::string asJson(const ArchiveComparison& comparison)
{
  Json json;
  json["equal"] = comparison.equal();
  json["parameters"] = asJson(comparison.parameters);
  json["provenance"] = asJson(comparison.provenance);
  json["equal_generations"] = comparison.equal_generations;
  json["trials"] = Json::array();
  for (const TrialDifference& trial : comparison.trials)
  {
    json["trials"].push_back({ { "trial", trial.trial },
                               { "generation", trial.generation },
                               { "id", trial.id < 0 ? Json() : Json(trial.id) },
                               { "differences", asJson(trial.fields) } });
  }
  json["extents"] = Json::array();
  for (const ExtentDifference& extent : comparison.extents)
  {
    json["extents"].push_back({ { "trial", extent.trial },
                                { "generations_a", extent.generations_a },
                                { "generations_b", extent.generations_b } });
  }
  return json.dump(2) + "\n";
}

std::string asText(const std::string& title, const std::vector<FieldDifference>& fields)
{
  std::string text = fields.empty() ? "" : title + "\n";
  for (const FieldDifference& field : fields)
  {
    text += "    " + field.field + ": " + (field.a.empty() ? "\"\"" : field.a) + " in A, " +
            (field.b.empty() ? "\"\"" : field.b) + " in B\n";
  }
  return text;
}

std::string asText(const ArchiveComparison& comparison)
{
  std::string text = asText("Parameters differ:", comparison.parameters) +
                     asText("Provenance differs (which decides nothing):", comparison.provenance);
  for (const TrialDifference& trial : comparison.trials)
  {
    const std::string place = "Trial " + toText(trial.trial) + " parts in generation " + toText(trial.generation);
    text += asText(place + (trial.id < 0 ? ", in its selection:"
                                         : ", with individual " + individualName(trial.trial, trial.id) + ":"),
                   trial.fields);
  }
  for (const ExtentDifference& extent : comparison.extents)
  {
    text += "Trial " + toText(extent.trial) + " has " + toText(extent.generations_a) + " generations in A, " +
            toText(extent.generations_b) + " in B\n";
  }
  const std::string generations = toText(comparison.equal_generations) +
                                  (comparison.equal_generations == 1 ? " generation is" : " generations are");
  return text + generations + " the same in both" + (comparison.equal() ? "; they are equal" : "") + "\n";
}

int diff(const DiffArguments& arguments)
{
  const ArchiveComparison comparison =
      compareArchives(*openArchiveForReading(arguments.a), *openArchiveForReading(arguments.b));
  std::cout << (arguments.json ? asJson(comparison) : asText(comparison));
  return comparison.equal() ? EXIT_OK : EXIT_DIFFERENCE;
}
}  // namespace

void addDiffCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand("diff", "Say where two experiments part, and how.");
  const auto arguments = std::make_shared<DiffArguments>();
  app->add_option("A", arguments->a, "the folder that one experiment wrote to")->required();
  app->add_option("B", arguments->b, "the folder of the other")->required();
  app->add_flag("--json", arguments->json, "print a JSON object");
  app->footer("Exit status: 0 they are equal but for provenance, 3 they differ, 1 one cannot be read.");
  app->callback([=, &command] { command = [=] { return diff(*arguments); }; });
}
}  // namespace devo_evo
