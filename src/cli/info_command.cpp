#include "cli/commands.h"

#include "devo_evo/archive/archive.h"
#include "devo_evo/experiment/parameters.h"
#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/text.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <string>

namespace devo_evo
{
namespace
{
using Json = nlohmann::ordered_json;

struct InfoArguments
{
  std::string output;
  bool json = false;
};

int64_t sizeOf(const std::string& file)
{
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  return error ? 0 : static_cast<int64_t>(size);
}

Json parametersOf(const ExperimentSettings& settings)
{
  Parameters parameters;
  parameters.experiment = settings;
  Json json;
  for (const ParameterSpec& spec : parameterSpecs())
  {
    if (describesExperiment(spec, settings.body.kind))
    {
      json[spec.name] = spec.get(parameters);
    }
  }
  const auto& founders = settings.evolution.founders;
  json["founders"] = founders ? toText(static_cast<int64_t>(founders->size())) + " given" : "random";
  return json;
}

Json evaluatorsOf(const Start& start)
{
  Json evaluators = Json::array();
  for (const Evaluator& evaluator : start.evaluators)
  {
    evaluators.push_back({ { "host", evaluator.host },
                           { "processor", evaluator.processor },
                           { "instruction_set", evaluator.instruction_set },
                           { "version", evaluator.version },
                           { "evaluations", evaluator.evaluations } });
  }
  return evaluators;
}

Json startsOf(const Archive& archive)
{
  Json starts = Json::array();
  for (const Start& start : archive.starts())
  {
    const Provenance& provenance = start.provenance;
    const bool stopped = start.stop_utc.has_value();
    const uint64_t fingerprint = provenance.engine_fingerprint;
    starts.push_back({ { "number", start.number },
                       { "start_utc", start.time_utc },
                       { "stop_utc", stopped ? Json(*start.stop_utc) : Json() },
                       { "generations_at_stop", stopped ? Json(start.generations_at_stop) : Json() },
                       { "version", provenance.version },
                       { "compiler", provenance.compiler },
                       { "processor", provenance.processor },
                       { "instruction_set", provenance.instruction_set },
                       { "host", provenance.host },
                       { "ros", provenance.ros },
                       { "engine_fingerprint", fingerprint == 0 ? Json() : Json(hashToString(fingerprint)) },
                       { "evaluators", evaluatorsOf(start) } });
  }
  return starts;
}

Json processorsOf(const Json& starts)
{
  std::set<std::string> processors;
  for (const Json& start : starts)
  {
    processors.insert(start.at("processor").get<std::string>());
    for (const Json& evaluator : start.at("evaluators"))
    {
      processors.insert(evaluator.at("processor").get<std::string>());
    }
  }
  processors.erase("");
  return processors;
}

Json trialsOf(const Archive& archive)
{
  const std::shared_ptr<const Body> body = makeBody(archive.settings().body);
  Json trials = Json::array();
  for (const int64_t trial : archive.trials())
  {
    const TrialExtent extent = archive.extentOf(trial);
    const ArchivedIndividual champion = archive.readIndividual(trial, archive.championOf(trial));
    const Individual& individual = champion.individual;
    const Evaluation& evaluation = individual.evaluation.value();
    trials.push_back({ { "trial", trial },
                       { "last_generation", extent.last_generation },
                       { "individuals", extent.individuals },
                       { "champion", individualName(trial, individual.id) },
                       { "born", individual.generation },
                       { "fitness", evaluation.fitness },
                       { "fitness_text", body->fitnessText(evaluation.fitness) + " " + body->fitnessUnit() },
                       { "turns", evaluation.turns },
                       { "morphology_window", champion.morphology_window },
                       { "control_window", champion.control_window } });
  }
  return trials;
}

Json describe(const InfoArguments& arguments)
{
  const auto archive = openArchiveForReading(arguments.output);
  const std::string path = archivePath(archive->settings().output);
  Json info;
  info["archive"] = path;
  info["parameters"] = parametersOf(archive->settings());
  info["starts"] = startsOf(*archive);
  info["processors"] = processorsOf(info["starts"]);
  info["trials"] = trialsOf(*archive);
  info["bytes"] = { { "archive", sizeOf(path) }, { "log", sizeOf(path + "-wal") } };
  info["digest"] = archive->digest();
  return info;
}

std::string textOf(const Json& value, int decimals)
{
  return value.is_number() ? fixedText(value.get<double>(), decimals) : "-";
}

std::string evaluatorAsText(const Json& evaluator)
{
  const auto text = [&evaluator](const char* field) { return evaluator.at(field).get<std::string>(); };
  const std::string processor = text("processor").empty() ? "unknown processor" : text("processor");
  return "        simulators on host " + text("host") + ": " + toText(evaluator.at("evaluations").get<int64_t>()) +
         " robots; " + processor + ", " + text("instruction_set") + ", devo_evo " + text("version") + "\n";
}

std::string startAsText(const Json& start)
{
  const auto text = [&start](const char* field) { return start.at(field).get<std::string>(); };
  const std::string end = start.at("stop_utc").is_null() ? " (no stop noted: it still runs, or was killed)"
                                                         : " to " + text("stop_utc") + ", when " +
                                                               toText(start.at("generations_at_stop").get<int64_t>()) +
                                                               " generations were finished";
  const std::string ros = text("ros").empty() ? "no ROS" : text("ros");
  std::string lines = "    " + toText(start.at("number").get<int64_t>()) + ": " + text("start_utc") + end + "\n" +
                      "        devo_evo " + text("version") + ", " + ros + "; " + text("compiler") + "\n        " +
                      text("processor") + ", " + text("instruction_set") + ", host " + text("host") + "\n";
  for (const Json& evaluator : start.at("evaluators"))
  {
    lines += evaluatorAsText(evaluator);
  }
  return lines;
}

std::string trialAsText(const Json& trial, const std::string& generations)
{
  return "    " + toText(trial.at("trial").get<int64_t>()) + ": generation " +
         toText(trial.at("last_generation").get<int64_t>()) + "/" + generations + ", " +
         toText(trial.at("individuals").get<int64_t>()) + " individuals; champion " +
         trial.at("champion").get<std::string>() + ": " + trial.at("fitness_text").get<std::string>() + ", " +
         textOf(trial.at("turns"), 2) + " turns, W_L " + textOf(trial.at("morphology_window"), 3) + ", W_Phi " +
         textOf(trial.at("control_window"), 3) + "\n";
}

std::string asText(const Json& info)
{
  std::string text = "Archive: " + info.at("archive").get<std::string>() + ", " +
                     toText(info.at("bytes").at("archive").get<int64_t>()) + " bytes, and " +
                     toText(info.at("bytes").at("log").get<int64_t>()) + " in its log\nParameters:\n";
  for (const auto& [name, value] : info.at("parameters").items())
  {
    text += "    " + name + ": " + value.get<std::string>() + "\n";
  }
  text += "Starts and stops:\n";
  for (const Json& start : info.at("starts"))
  {
    text += startAsText(start);
  }
  text += "Trials:\n";
  for (const Json& trial : info.at("trials"))
  {
    text += trialAsText(trial, info.at("parameters").at("generations").get<std::string>());
  }
  return text + "Digest: " + info.at("digest").get<std::string>() + "\n";
}
}  // namespace

void addInfoCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand(
      "info", "Say what an experiment is, who made it, how far it is, and how good its robots are.");
  const auto arguments = std::make_shared<InfoArguments>();
  app->add_option("OUTPUT", arguments->output, "the folder that the experiment wrote to")->required();
  app->add_flag("--json", arguments->json, "print a JSON object");
  app->callback(
      [=, &command]
      {
        command = [=]
        {
          const Json info = describe(*arguments);
          std::cout << (arguments->json ? info.dump(2) + "\n" : asText(info));
          return EXIT_OK;
        };
      });
}
}  // namespace devo_evo
