#include "picture/curves.h"

#include "devo_evo/render/lineage_curves.h"
#include "picture/overlay.h"

#include <cmath>

namespace devo_evo
{
PicturePoint PlotArea::at(double data_x, double data_y) const
{
  return { x + width * (data_x - x_from) / (x_to - x_from), y + height * (y_to - data_y) / (y_to - y_from) };
}

void drawAxes(Canvas& canvas, const PlotArea& area, const std::string& title, const std::string& x_label, double scale)
{
  const double bottom = area.y + area.height;
  canvas.strokeLine({ { area.x, area.y }, { area.x, bottom }, { area.x + area.width, bottom } }, inks::GREY, scale);
  for (const AxisTick& tick : roundTicks({ area.y_from, area.y_to }, 3))
  {
    const PicturePoint point = area.at(area.x_from, tick.value);
    canvas.strokeLine({ point, { area.x + area.width, point.second } }, { 0, 0, 0, 0.07 }, scale);
    canvas.drawText(area.x - 7 * scale, point.second + 4 * scale, tick.text, 11 * scale, inks::GREY, Anchor::RIGHT);
  }
  for (const AxisTick& tick : roundTicks({ area.x_from, area.x_to }, 4))
  {
    const PicturePoint point = area.at(tick.value, area.y_from);
    canvas.strokeLine({ { point.first, bottom }, { point.first, bottom + 4 * scale } }, inks::GREY, scale);
    canvas.drawText(point.first, bottom + 17 * scale, tick.text, 11 * scale, inks::GREY, Anchor::CENTER);
  }
  canvas.drawText(area.x, area.y - 9 * scale, title, 13 * scale, inks::DARK);
  canvas.drawText(area.x + area.width, bottom + 33 * scale, x_label, 12 * scale, inks::GREY, Anchor::RIGHT);
}

void drawLineageCurves(Canvas& canvas, const Lineage& lineage, size_t present, double x, double y, double width,
                       double height, double scale)
{
  const auto generation = [&](size_t i) { return static_cast<double>(lineage.individuals[i].individual.generation); };
  const AxisRange generations = generationsOf(lineage.individuals);
  const LineageCurves curves = lineageCurves(*makeBody(lineage.settings.body));
  const double row = height / static_cast<double>(curves.size());
  for (size_t i = 0; i < curves.size(); ++i)
  {
    const LineageCurve& curve = curves[i];
    const AxisRange values = rangeOf(curve, lineage.individuals);
    const PlotArea area{ x + 44 * scale,     y + static_cast<double>(i) * row + 24 * scale,
                         width - 60 * scale, row - 74 * scale,
                         generations.low,    generations.high,
                         values.low,         values.high };
    drawAxes(canvas, area, curve.title, i + 1 == curves.size() ? "generation of birth" : "", scale);
    std::vector<PicturePoint> points;
    for (size_t k = 0; k < lineage.individuals.size(); ++k)
    {
      const double value = curve.value(lineage.individuals[k]);
      if (std::isfinite(value))
      {
        points.push_back(area.at(generation(k), value));
      }
    }
    const Ink ink{ curve.colour[0], curve.colour[1], curve.colour[2], 1.0 };
    Ink faint = ink;
    faint.opacity = 0.75;
    canvas.strokeLine(points, faint, 1.8 * scale);
    const double value = curve.value(lineage.individuals[present]);
    const PicturePoint here = area.at(generation(present), std::isfinite(value) ? value : values.low);
    canvas.strokeLine({ { here.first, area.y }, { here.first, area.y + area.height } }, { 0, 0, 0, 0.25 }, scale);
    canvas.fillCircle(here, 6 * scale, { 1, 1, 1, 1 });
    canvas.fillCircle(here, 4.5 * scale, ink);
  }
}
}  // namespace devo_evo
