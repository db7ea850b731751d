#include "devo_evo/experiment/report_text.h"
#include "devo_evo/picture/pictures.h"
#include "picture/overlay.h"
#include "picture/pose_row.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr int POSES = 10;
constexpr double AIRBORNE = 0.05;     // share of life in the air from which on a gait is a gallop
constexpr double ROLLER_TURNS = 1.0;  // full turns from which on a robot is a roller
constexpr double EARLY = 1.0;         // time after birth before which it rolls "from birth" [s]

bool rolls(const Evaluation& e)
{
  return e.turns >= ROLLER_TURNS && e.fell_over_since_birth_s;
}

/// A row of the figure: who may be in it, and when of its life it is shown.
struct GaitRow
{
  const char* title;
  const char* wanted;
  bool (*fits)(const Evaluation&);
  std::vector<double> (*times)(const SoftBodySettings&);
};

/// Eight times a cycle of actuation, in the middle of life.
std::vector<double> stride(const SoftBodySettings& body)
{
  const double interval = 0.125 / std::max(body.actuation_frequency, 0.1);
  const double to = std::max(0.5 * body.lifetime, std::min(body.lifetime, POSES * interval));
  return equalTimes(std::max(0.0, to - (POSES - 1) * interval), to, POSES);
}

std::vector<double> wholeLife(const SoftBodySettings& body)
{
  return equalTimes(0.0, body.lifetime, POSES);
}

std::vector<double> afterBirth(const SoftBodySettings& body)
{
  return equalTimes(0.0, std::min(body.lifetime, 1.35), POSES);
}

const std::array<GaitRow, 4>& gaitRowKinds()
{
  static const std::array<GaitRow, 4> rows = { {
      { "Trotting", "less than one turn, hardly ever in the air",
        [](const Evaluation& e) { return std::abs(e.turns) < ROLLER_TURNS && e.airborne_fraction < AIRBORNE; },
        stride },
      { "Galloping", "less than one turn, in the air for 5 % of life or more",
        [](const Evaluation& e) { return std::abs(e.turns) < ROLLER_TURNS && e.airborne_fraction >= AIRBORNE; },
        stride },
      { "Galloper to roller", "one turn or more, first on its back 1 s after birth or later",
        [](const Evaluation& e) { return rolls(e) && *e.fell_over_since_birth_s >= EARLY; }, wholeLife },
      { "Rolling from birth", "one turn or more, on its back within 1 s of birth",
        [](const Evaluation& e) { return rolls(e) && *e.fell_over_since_birth_s < EARLY; }, afterBirth },
  } };
  return rows;
}

/// The champions of all trials and their ancestors: whose genomes are always at hand.
std::vector<ArchivedIndividual> candidates(const Archive& archive)
{
  std::vector<ArchivedIndividual> all;
  for (const int64_t trial : archive.trials())
  {
    for (ArchivedIndividual& individual : archive.readLineage(trial, archive.championOf(trial)))
    {
      const std::optional<Evaluation>& evaluation = individual.individual.evaluation;
      if (individual.has_genome && evaluation && evaluation->valid && evaluation->fitness > 0.0)
      {
        all.push_back(std::move(individual));
      }
    }
  }
  return all;
}

/// The fittest that fits; nullptr if nobody does.
const ArchivedIndividual* bestFor(const GaitRow& row, const std::vector<ArchivedIndividual>& individuals)
{
  const ArchivedIndividual* best = nullptr;
  for (const ArchivedIndividual& individual : individuals)
  {
    const bool better =
        best == nullptr || individual.individual.evaluation->fitness > best->individual.evaluation->fitness;
    if (better && row.fits(*individual.individual.evaluation))
    {
      best = &individual;
    }
  }
  return best;
}
}  // namespace

Image gaitRows(const Archive& archive, int width, Colouring colouring)
{
  const double scale = width / 1280.0;
  const int left = static_cast<int>(215 * scale), row_width = width - left;
  const int row_height = static_cast<int>(150 * scale), head = static_cast<int>(84 * scale);
  const std::vector<ArchivedIndividual> individuals = candidates(archive);
  const BodySettings settings = archive.settings().body;
  const SoftBodySettings& body = softSettings(settings, "rows of gaits");
  const std::shared_ptr<const Appearance> appearance = makeAppearance(settings);
  Image image(width, head + row_height * static_cast<int>(gaitRowKinds().size()));
  {
    Canvas canvas(image);
    canvas.fillRectangle(0, 0, width, image.height(), { 1, 1, 1, 1 });
  }
  for (size_t i = 0; i < gaitRowKinds().size(); ++i)
  {
    const GaitRow& row = gaitRowKinds()[i];
    const int y = head + row_height * static_cast<int>(i);
    const ArchivedIndividual* best = bestFor(row, individuals);
    std::vector<double> times;
    if (best != nullptr)
    {
      RobotChoice choice;
      choice.trial = best->individual.trial;
      choice.id = best->individual.id;
      times = row.times(body);
      image.place(
          paintPoses(*appearance, framesAt(*findRobot(archive, choice), times), colouring, row_width, row_height), left,
          y);
    }
    Canvas canvas(image);
    const double x = 24 * scale;
    canvas.drawText(x, y + 58 * scale, row.title, 17 * scale, inks::DARK, Anchor::LEFT, true);
    if (best == nullptr)
    {
      canvas.drawText(left, y + 58 * scale, std::string("nobody among champions and their ancestors: ") + row.wanted,
                      14 * scale, inks::GREY);
      continue;
    }
    const Individual& individual = best->individual;
    canvas.drawText(x, y + 80 * scale, "robot " + individualName(individual.trial, individual.id), 13 * scale,
                    inks::GREY);
    canvas.drawText(x, y + 98 * scale, fixedText(individual.evaluation->fitness, 1) + " body lengths", 13 * scale,
                    inks::GREY);
    canvas.drawText(x, y + 116 * scale, fixedText(times.front(), 2) + " to " + fixedText(times.back(), 2) + " s",
                    13 * scale, inks::GREY);
  }
  Canvas canvas(image);
  canvas.drawText(24 * scale, 36 * scale, "Evolved behaviour", 20 * scale, inks::DARK, Anchor::LEFT, true);
  canvas.drawText(24 * scale, 58 * scale, "each row moves from left to right", 14 * scale, inks::GREY);
  drawColourLegend(canvas, width - 24 * scale, 30 * scale, scale, colouring, appearance->colourBar(colouring));
  return image;
}
}  // namespace devo_evo
