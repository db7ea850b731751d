#pragma once

#include "devo_evo/picture/lineage.h"
#include "picture/canvas.h"

#include <string>

namespace devo_evo
{
/// A rectangle with axes, from data to picture coordinates.
struct PlotArea
{
  double x, y, width, height;  ///< upper left corner and size [pixels]
  double x_from, x_to, y_from, y_to;

  PicturePoint at(double data_x, double data_y) const;
};

/// The axes of a plot: lines at the left and below, ticks with numbers, a title above.
void drawAxes(Canvas& canvas, const PlotArea& area, const std::string& title, const std::string& x_label, double scale);

/// Fitness, W_L and W_Phi along a lineage over the generation of birth, one below the other, the present individual
/// marked.
void drawLineageCurves(Canvas& canvas, const Lineage& lineage, size_t present, double x, double y, double width,
                       double height, double scale);
}  // namespace devo_evo
