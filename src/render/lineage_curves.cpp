#include "devo_evo/render/lineage_curves.h"

#include "devo_evo/experiment/report_text.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
LineageCurves lineageCurves(const Body& body)
{
  return { {
      { "fitness [" + body.fitnessUnit() + "]",
        { 0.84, 0.30, 0.16 },
        [](const ArchivedIndividual& a)
        { return a.individual.evaluation && a.individual.evaluation->valid ? a.individual.evaluation->fitness : NAN; },
        0.0 },
      { "W_L: how much the body develops",
        { 0.11, 0.55, 0.42 },
        [](const ArchivedIndividual& a) { return a.morphology_window; },
        0.5 },
      { "W_\u03a6: how much the control develops",
        { 0.33, 0.40, 0.68 },
        [](const ArchivedIndividual& a) { return a.control_window; },
        0.5 },
  } };
}

AxisRange rangeOf(const LineageCurve& curve, const std::vector<ArchivedIndividual>& lineage)
{
  AxisRange range{ 0.0, curve.least_high };
  for (const ArchivedIndividual& individual : lineage)
  {
    const double value = curve.value(individual);
    range.low = std::isfinite(value) ? std::min(range.low, value) : range.low;
    range.high = std::isfinite(value) ? std::max(range.high, value) : range.high;
  }
  range.high *= 1.05;
  return range.high > range.low ? range : AxisRange{ range.low, range.low + 1.0 };
}

AxisRange generationsOf(const std::vector<ArchivedIndividual>& lineage)
{
  const auto first = static_cast<double>(lineage.front().individual.generation);
  return { first, std::max(static_cast<double>(lineage.back().individual.generation), first + 1.0) };
}

std::vector<AxisTick> roundTicks(const AxisRange& range, int count)
{
  const double raw = (range.high - range.low) / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double step = (raw / power < 1.5 ? 1.0 : raw / power < 3.5 ? 2.0 : raw / power < 7.5 ? 5.0 : 10.0) * power;
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::vector<AxisTick> ticks;
  for (double k = std::ceil(range.low / step - 1e-9); k * step <= range.high + 1e-9 * step; ++k)
  {
    const double value = k * step + 0.0;  // not -0
    ticks.push_back({ value, fixedText(value, decimals) });
  }
  return ticks;
}
}  // namespace devo_evo
