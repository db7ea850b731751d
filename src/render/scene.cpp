#include "devo_evo/render/scene.h"

#include "devo_evo/soft_body/text.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
// In body lengths.
constexpr double MARGIN_AHEAD = 3.0;
constexpr double MARGIN_BESIDE = 3.0;
constexpr double FARTHEST = 500.0;  // a floor ends there, however far a robot is thrown
constexpr int64_t MARKED_EVERY = 5;
constexpr int64_t LABELS_BESIDE = 2;

/// Numbers of the lines that bound a way along one axis, counted from the birthplace.
std::pair<int64_t, int64_t> linesAround(double low, double high, double birthplace, double body_length, double margin)
{
  const auto lineOf = [&](double place) { return std::clamp((place - birthplace) / body_length, -FARTHEST, FARTHEST); };
  return { static_cast<int64_t>(std::floor(lineOf(low) - margin)),
           static_cast<int64_t>(std::ceil(lineOf(high) + margin)) };
}
}  // namespace

void MotionTrace::add(double time_since_birth, const Eigen::Vector3d& center_of_mass)
{
  recent_.emplace_back(time_since_birth, center_of_mass);
  const auto within = [&](const Place& place) { return place.first > time_since_birth - VELOCITY_WINDOW; };
  const auto first_within = std::find_if(recent_.begin(), recent_.end(), within);
  if (first_within - recent_.begin() > 1)
  {
    recent_.erase(recent_.begin(), first_within - 1);
  }
  if (time_since_birth >= next_path_point_)
  {
    path_.push_back(center_of_mass);
    next_path_point_ = time_since_birth + PATH_SPACING;
  }
}

std::vector<Eigen::Vector3d> MotionTrace::path() const
{
  std::vector<Eigen::Vector3d> path = path_;
  if (!recent_.empty())
  {
    path.push_back(recent_.back().second);
  }
  return path;
}

Eigen::Vector3d MotionTrace::velocity() const
{
  if (recent_.size() < 2)
  {
    return Eigen::Vector3d::Zero();
  }
  return (recent_.back().second - recent_.front().second) / (recent_.back().first - recent_.front().first);
}

FloorPlan floorPlan(const LifeSurvey& life, const Surroundings& surroundings)
{
  FloorPlan plan;
  plan.body_length = surroundings.body_length;
  Eigen::AlignedBox2d way = life.extent;
  way.extend(Eigen::Vector2d(life.birthplace.head<2>()));
  const Eigen::Vector3d& origin = life.birthplace;
  const auto [left, right] = linesAround(way.min().x(), way.max().x(), origin.x(), plan.body_length, MARGIN_BESIDE);
  const auto [back, front] = linesAround(way.min().y(), way.max().y(), origin.y(), plan.body_length, MARGIN_AHEAD);
  const auto x = [&](int64_t line) { return origin.x() + static_cast<double>(line) * plan.body_length; };
  const auto y = [&](int64_t line) { return origin.y() + static_cast<double>(line) * plan.body_length; };

  plan.area.extend(Eigen::Vector2d(x(left), y(back)));
  plan.area.extend(Eigen::Vector2d(x(right), y(front)));
  for (int64_t line = left; line <= right; ++line)
  {
    plan.lines.push_back({ Eigen::Vector3d(x(line), y(back), 0.0), Eigen::Vector3d(x(line), y(front), 0.0) });
  }
  for (int64_t line = back; line <= front; ++line)
  {
    const FloorPlan::Line across = { Eigen::Vector3d(x(left), y(line), 0.0), Eigen::Vector3d(x(right), y(line), 0.0) };
    plan.lines.push_back(across);
    if (line % MARKED_EVERY == 0)
    {
      plan.marked_lines.push_back(across);
      plan.labels.emplace_back(Eigen::Vector3d(x(LABELS_BESIDE), y(line), 0.0), toText(line));
    }
  }
  return plan;
}
}  // namespace devo_evo
