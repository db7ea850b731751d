#include "cli/commands.h"

#include "cli/individual_name.h"
#include "cli/result_stream.h"
#include "devo_evo/experiment/json_lines.h"
#include "devo_evo/experiment/parameters.h"
#include "devo_evo/interchange/phylogeny.h"
#include "devo_evo/interchange/traces.h"
#include "devo_evo/interchange/vxa.h"
#include "devo_evo/soft_body/text.h"

#include <memory>
#include <string>

namespace devo_evo
{
namespace
{
struct ExportArguments
{
  std::string output;
  std::string individual;
  std::string lineage;
  int64_t phylogeny = 0;
  std::string format;
  std::string out = "-";
  std::string parameters;
  double interval = 0.1;
};

Individual withGenome(const ArchivedIndividual& archived)
{
  const Individual& individual = archived.individual;
  if (!archived.has_genome)
  {
    throw ArchiveError("the genome of " + individualName(individual.trial, individual.id) +
                       " is not known: it is not stored, and repeating its birth gives another one; export it with the "
                       "devo_evo that made it, and see \"devo_evo verify\"");
  }
  return individual;
}

std::string jsonOf(const ArchivedIndividual& archived, const Body& body)
{
  const Individual individual = withGenome(archived);
  return robotToJson(individualName(individual.trial, individual.id), individual.genome, body);
}

/// The life that is written must be the one that the archive tells of.
void exportTrace(const ExportArguments& arguments, const Individual& individual, const SoftBodySettings& body,
                 TraceKind kind, const LineSink& sink)
{
  const Evaluation evaluation = writeTrace(body, individual.genome.program, kind, arguments.interval, sink);
  if (evaluation.state_hash != individual.evaluation.value().state_hash)
  {
    throw ArchiveError("the life of " + individualName(individual.trial, individual.id) +
                       " ends in another state than the archive says (" + hashToString(evaluation.state_hash) +
                       " instead of " + hashToString(individual.evaluation->state_hash) + "); see \"devo_evo verify\"");
  }
}

void exportIndividual(const ExportArguments& arguments, const Archive& archive, const LineSink& sink)
{
  const auto [trial, id] = readIndividualName(archive, arguments.individual);
  const ArchivedIndividual archived = archive.readIndividual(trial, id);
  const BodySettings settings = archive.settings().body;
  if (arguments.format == "vxa")
  {
    sink(toVxa({ individualName(trial, id), withGenome(archived).genome, softSettings(settings, "VXA files") }));
  }
  else if (arguments.format == "trace" || arguments.format == "voxels")
  {
    const TraceKind kind = arguments.format == "trace" ? TraceKind::CENTER_OF_MASS : TraceKind::VOXELS;
    exportTrace(arguments, withGenome(archived), softSettings(settings, "traces"), kind, sink);
  }
  else
  {
    sink(jsonOf(archived, *makeBody(settings)));
  }
}

void exportDescendants(const ExportArguments& arguments, const std::vector<Descendant>& descendants, const Body& body,
                       const LineSink& sink)
{
  if (arguments.format == "newick")
  {
    writeNewick(descendants, sink);
  }
  else if (arguments.format == "alife")
  {
    writeAlifeStandard(descendants, body, sink);
  }
  else if (arguments.format == "json")
  {
    for (const Descendant& descendant : descendants)
    {
      sink(jsonOf(descendant.archived, body));
    }
  }
  else
  {
    writeCsv(descendants, body, sink);
  }
}

/// What is exported, and the formats it has; the first is the default.
struct Subject
{
  const char* option;
  std::vector<std::string> formats;
};

const Subject& subjectOf(const ExportArguments& arguments)
{
  static const Subject individual = { "--individual", { "json", "vxa", "trace", "voxels" } };
  static const Subject lineage = { "--lineage", { "csv", "newick", "alife", "json" } };
  static const Subject phylogeny = { "--phylogeny", { "csv", "newick", "alife" } };
  static const Subject nothing = { "--parameters", { "" } };
  return !arguments.individual.empty() ? individual
         : !arguments.lineage.empty()  ? lineage
         : arguments.phylogeny > 0     ? phylogeny
                                       : nothing;
}

ExportArguments checked(ExportArguments arguments)
{
  const Subject& subject = subjectOf(arguments);
  if (subject.formats.front().empty() && arguments.parameters.empty())
  {
    throw InvalidInput("nothing is named to export; give --individual, --lineage, --phylogeny or --parameters");
  }
  std::string known;
  for (const std::string& format : subject.formats)
  {
    known += (known.empty() ? "" : ", ") + format;
    if (format == arguments.format)
    {
      return arguments;
    }
  }
  if (!arguments.format.empty())
  {
    throw InvalidInput("--format is \"" + arguments.format + "\"; with " + subject.option + " it must be one of " +
                       known);
  }
  arguments.format = subject.formats.front();
  return arguments;
}

void writeParameters(const std::string& path, const ExperimentSettings& settings)
{
  ResultStream file(path, { archivePath(settings.output) });
  file.writeLine("# Parameters of the experiment in " + settings.output + ", by devo_evo export.");
  const std::string yaml = parametersAsYaml(settings);
  file.writeLine(yaml.substr(0, yaml.size() - 1));
  file.close();
}

int exportFrom(const ExportArguments& given)
{
  const ExportArguments arguments = checked(given);
  const auto archive = openArchiveForReading(arguments.output);
  const ExperimentSettings settings = archive->settings();
  if (!arguments.parameters.empty())
  {
    writeParameters(arguments.parameters, settings);
  }
  if (arguments.format.empty())
  {
    return EXIT_OK;
  }
  ResultStream results(arguments.out, { archivePath(arguments.output), arguments.parameters });
  const LineSink sink = [&results](const std::string& line) { results.writeLine(line); };
  if (!arguments.individual.empty())
  {
    exportIndividual(arguments, *archive, sink);
  }
  else if (!arguments.lineage.empty())
  {
    const auto [trial, id] = readIndividualName(*archive, arguments.lineage);
    exportDescendants(arguments, readAncestry(*archive, trial, id), *makeBody(settings.body), sink);
  }
  else
  {
    exportDescendants(arguments, readPhylogeny(*archive, arguments.phylogeny), *makeBody(settings.body), sink);
  }
  results.close();
  return EXIT_OK;
}
}  // namespace

void addExportCommand(CLI::App& tool, Command& command)
{
  CLI::App* app = tool.add_subcommand(
      "export",
      "Take robots, lives, lineages and phylogenies out of an archive: JSON, VXA, CSV, Newick, ALife standard.");
  const auto arguments = std::make_shared<ExportArguments>();
  app->add_option("OUTPUT", arguments->output, "the folder that the experiment wrote to")->required();
  CLI::Option* individual =
      app->add_option("--individual", arguments->individual,
                      "one robot, TRIAL/ID, or TRIAL for its champion, as json, vxa, trace (CSV of the centre of mass) "
                      "or voxels (CSV of their states)")
          ->type_name("NAME");
  CLI::Option* lineage = app->add_option("--lineage", arguments->lineage,
                                         "a robot and its ancestors, named like that, as csv, newick, alife or json")
                             ->type_name("NAME")
                             ->excludes(individual);
  app->add_option("--phylogeny", arguments->phylogeny, "everybody of a trial, as csv, newick or alife")
      ->type_name("TRIAL")
      ->check(CLI::Range(int64_t{ 1 }, int64_t{ 1000000000 }))
      ->excludes(individual)
      ->excludes(lineage);
  app->add_option("--format", arguments->format, "one of those; the first if not given")->type_name("FORMAT");
  app->add_option("--out", arguments->out, "where it goes instead of standard output")->type_name("FILE");
  app->add_option("--interval", arguments->interval, "time between the lines of a trace [s] (0.1)")->type_name("S");
  app->add_option("--parameters", arguments->parameters,
                  "also write the experiment's parameters, for --config of other commands")
      ->type_name("FILE");
  app->footer(
      "Examples:\n"
      "  devo_evo export results/evo --individual 1 --format vxa --out champion.vxa\n"
      "  devo_evo export results/evo --phylogeny 1 --format alife --out phylogeny.csv\n"
      "docs/interchange.md describes the formats.");
  app->callback([=, &command] { command = [=] { return exportFrom(*arguments); }; });
}
}  // namespace devo_evo
