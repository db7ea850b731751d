#include "devo_evo/rigid_body/quadruped_program.h"
#include "devo_evo/soft_body/text.h"
#include "render/body_kinds.h"
#include "render/solids.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
constexpr double RADIAN = 3.141592653589793 / 180.0;
constexpr int ABDOMEN_SECTORS = 24;
constexpr int SECTORS_PER_STRIPE = 3;
constexpr Colour LIGHT_STRIPE = { 0.90F, 0.89F, 0.85F };
constexpr Colour DARK_STRIPE = { 0.52F, 0.53F, 0.56F };

/// Striped like a ball, along meridians of the lateral axis: it can be seen to roll.
class QuadrupedAppearance : public Appearance
{
public:
  explicit QuadrupedAppearance(const RigidBodySettings& settings)
    : settings_(settings)
    , abdomen_(capsule(settings.abdomen_radius, 0.0, ABDOMEN_SECTORS, 6))
    , leg_(capsule(settings.leg_radius, settings.leg_residual + settings.leg_range - 2.0 * settings.leg_radius, 10, 2))
  {
  }

  Surroundings surroundings() const override
  {
    Surroundings surroundings;
    surroundings.body_length = 2.0 * settings_.abdomen_radius;
    surroundings.body_size = surroundings.body_length;
    surroundings.stroke = 0.25 * surroundings.body_length;
    surroundings.slope = settings_.slope * RADIAN;
    surroundings.light =
        surroundings.floorToWorld() * Eigen::Vector3d(0.0, settings_.light_distance, settings_.light_height);
    return surroundings;
  }

  std::vector<Surface> surfaces(const RobotFrame& frame, Colouring colouring) const override
  {
    std::vector<Surface> surfaces = { abdomen(frame.parts.front()) };
    for (size_t part = 1; part < frame.parts.size(); ++part)
    {
      Surface leg = placed(leg_, frame.parts[part].position, frame.parts[part].orientation);
      leg.colours.assign(leg.corners.size(), colourOf(frame, part, colouring));
      surfaces.push_back(std::move(leg));
    }
    return surfaces;
  }

  std::vector<std::array<Eigen::Vector3d, 2>> edges(const RobotFrame& /*frame*/) const override { return {}; }

  Colour colourOf(const RobotFrame& frame, size_t part, Colouring colouring) const override
  {
    if (part == 0)
    {
      return LIGHT_STRIPE;
    }
    const ShownPart& leg = frame.parts[part];
    const auto drawn_out = [&](double length) { return (length - settings_.leg_residual) / range(); };
    return colourOfPart(leg, colouring, drawn_out(leg.resting_length), drawn_out(leg.present_length),
                        0.5 * leg.remaining_development / range() + 0.5);
  }

  ColourBar colourBar(Colouring colouring) const override
  {
    const std::string low = fixedText(100 * settings_.leg_residual, 0) + " cm";
    const std::string high = fixedText(100 * (settings_.leg_residual + settings_.leg_range), 0) + " cm";
    const std::string range = fixedText(100 * settings_.leg_range, 0) + " cm";
    switch (colouring)
    {
      case Colouring::RESTING_LENGTH:
        return { "length that legs seek", low, high };
      case Colouring::PRESENT_LENGTH:
        return { "present length of legs", low, high };
      case Colouring::REMAINING_DEVELOPMENT:
        return { "development to come", "\u2212" + range, "+" + range };
      case Colouring::PHASE:
        break;
    }
    return { "phase of swing", "\u2212\u00bd cycle", "+\u00bd cycle" };
  }

  std::vector<size_t> measuredParts() const override { return { 1, 2, 3, 4 }; }
  std::string partName(size_t part) const override
  {
    return part == 0 ? "the abdomen" : "leg " + toText(static_cast<int64_t>(part));
  }
  double actuationFrequency() const override { return settings_.generator_frequency; }

private:
  /// Not 0, so that legs that cannot change have a colour too.
  double range() const { return std::max(settings_.leg_range, 1e-9); }

  static Surface placed(const Solid& solid, const Eigen::Vector3d& place, const Eigen::Quaterniond& orientation)
  {
    Surface surface;
    const Eigen::Matrix3d turn = orientation.toRotationMatrix();
    for (size_t i = 0; i < solid.corners.size(); ++i)
    {
      surface.corners.emplace_back(place + turn * solid.corners[i]);
      surface.normals.emplace_back(turn * solid.normals[i]);
    }
    return surface;
  }

  Surface abdomen(const ShownPart& part) const
  {
    // The solid's axis, z, becomes the lateral axis, x.
    const Eigen::Quaterniond to_lateral =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX());
    Surface surface = placed(abdomen_, part.position, part.orientation * to_lateral);
    const size_t in_stripe = surface.corners.size() / ABDOMEN_SECTORS * SECTORS_PER_STRIPE;
    for (size_t corner = 0; corner < surface.corners.size(); ++corner)
    {
      surface.colours.push_back(corner / in_stripe % 2 == 0 ? LIGHT_STRIPE : DARK_STRIPE);
    }
    return surface;
  }

  const RigidBodySettings settings_;
  const Solid abdomen_, leg_;
};
}  // namespace

std::shared_ptr<const Appearance> makeQuadrupedAppearance(const RigidBodySettings& settings)
{
  return std::make_shared<QuadrupedAppearance>(settings);
}
}  // namespace devo_evo
