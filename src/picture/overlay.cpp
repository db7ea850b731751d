#include "picture/overlay.h"

#include "devo_evo/experiment/report_text.h"
#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
Ink inkOf(const Colour& colour)
{
  return { colour.red, colour.green, colour.blue, 1.0 };
}

/// The scale of sizes that pictures are designed for: 1 at a height of 720 pixels.
double scaleOf(const Image& image)
{
  return image.height() / 720.0;
}

/// A number with a true minus sign.
std::string signedText(double number, int decimals)
{
  const std::string text = fixedText(number, decimals);
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  return text.rfind('-', 0) == 0 ? (zero ? "" : "\u2212") + text.substr(1) : text;
}

/// Bars of the mean velocities of half seconds, along a line that is the whole life.
void drawVelocityBars(Canvas& canvas, const Readings& readings, double x, double y, double width, double height)
{
  double highest = 1.5;  // body lengths/s; more if the robot is faster
  for (const double velocity : readings.velocities)
  {
    highest = std::max(highest, std::abs(velocity));
  }
  const double windows = std::max(1.0, std::ceil(readings.lifetime / 0.5 - 1e-9));
  const double step = width / windows;
  for (size_t i = 0; i < readings.velocities.size(); ++i)
  {
    const double bar = height * readings.velocities[i] / highest;
    const double left = x + step * static_cast<double>(i) + 0.12 * step;
    Ink ink = inks::VELOCITY;
    ink.opacity = 0.75;
    canvas.fillRectangle(left, bar > 0 ? y - bar : y, 0.76 * step, std::abs(bar), ink);
  }
}

void drawTimeLine(Canvas& canvas, const Readings& readings, double x, double y, double width, double scale)
{
  const double lived = std::clamp(readings.time_since_birth / readings.lifetime, 0.0, 1.0);
  canvas.fillRectangle(x, y, width, 3 * scale, inks::LIGHT, 1.5 * scale);
  canvas.fillRectangle(x, y, std::max(3 * scale, lived * width), 3 * scale, inks::DARK, 1.5 * scale);
  canvas.fillCircle({ x + lived * width, y + 1.5 * scale }, 5 * scale, inks::DARK);
}

/// A number with its unit beneath.
void drawNumber(Canvas& canvas, double x, double y, const std::string& number, const std::string& unit, double scale)
{
  canvas.drawText(x, y, number, 30 * scale, inks::DARK, Anchor::LEFT, true);
  canvas.drawText(x, y + 20 * scale, unit, 13 * scale, inks::GREY);
}
}  // namespace

void drawFloorMarks(Canvas& canvas, const Image& image, const std::vector<FloorMark>& marks, const Camera& camera)
{
  const double scale = scaleOf(image);
  for (const FloorMark& mark : marks)
  {
    const Eigen::Vector2d place = camera.toPicture(mark.place, image.width(), image.height());
    const bool fifth = mark.body_lengths % 5 == 0;
    canvas.drawText(place.x(), place.y(), signedText(mark.body_lengths, 0), (fifth ? 19 : 14) * scale,
                    fifth ? inks::DARK : inks::GREY, Anchor::CENTER, fifth);
  }
}

void drawReadings(Canvas& canvas, const Image& image, const Readings& readings)
{
  const double scale = scaleOf(image), margin = 32 * scale;
  canvas.drawText(margin, 50 * scale, readings.name, 27 * scale, inks::DARK, Anchor::LEFT, true);
  canvas.drawText(margin, 76 * scale, readings.description, 15 * scale, inks::GREY);
  if (readings.to_light)
  {
    canvas.drawText(margin, 100 * scale,
                    fixedText(*readings.to_light, 1) + " m from the light, on a slope of " +
                        fixedText(readings.slope * 57.29577951308232, 1) + "\u00b0",
                    15 * scale, inks::GREY);
  }

  // Side by side where there is room, else the numbers above the line of time.
  const double numbers_width = 590 * scale, width = image.width() - 2 * margin;
  const bool side_by_side = width > numbers_width + 200 * scale;
  const double column = (side_by_side ? numbers_width : width) / 3;
  const double line = image.height() - 48 * scale;
  const double numbers = side_by_side ? line : line - 72 * scale;
  canvas.fillRectangle(0, numbers - 50 * scale, image.width(), image.height() - numbers + 50 * scale, inks::PAPER);
  drawNumber(canvas, margin, numbers, fixedText(std::max(0.0, readings.time_since_birth), 1), "seconds since birth",
             scale);
  drawNumber(canvas, margin + column, numbers, signedText(readings.travelled, 1), "body lengths travelled", scale);
  drawNumber(canvas, margin + 2 * column, numbers, signedText(readings.velocity, 1), "body lengths per second", scale);
  const double x = side_by_side ? margin + numbers_width : margin, line_width = image.width() - margin - x;
  drawVelocityBars(canvas, readings, x, line, line_width, (side_by_side ? 42 : 26) * scale);
  drawTimeLine(canvas, readings, x, line + 12 * scale, line_width, scale);
}

void drawColourLegend(Canvas& canvas, const Image& image, Colouring colouring, const ColourBar& bar)
{
  const double scale = scaleOf(image);
  const bool beneath_title = image.width() < 840 * scale;
  drawColourLegend(canvas, image.width() - 32 * scale, (beneath_title ? 118 : 58) * scale, scale, colouring, bar);
}

void drawColourLegend(Canvas& canvas, double right, double y, double scale, Colouring colouring, const ColourBar& bar)
{
  const double width = 190 * scale, height = 10 * scale, x = right - width;
  std::vector<Ink> inks_of_scale;
  constexpr int steps = 48;
  for (int i = 0; i <= steps; ++i)
  {
    const double value = static_cast<double>(i) / steps;
    inks_of_scale.push_back(inkOf(colouring == Colouring::PHASE ? hue(value) : jet(value)));
  }
  canvas.fillWithGradient(x, y, width, height, inks_of_scale);
  canvas.drawText(x + width, y - 10 * scale, bar.title, 14 * scale, inks::DARK, Anchor::RIGHT);
  canvas.drawText(x, y + height + 17 * scale, bar.low, 12 * scale, inks::GREY);
  canvas.drawText(x + width, y + height + 17 * scale, bar.high, 12 * scale, inks::GREY, Anchor::RIGHT);
}
}  // namespace devo_evo
