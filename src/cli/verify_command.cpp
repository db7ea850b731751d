#include "cli/commands.h"

#include "cli/interruption.h"
#include "cli/parameter_options.h"
#include "cli/progress_display.h"
#include "devo_evo/experiment/report_text.h"
#include "devo_evo/farm/local_farm.h"
#include "devo_evo/soft_body/text.h"
#include "devo_evo/verification/verify.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

namespace devo_evo
{
namespace
{
struct VerifyArguments
{
  std::string output;
  VerificationScope scope;
  int64_t lineage = 0;  ///< trial; 0: none
  bool json = false;
};

std::string scopeText(const VerificationScope& scope)
{
  if (scope.all)
  {
    return "all individuals";
  }
  return scope.lineage_of ? "the lineage of the champion of trial " + toText(*scope.lineage_of)
                          : "a sample of " + toText(scope.sample) + " individuals and the champions";
}

/// Results of another engine differ everywhere, which says nothing about the archive.
std::optional<Offence> differenceOfEngines(const Archive& archive, InstructionSet instruction_set)
{
  const uint64_t ours = makeBody(archive.settings().body)->engineFingerprint(instruction_set);
  for (const Start& start : archive.starts())
  {
    const uint64_t theirs = start.provenance.engine_fingerprint;
    if (theirs != 0 && theirs != ours)
    {
      return Offence{ 0, 0, -1,
                      "start " + toText(start.number) + " was made by devo_evo " + start.provenance.version +
                          " with engine fingerprint " + hashToString(theirs) + "; this one has " + hashToString(ours) +
                          " and gives other results: verify with that version" };
    }
  }
  return std::nullopt;
}

/// Damage that keeps the archive from being read is a finding, too.
Verification verifyArchive(const VerifyArguments& arguments, const Parameters& parameters)
{
  Verification found;
  if (!std::filesystem::exists(archivePath(arguments.output)))
  {
    openArchiveForReading(arguments.output);  // says that there is none
  }
  try
  {
    const auto archive = openArchiveForReading(arguments.output);
    const InstructionSet instruction_set = parseInstructionSet(parameters.instruction_set);
    found.offence = differenceOfEngines(*archive, instruction_set);
    if (found.offence)
    {
      return found;
    }
    const auto farm = makeLocalFarm(makeBody(archive->settings().body), threadCount(parameters), instruction_set);
    ProgressDisplay display;
    const auto progress = [&](const Verification& so_far)
    {
      found = so_far;
      display.show("verified " + toText(so_far.individuals) + " births in " + toText(so_far.generations) +
                       " generations, " + toText(so_far.simulated) + " lives",
                   false);
      return interruption() == 0;
    };
    return verify(*archive, arguments.scope, *farm, progress);
  }
  catch (const ArchiveError& error)
  {
    found.offence = Offence{ 0, 0, -1, error.what() };
    return found;
  }
}

std::string asJson(const VerifyArguments& arguments, const Verification& found, double seconds)
{
  nlohmann::ordered_json json;
  json["archive"] = archivePath(arguments.output);
  json["sound"] = !found.offence && found.complete;
  json["complete"] = found.complete;
  json["scope"] = scopeText(arguments.scope);
  json["checked"] = { { "trials", found.trials },
                      { "generations", found.generations },
                      { "individuals", found.individuals },
                      { "stored_genomes", found.genomes },
                      { "simulated", found.simulated } };
  json["seconds"] = seconds;
  json["offence"] = nullptr;
  if (found.offence)
  {
    json["offence"] = { { "place", found.offence->place() },
                        { "trial", found.offence->trial },
                        { "generation", found.offence->generation },
                        { "id", found.offence->id },
                        { "what", found.offence->what } };
  }
  return json.dump(2) + "\n";
}

std::string asText(const VerifyArguments& arguments, const Verification& found, double seconds)
{
  const std::string generations = toText(found.generations) +
                                  (found.generations == 1 ? " generation of " : " generations of ") +
                                  toText(found.trials) + (found.trials == 1 ? " trial" : " trials");
  std::string text = "Archive:   " + archivePath(arguments.output) + "\n" + "Births:    " + toText(found.individuals) +
                     " individuals in " + generations + ": parents, ages, and genomes by repeating every mutation; " +
                     toText(found.genomes) + " stored genomes\n" + "Selection: survivors, champions and medians of " +
                     generations + "\n" + "Lives:     " + toText(found.simulated) + " simulated again (" +
                     scopeText(arguments.scope) + "): fitness, measures and state hash, to the last bit\n" +
                     "Time:      " + fixedText(seconds, 1) + " s\n";
  if (found.offence)
  {
    return text + "NOT SOUND: " + found.offence->place() + ": " + found.offence->what + "\n";
  }
  return text + (found.complete ? "Sound:     the archive is what its parameters give\n" : "");
}

int verifyOutput(const VerifyArguments& arguments, const Parameters& parameters)
{
  noteInterruptions();
  const auto start = std::chrono::steady_clock::now();
  const Verification found = verifyArchive(arguments, parameters);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::cout << (arguments.json ? asJson(arguments, found, seconds) : asText(arguments, found, seconds));
  if (found.offence)
  {
    return EXIT_DIFFERENCE;
  }
  if (!found.complete)
  {
    std::cerr << "devo_evo: stopped by " << signalName(interruption()) << "; nothing wrong was found so far\n";
    return 128 + interruption();
  }
  return EXIT_OK;
}
}  // namespace

void addVerifyCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand(
      "verify", "Check an experiment: repeat every birth and selection, and lives, and compare to the last bit.");
  const auto arguments = std::make_shared<VerifyArguments>();
  app->add_option("OUTPUT", arguments->output, "the folder that the experiment wrote to")->required();
  CLI::Option* sample = app->add_option("--sample", arguments->scope.sample,
                                        "how many individuals to simulate again, besides the champions (100)")
                            ->type_name("N")
                            ->check(CLI::Range(int64_t{ 0 }, int64_t{ 1000000000 }));
  CLI::Option* all = app->add_flag("--all", arguments->scope.all, "simulate all individuals again")->excludes(sample);
  app->add_option("--lineage", arguments->lineage, "simulate the ancestors of the champion of this trial again")
      ->type_name("TRIAL")
      ->check(CLI::Range(int64_t{ 1 }, int64_t{ 1000000000 }))
      ->excludes(sample)
      ->excludes(all);
  app->add_flag("--json", arguments->json, "print a JSON object");
  const ParameterOptions options(*app, { "farm" });
  app->footer("Exit status: 0 it is sound, 3 it is not (the first offence is named), 1 it could not be checked.");
  app->callback(
      [=, &command]
      {
        if (arguments->lineage > 0)
        {
          arguments->scope.lineage_of = arguments->lineage;
        }
        command = [=] { return verifyOutput(*arguments, options.read()); };
      });
}
}  // namespace devo_evo
