#include "devo_evo/picture/film_writer.h"
#include "devo_evo/picture/pictures.h"
#include "devo_evo/soft_body/text.h"
#include "picture/curves.h"
#include "picture/life_painter.h"
#include "picture/overlay.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr double END_STILL = 1.2;  // how long the last picture of a life stays [s]

/// A film that counts its pictures.
class CountedFilm
{
public:
  CountedFilm(const std::string& path, const PictureFormat& format, int64_t total, const FilmProgress& progress)
    : writer_(makeFilmWriter(path, format.width, format.height, format.pictures_per_s))
    , pictures_per_s_(format.pictures_per_s)
    , total_(total)
    , progress_(progress)
  {
  }

  void add(const Image& picture)
  {
    writer_->add(picture);
    ++done_;
    if (progress_)
    {
      progress_(std::min(done_, total_), total_);
    }
  }

  void hold(const Image& picture, double seconds)
  {
    for (int64_t i = stillPictures(pictures_per_s_, seconds); i > 0; --i)
    {
      add(picture);
    }
  }

  static int64_t stillPictures(int pictures_per_s, double seconds) { return std::lround(pictures_per_s * seconds); }

  void finish() { writer_->finish(); }

private:
  const std::unique_ptr<FilmWriter> writer_;
  const int pictures_per_s_;
  const int64_t total_;
  const FilmProgress progress_;
  int64_t done_ = 0;
};

ShownRobot robotAt(const Archive& archive, const Lineage& lineage, size_t position)
{
  const Individual& individual = lineage.individuals[position].individual;
  RobotChoice choice;
  choice.trial = individual.trial;
  choice.id = individual.id;
  return *findRobot(archive, choice);
}

Image titlePicture(const Lineage& lineage, const std::vector<size_t>& positions, const PictureFormat& format)
{
  Image image(format.width, format.height);
  Canvas canvas(image);
  const double scale = format.height / 720.0, middle = format.width / 2.0;
  canvas.fillRectangle(0, 0, format.width, format.height, { 0.98, 0.98, 0.975, 1 });
  const EvolutionSettings& evolution = lineage.settings.evolution;
  const Individual& champion = lineage.individuals.back().individual;
  canvas.drawText(middle, 300 * scale, "From founder to champion", 46 * scale, inks::DARK, Anchor::CENTER, true);
  canvas.drawText(middle, 350 * scale,
                  treatmentTitle(toString(evolution.treatment)) + ", trial " + toText(champion.trial) +
                      ": the line of descent of robot " + individualName(champion.trial, champion.id),
                  22 * scale, inks::GREY, Anchor::CENTER);
  canvas.drawText(middle, 392 * scale,
                  toText(static_cast<int64_t>(positions.size())) + " of " +
                      toText(static_cast<int64_t>(lineage.individuals.size())) + " individuals, born in generations " +
                      toText(lineage.individuals.front().individual.generation) + " to " + toText(champion.generation),
                  18 * scale, inks::GREY, Anchor::CENTER);
  return image;
}

/// The lineage's curves at the right of a film, in a column of their own.
Image curvePicture(const Lineage& lineage, const std::vector<size_t>& positions, size_t step, int width, int height)
{
  Image image(width, height);
  Canvas canvas(image);
  const double scale = height / 720.0;
  canvas.fillRectangle(0, 0, width, height, { 1, 1, 1, 1 });
  const ArchivedIndividual& present = lineage.individuals[positions[step]];
  canvas.drawText(24 * scale, 50 * scale,
                  step == 0 ? "The founder"
                  : step + 1 == positions.size()
                      ? "The champion"
                      : "Ancestor " + toText(static_cast<int64_t>(positions[step] + 1)) + " of " +
                            toText(static_cast<int64_t>(lineage.individuals.size())),
                  21 * scale, inks::DARK, Anchor::LEFT, true);
  if (present.individual.evaluation)
  {
    canvas.drawText(24 * scale, 76 * scale,
                    behaviourText(*present.individual.evaluation, *makeBody(lineage.settings.body)), 13 * scale,
                    inks::GREY);
  }
  drawLineageCurves(canvas, lineage, positions[step], 16 * scale, 108 * scale, width - 24 * scale, height - 120 * scale,
                    scale);
  return image;
}
}  // namespace

void PictureFormat::validate() const
{
  Image(width, height);
  constexpr int most_pictures = 240;
  constexpr double slowest = 0.01, fastest = 100.0;
  if (pictures_per_s < 1 || pictures_per_s > most_pictures)
  {
    throw InvalidInput("rate is " + toText(pictures_per_s) + "; it must be within 1 to " + toText(most_pictures) +
                       " pictures per second");
  }
  if (!(speed >= slowest && speed <= fastest))
  {
    throw InvalidInput("speed is " + toText(speed) + "; it must be within " + toText(slowest) + " to " +
                       toText(fastest));
  }
}

Image pictureOfLife(const ShownRobot& robot, double time_since_birth, const PictureFormat& format)
{
  format.validate();
  const double lifetime = makeBody(robot.body)->lifetime();
  if (!(time_since_birth >= 0.0 && time_since_birth <= lifetime))
  {
    throw InvalidInput("time is " + toText(time_since_birth) + "; it must be within the robot's life, 0 to " +
                       toText(lifetime) + " s");
  }
  ViewOptions view = viewOf(format, 1.0);
  LifeScene life(robot, view);
  while (life.frame().time_since_birth < time_since_birth && life.next())
  {
  }
  if (!life.evaluation().valid)
  {
    throw PictureError("robot " + robot.name + ": its simulation diverges before " + toText(time_since_birth) + " s");
  }
  return LifePainter(format.width, format.height, format.colouring).paint(life);
}

void filmLife(const ShownRobot& robot, const std::string& path, const PictureFormat& format,
              const FilmProgress& progress)
{
  format.validate();
  const ViewOptions view = viewOf(format, format.speed);
  LifeScene life(robot, view);
  LifePainter painter(format.width, format.height, format.colouring);
  CountedFilm film(path, format, picturesOfLife(robot.body, view), progress);
  do
  {
    film.add(painter.paint(life));
  } while (life.next());
  film.finish();
}

void filmSideBySide(const std::vector<ShownRobot>& robots, const std::vector<std::string>& titles,
                    const std::string& path, const PictureFormat& format, const FilmProgress& progress)
{
  format.validate();
  const int gap = 4, count = static_cast<int>(robots.size());
  const int width = (format.width - gap * (count - 1)) / count;
  const ViewOptions view = viewOf(format, format.speed);
  LifePainter painter(width, format.height, format.colouring);
  std::vector<std::unique_ptr<LifeScene>> lives;
  int64_t pictures = 0;
  for (const ShownRobot& robot : robots)
  {
    lives.push_back(std::make_unique<LifeScene>(robot, view));
    pictures = std::max(pictures, picturesOfLife(robot.body, view));
  }
  CountedFilm film(path, format, pictures, progress);
  for (bool moving = true; moving;)
  {
    Image picture(format.width, format.height);
    for (int i = 0; i < count; ++i)
    {
      picture.place(painter.paint(*lives[static_cast<size_t>(i)], titles[static_cast<size_t>(i)]), i * (width + gap),
                    0);
    }
    film.add(picture);
    moving = false;
    for (const auto& life : lives)
    {
      moving = life->next() || moving;
    }
  }
  film.finish();
}

void filmLineage(const Archive& archive, const Lineage& lineage, const std::vector<size_t>& positions,
                 const std::vector<double>& speeds, double title_s, const std::string& path,
                 const PictureFormat& format, const FilmProgress& progress)
{
  format.validate();
  const auto speed_of = [&](size_t step) { return speeds.empty() ? format.speed : speeds[step]; };
  const int curves_width = 3 * format.width / 10, width = format.width - curves_width;
  int64_t pictures = CountedFilm::stillPictures(format.pictures_per_s, title_s);
  for (size_t step = 0; step < positions.size(); ++step)
  {
    pictures += picturesOfLife(lineage.settings.body, viewOf(format, speed_of(step))) +
                CountedFilm::stillPictures(format.pictures_per_s, END_STILL);
  }
  LifePainter painter(width, format.height, format.colouring);
  CountedFilm film(path, format, pictures, progress);
  film.hold(titlePicture(lineage, positions, format), title_s);
  for (size_t step = 0; step < positions.size(); ++step)
  {
    LifeScene life(robotAt(archive, lineage, positions[step]), viewOf(format, speed_of(step)));
    Image picture(format.width, format.height);
    picture.place(curvePicture(lineage, positions, step, curves_width, format.height), width, 0);
    do
    {
      picture.place(painter.paint(life), 0, 0);
      film.add(picture);
    } while (life.next());
    film.hold(picture, END_STILL);
  }
  film.finish();
}

void filmOverview(const Archive& archive, int64_t count, const std::string& path, const PictureFormat& format,
                  const FilmProgress& progress)
{
  constexpr double title = 2.5;      // [s]
  constexpr double ancestors = 2.0;  // times as fast as the champion
  const Lineage lineage = readLineage(archive, std::nullopt, std::nullopt);
  const std::vector<size_t> positions = stepsOfProgress(lineage, count);
  std::vector<double> speeds(positions.size(), ancestors * format.speed);
  speeds.back() = format.speed;
  filmLineage(archive, lineage, positions, speeds, title, path, format, progress);
}
}  // namespace devo_evo
