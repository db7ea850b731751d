#include "cli/commands.h"

#include "cli/bag_film.h"
#include "cli/parameter_options.h"
#include "cli/picture_options.h"
#include "cli/robot_choices.h"
#include "devo_evo/picture/film_writer.h"
#include "devo_evo/picture/pictures.h"
#include "devo_evo/soft_body/text.h"

#include <memory>
#include <string>
#include <vector>

namespace devo_evo
{
namespace
{
struct RenderArguments
{
  std::string source;
  std::string individual;
  std::vector<std::string> beside;
  bool lineage = false, strip = false, gaits = false;
  int64_t count = 0;
  double time = 0.0;
  int poses = 9;
  std::optional<int> part;
};

void requireFilm(const std::string& path)
{
  if (!isFilmPath(path))
  {
    throw InvalidInput("--out is \"" + path +
                       "\"; a film ends in .mp4, .gif or .webp, or is a folder of PNG files: FOLDER/");
  }
}

bool isBag(const std::string& source)
{
  const std::string suffix = ".bag";
  return source.size() > suffix.size() && source.compare(source.size() - suffix.size(), suffix.size(), suffix) == 0;
}

void requirePicture(const std::string& path)
{
  if (path.size() < 5 || path.compare(path.size() - 4, 4, ".png") != 0)
  {
    throw InvalidInput("--out is \"" + path + "\"; a picture ends in .png");
  }
}

int writePicture(const Image& picture, const std::string& path)
{
  requirePicture(path);
  picture.writePng(path);
  return EXIT_OK;
}

std::unique_ptr<Archive> openExperiment(const std::string& source, const std::string& what)
{
  if (!isExperiment(source))
  {
    throw InvalidInput(source + ": " + what + " needs an experiment's output folder");
  }
  return openArchiveForReading(source);
}

int renderLineage(const RenderArguments& arguments, const std::string& path, const PictureFormat& format)
{
  requireFilm(path);
  const auto archive = openExperiment(arguments.source, "a lineage");
  const RobotChoice choice = parseRobotChoice(arguments.individual.empty() ? "best" : arguments.individual);
  const Lineage lineage = readLineage(*archive, choice.trial, choice.id);
  const std::vector<size_t> positions = evenlySpaced(lineage.individuals.size(), arguments.count);
  return makeFilm(path, [&](const FilmProgress& progress)
                  { filmLineage(*archive, lineage, positions, {}, 0.0, path, format, progress); });
}

int renderSideBySide(const RenderArguments& arguments, const std::string& path, const PictureFormat& format,
                     const Parameters& parameters)
{
  requireFilm(path);
  std::vector<std::string> sources = { arguments.source };
  sources.insert(sources.end(), arguments.beside.begin(), arguments.beside.end());
  constexpr size_t most = 4;
  if (sources.size() > most)
  {
    throw InvalidInput("--beside is given " + toText(static_cast<int64_t>(arguments.beside.size())) +
                       " times; at most " + toText(static_cast<int64_t>(most)) + " robots fit side by side");
  }
  std::vector<ShownRobot> robots;
  std::vector<std::string> titles;
  for (const std::string& source : sources)
  {
    robots.push_back(chooseRobot(source, isExperiment(source) ? arguments.individual : "", parameters));
    const std::optional<Descent>& descent = robots.back().descent;
    titles.push_back(descent ? treatmentTitle(descent->treatment) : robots.back().name);
  }
  return makeFilm(path, [&](const FilmProgress& progress) { filmSideBySide(robots, titles, path, format, progress); });
}

int render(const RenderArguments& arguments, const std::string& path, const PictureFormat& format,
           const Parameters& parameters)
{
  if (arguments.gaits)
  {
    requirePicture(path);
    return writePicture(gaitRows(*openExperiment(arguments.source, "--gaits"), format.width, format.colouring), path);
  }
  if (arguments.lineage)
  {
    return renderLineage(arguments, path, format);
  }
  if (isBag(arguments.source))
  {
    requireFilm(path);
    return makeFilm(path, [&](const FilmProgress& progress) { filmBag(arguments.source, path, format, progress); });
  }
  if (!arguments.beside.empty())
  {
    return renderSideBySide(arguments, path, format, parameters);
  }
  const ShownRobot robot = chooseRobot(arguments.source, arguments.individual, parameters);
  if (arguments.strip)
  {
    return writePicture(stripOfLife(robot, arguments.poses, arguments.part, format.width, format.colouring), path);
  }
  if (isFilmPath(path))
  {
    return makeFilm(path, [&](const FilmProgress& progress) { filmLife(robot, path, format, progress); });
  }
  requirePicture(path);
  return writePicture(pictureOfLife(robot, arguments.time, format), path);
}
}  // namespace

void addRenderCommand(CLI::App& tool, Command& command)
{
  CLI::App* app =
      tool.add_subcommand("render", "Draw robots as pictures and films, without a display (docs/pictures.md).");
  const auto arguments = std::make_shared<RenderArguments>();
  app->add_option("SOURCE", arguments->source,
                  "an experiment's output folder, a file of genomes (JSON lines), or a bag that shows robots")
      ->required();
  app->add_option("--individual", arguments->individual,
                  "best, a trial (its champion) or trial/id; of a file, the robot's id [best; the first one]")
      ->type_name("WHICH");
  CLI::Option* lineage =
      app->add_flag("--lineage", arguments->lineage, "a film of the individual's ancestors, founder first");
  app->add_option("--count", arguments->count, "of ancestors, evenly spaced; 0: all")->needs(lineage);
  CLI::Option* beside =
      app->add_option("--beside", arguments->beside, "another source, shown beside the first; may be repeated")
          ->type_name("SOURCE")
          ->allow_extra_args(false);
  CLI::Option* strip = app->add_flag("--strip", arguments->strip, "one life in one picture, as in the paper's Fig. 1");
  app->add_option("--poses", arguments->poses, "of a strip, at equal times")->needs(strip)->capture_default_str();
  app->add_option("--part,--voxel", arguments->part,
                  "voxel, or leg from 1, whose length a strip shows [the visible one that develops most]")
      ->needs(strip);
  CLI::Option* gaits =
      app->add_flag("--gaits", arguments->gaits, "four rows of ancestors of champions, as in the paper's Fig. 2");
  app->add_option("--time", arguments->time, "of a picture [s since birth]")->excludes(strip)->excludes(gaits);
  lineage->excludes(beside)->excludes(strip)->excludes(gaits);
  beside->excludes(strip)->excludes(gaits);
  strip->excludes(gaits);
  const PictureOptions picture(*app);
  const ParameterOptions options(*app, { "body", "physics", "rigid body" });
  app->footer(
      "Examples:\n"
      "  devo_evo render results/first --out best.mp4\n"
      "  devo_evo render results/first --individual 3/1042 --time 2.5 --out robot.png\n"
      "  devo_evo render results/first --strip --out strip.png\n"
      "  devo_evo render results/first --lineage --count 8 --out lineage.mp4\n"
      "  devo_evo render lineage.bag --out lineage.mp4\n"
      "  devo_evo render results/evo_devo --beside results/evo --out treatments.mp4\n"
      "Options of body and physics are for robots of files; an experiment has its own.");
  app->callback([=, &command]
                { command = [=] { return render(*arguments, picture.path(), picture.format(), options.read()); }; });
}

void addOverviewCommand(CLI::App& tool, Command& command)
{
  CLI::App* app =
      tool.add_subcommand("overview", "A film from founder to champion, with the lineage's curves (docs/pictures.md).");
  const auto output = std::make_shared<std::string>();
  const auto count = std::make_shared<int64_t>(8);
  app->add_option("OUTPUT", *output, "the folder that the experiment wrote to")->required();
  app->add_option("--count", *count, "of individuals, by steps of progress")->capture_default_str();
  const PictureOptions picture(*app);
  app->callback(
      [=, &command]
      {
        command = [=]
        {
          requireFilm(picture.path());
          const auto archive = openExperiment(*output, "an overview");
          return makeFilm(picture.path(), [&](const FilmProgress& progress)
                          { filmOverview(*archive, *count, picture.path(), picture.format(), progress); });
        };
      });
}
}  // namespace devo_evo
