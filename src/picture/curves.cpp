#include "picture/curves.h"

#include "devo_evo/experiment/report_text.h"
#include "picture/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace devo_evo
{
namespace
{
struct Curve
{
  const char* title;
  Ink ink;
  std::function<double(const ArchivedIndividual&)> value;
};

const std::array<Curve, 3>& lineageCurves()
{
  static const std::array<Curve, 3> curves = { {
      { "fitness [body lengths]",
        { 0.84, 0.30, 0.16, 1.0 },
        [](const ArchivedIndividual& a) {
          return a.individual.evaluation && a.individual.evaluation->valid ? a.individual.evaluation->fitness : NAN;
        } },
      { "W_L: how much the body develops",
        { 0.11, 0.55, 0.42, 1.0 },
        [](const ArchivedIndividual& a) { return a.morphology_window; } },
      { "W_\u03a6: how much the control develops",
        { 0.33, 0.40, 0.68, 1.0 },
        [](const ArchivedIndividual& a) { return a.control_window; } },
  } };
  return curves;
}

std::string tickText(double value, double step)
{
  return fixedText(value, step >= 1.0 ? 0 : step >= 0.1 ? 1 : step >= 0.01 ? 2 : 3);
}
}  // namespace

PicturePoint PlotArea::at(double data_x, double data_y) const
{
  return { x + width * (data_x - x_from) / (x_to - x_from), y + height * (y_to - data_y) / (y_to - y_from) };
}

std::vector<double> roundTicks(double from, double to, int count)
{
  const double raw = (to - from) / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double step = (raw / power < 1.5 ? 1.0 : raw / power < 3.5 ? 2.0 : raw / power < 7.5 ? 5.0 : 10.0) * power;
  std::vector<double> ticks;
  for (double k = std::ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k)
  {
    ticks.push_back(k * step + 0.0);  // not -0
  }
  return ticks;
}

void drawAxes(Canvas& canvas, const PlotArea& area, const std::string& title, const std::string& x_label, double scale)
{
  const double bottom = area.y + area.height;
  canvas.strokeLine({ { area.x, area.y }, { area.x, bottom }, { area.x + area.width, bottom } }, inks::GREY, scale);
  const std::vector<double> rows = roundTicks(area.y_from, area.y_to, 3);
  for (const double tick : rows)
  {
    const PicturePoint point = area.at(area.x_from, tick);
    canvas.strokeLine({ point, { area.x + area.width, point.second } }, { 0, 0, 0, 0.07 }, scale);
    canvas.drawText(area.x - 7 * scale, point.second + 4 * scale,
                    tickText(tick, rows.size() > 1 ? rows[1] - rows[0] : 1.0), 11 * scale, inks::GREY, Anchor::RIGHT);
  }
  const std::vector<double> columns = roundTicks(area.x_from, area.x_to, 4);
  for (const double tick : columns)
  {
    const PicturePoint point = area.at(tick, area.y_from);
    canvas.strokeLine({ { point.first, bottom }, { point.first, bottom + 4 * scale } }, inks::GREY, scale);
    canvas.drawText(point.first, bottom + 17 * scale,
                    tickText(tick, columns.size() > 1 ? columns[1] - columns[0] : 1.0), 11 * scale, inks::GREY,
                    Anchor::CENTER);
  }
  canvas.drawText(area.x, area.y - 9 * scale, title, 13 * scale, inks::DARK);
  canvas.drawText(area.x + area.width, bottom + 33 * scale, x_label, 12 * scale, inks::GREY, Anchor::RIGHT);
}

void drawLineageCurves(Canvas& canvas, const Lineage& lineage, size_t present, double x, double y, double width,
                       double height, double scale)
{
  const auto generation = [&](size_t i) { return static_cast<double>(lineage.individuals[i].individual.generation); };
  const double last = std::max(generation(lineage.individuals.size() - 1), generation(0) + 1.0);
  const double row = height / static_cast<double>(lineageCurves().size());
  for (size_t i = 0; i < lineageCurves().size(); ++i)
  {
    const Curve& curve = lineageCurves()[i];
    double low = 0.0, high = i == 0 ? 1.0 : 0.5;
    std::vector<PicturePoint> points;
    for (const ArchivedIndividual& individual : lineage.individuals)
    {
      const double value = curve.value(individual);
      low = std::isfinite(value) ? std::min(low, value) : low;
      high = std::isfinite(value) ? std::max(high, value) : high;
    }
    const PlotArea area{ x + 44 * scale,
                         y + static_cast<double>(i) * row + 24 * scale,
                         width - 60 * scale,
                         row - 74 * scale,
                         generation(0),
                         last,
                         low,
                         1.05 * high };
    drawAxes(canvas, area, curve.title, i + 1 == lineageCurves().size() ? "generation of birth" : "", scale);
    for (size_t k = 0; k < lineage.individuals.size(); ++k)
    {
      const double value = curve.value(lineage.individuals[k]);
      if (std::isfinite(value))
      {
        points.push_back(area.at(generation(k), value));
      }
    }
    Ink faint = curve.ink;
    faint.opacity = 0.75;
    canvas.strokeLine(points, faint, 1.8 * scale);
    const double value = curve.value(lineage.individuals[present]);
    const PicturePoint here = area.at(generation(present), std::isfinite(value) ? value : low);
    canvas.strokeLine({ { here.first, area.y }, { here.first, area.y + area.height } }, { 0, 0, 0, 0.25 }, scale);
    canvas.fillCircle(here, 6 * scale, { 1, 1, 1, 1 });
    canvas.fillCircle(here, 4.5 * scale, curve.ink);
  }
}
}  // namespace devo_evo
