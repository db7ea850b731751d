#include "devo_evo/experiment/report_text.h"
#include "devo_evo/picture/pictures.h"
#include "devo_evo/soft_body/evaluation.h"
#include "devo_evo/soft_body/text.h"
#include "picture/curves.h"
#include "picture/overlay.h"
#include "picture/pose_row.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr double WINDOW = Evaluation::VELOCITY_WINDOW;

/// The part that develops most from birth to the end of life.
size_t mostDeveloping(const Appearance& appearance, const RobotFrame& at_birth)
{
  const auto change = [&](size_t part) { return std::abs(at_birth.parts[part].remaining_development); };
  const std::vector<size_t> parts = appearance.measuredParts();
  return *std::max_element(parts.begin(), parts.end(), [&](size_t a, size_t b) { return change(a) < change(b); });
}

/// What the lower half of a strip shows.
struct LifeTrace
{
  std::vector<double> time, present_length, resting_length;  ///< of one part [s, m, m]
  std::vector<Eigen::Vector3d> window_velocity;              ///< means of consecutive windows [m/s]
};

LifeTrace traceOf(const ShownRobot& robot, const Appearance& appearance, size_t part)
{
  constexpr double samples_per_cycle = 40, most_samples = 20000;
  const double lifetime = makeBody(robot.body)->lifetime();
  const double interval =
      std::max(1.0 / (samples_per_cycle * std::max(appearance.actuationFrequency(), 0.1)), lifetime / most_samples);
  LifePlayback playback(robot.body, robot.program);
  LifeTrace trace;
  Eigen::Vector3d window_start = Eigen::Vector3d::Zero();
  double window_start_time = -1.0;
  for (double time = 0.0; time <= lifetime && playback.advanceTo(time); time += interval)
  {
    const RobotFrame frame = playback.frame();
    const ShownPart& shown = frame.parts[part];
    trace.time.push_back(frame.time_since_birth);
    trace.present_length.push_back(shown.present_length);
    trace.resting_length.push_back(shown.resting_length);
    const double since = frame.time_since_birth - window_start_time;
    if (window_start_time < 0.0 || since >= WINDOW)
    {
      if (window_start_time >= 0.0)
      {
        trace.window_velocity.push_back((frame.center_of_mass - window_start) / since);
      }
      window_start = frame.center_of_mass;
      window_start_time = frame.time_since_birth;
    }
  }
  playback.finish();
  if (!playback.diverged() && playback.time() - window_start_time > 0.5 * WINDOW)  // the last window ends with life
  {
    trace.window_velocity.push_back((playback.frame().center_of_mass - window_start) /
                                    (playback.time() - window_start_time));
  }
  return trace;
}

std::vector<PicturePoint> pointsOf(const PlotArea& area, const std::vector<double>& time,
                                   const std::vector<double>& length)
{
  std::vector<PicturePoint> points;
  for (size_t i = 0; i < time.size(); ++i)
  {
    points.push_back(area.at(time[i], 100 * length[i]));
  }
  return points;
}

void drawLengths(Canvas& canvas, const PlotArea& area, const LifeTrace& trace, double scale)
{
  drawAxes(canvas, area, "", "", scale);
  canvas.strokeLine(pointsOf(area, trace.time, trace.present_length), { 0.36, 0.55, 0.75, 0.9 }, 0.9 * scale);
  canvas.strokeLine(pointsOf(area, trace.time, trace.resting_length), inks::DARK, 2.4 * scale);
}

/// Arrows as seen from above, to the right along +y: as long as a window is wide at the fastest.
void drawVelocities(Canvas& canvas, const PlotArea& area, const LifeTrace& trace, double y, double scale)
{
  double fastest = 1e-9;
  for (const Eigen::Vector3d& velocity : trace.window_velocity)
  {
    fastest = std::max(fastest, velocity.head<2>().norm());
  }
  for (size_t i = 0; i < trace.window_velocity.size(); ++i)
  {
    const double middle = (static_cast<double>(i) + 0.5) * WINDOW;
    const double width = area.at(WINDOW, 0).first - area.at(0, 0).first;
    const double longest = 0.95 * width, x = area.at(middle, 0).first;
    const double dx = longest * trace.window_velocity[i].y() / fastest;
    const double dy = longest * trace.window_velocity[i].x() / fastest;
    canvas.drawArrow({ x - dx / 2, y - dy / 2 }, { x + dx / 2, y + dy / 2 }, inks::VELOCITY, 2.6 * scale);
  }
}
}  // namespace

Image stripOfLife(const ShownRobot& robot, int poses, std::optional<int> part, int width, Colouring colouring)
{
  constexpr int most_poses = 24;
  if (poses < 2 || poses > most_poses)
  {
    throw InvalidInput("poses is " + toText(poses) + "; it must be within 2 to " + toText(most_poses));
  }
  const std::shared_ptr<const Appearance> appearance = makeAppearance(robot.body);
  const double scale = width / 1280.0, lifetime = makeBody(robot.body)->lifetime();
  const std::vector<double> times = equalTimes(0.0, lifetime, poses);
  const int head = static_cast<int>(56 * scale), bodies = static_cast<int>(width / (0.95 * poses) + 26 * scale);
  const int height = head + bodies + static_cast<int>(312 * scale);
  const std::vector<RobotFrame> frames = framesAt(robot, times);
  const auto last_part = static_cast<int>(frames.front().parts.size()) - 1;
  if (part && (*part < 0 || *part > last_part))
  {
    throw InvalidInput("part is " + toText(*part) + "; it must be within 0 to " + toText(last_part));
  }
  const size_t shown = part ? static_cast<size_t>(*part) : mostDeveloping(*appearance, frames.front());
  const LifeTrace trace = traceOf(robot, *appearance, shown);

  Image image(width, height);
  const Image row = paintPoses(*appearance, frames, colouring, width, bodies);
  {
    Canvas canvas(image);
    canvas.fillRectangle(0, 0, width, height, { 1, 1, 1, 1 });
  }
  image.place(row, 0, head);
  Canvas canvas(image);
  const double margin = 24 * scale;
  canvas.drawText(margin, 36 * scale, "Robot " + robot.name, 20 * scale, inks::DARK, Anchor::LEFT, true);
  canvas.drawText(margin + canvas.textWidth("Robot " + robot.name + "   ", 20 * scale, true), 36 * scale,
                  descriptionOf(robot), 14 * scale, inks::GREY);
  drawColourLegend(canvas, width - 24 * scale, 32 * scale, scale, colouring, appearance->colourBar(colouring));

  // Times are where the poses are.
  const double first = 0.5 * width / poses, last = width - first;
  for (int i = 0; i < poses; ++i)
  {
    canvas.drawText(first + (last - first) * i / (poses - 1), head + bodies + 8 * scale,
                    fixedText(times[static_cast<size_t>(i)], 2) + " s", 14 * scale, inks::DARK, Anchor::CENTER);
  }
  double lowest = trace.present_length.front(), highest = lowest;
  for (const double length : trace.present_length)
  {
    lowest = std::min(lowest, length);
    highest = std::max(highest, length);
  }
  const double pad = 0.08 * (highest - lowest) + 1e-5;
  const PlotArea area{ first,    head + bodies + 62 * scale, last - first,         140 * scale, 0.0,
                       lifetime, 100 * (lowest - pad),       100 * (highest + pad) };
  canvas.drawText(first, area.y - 14 * scale,
                  "Length of " + appearance->partName(shown) + " [cm]: growth (black) and as it is (blue)", 13 * scale,
                  inks::DARK);
  drawLengths(canvas, area, trace, scale);
  const double arrows = area.y + area.height + 74 * scale;
  canvas.drawText(first, arrows - 32 * scale, "Velocity in windows of 0.5 s, seen from above; +y is to the right",
                  13 * scale, inks::DARK);
  drawVelocities(canvas, area, trace, arrows, scale);
  return image;
}
}  // namespace devo_evo
