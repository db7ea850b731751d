#pragma once

#include "devo_evo/archive/archive.h"
#include "devo_evo/evolution/body.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace devo_evo
{
// What plots of a lineage show: fitness, W_L and W_Phi over the generation of birth.

/// One quantity along a lineage.
struct LineageCurve
{
  std::string title;                           ///< with its unit
  std::array<double, 3> colour;                ///< red, green, blue [1, 0 to 1]
  double (*value)(const ArchivedIndividual&);  ///< NaN if the individual has none
  double least_high;                           ///< the upper end of its axis is not below this
};

using LineageCurves = std::array<LineageCurve, 3>;

/// Fitness, in the unit that it has in this kind of body, W_L and W_Phi.
LineageCurves lineageCurves(const Body& body);

/// Ends of an axis.
struct AxisRange
{
  double low = 0.0, high = 1.0;
};

/// A range that shows all values of a curve, and zero; never empty.
AxisRange rangeOf(const LineageCurve& curve, const std::vector<ArchivedIndividual>& lineage);

/// Generations of birth from the first to the last of a lineage, at least one apart. @pre there is an individual.
AxisRange generationsOf(const std::vector<ArchivedIndividual>& lineage);

/// A round number on an axis, and how it is written there.
struct AxisTick
{
  double value;
  std::string text;
};

/// Round numbers that divide a range into about `count` parts. @pre the range is not empty.
std::vector<AxisTick> roundTicks(const AxisRange& range, int count);
}  // namespace devo_evo
