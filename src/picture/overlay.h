#pragma once

#include "devo_evo/picture/life_scene.h"
#include "picture/canvas.h"

namespace devo_evo
{
// What is written and drawn over a picture.

namespace inks
{
constexpr Ink DARK{ 0.13, 0.14, 0.16, 1.0 };
constexpr Ink GREY{ 0.42, 0.43, 0.46, 1.0 };
constexpr Ink LIGHT{ 0.80, 0.80, 0.81, 1.0 };
constexpr Ink PATH{ 0.16, 0.36, 0.55, 1.0 };
constexpr Ink VELOCITY{ 0.84, 0.30, 0.16, 1.0 };
constexpr Ink PAPER{ 1.0, 1.0, 1.0, 0.82 };
}  // namespace inks

/// Distances from the birthplace beside the lines of the floor.
void drawFloorMarks(Canvas& canvas, const Image& image, const std::vector<FloorMark>& marks, const Camera& camera);

/// Name and description at the upper left, instruments along the lower edge: time, distance, velocity over life.
void drawReadings(Canvas& canvas, const Image& image, const Readings& readings);

/// What the colours mean. @param right end of the scale, its upper edge at y. @param scale 1 for a picture 720 pixels
/// high.
void drawColourLegend(Canvas& canvas, double right, double y, double scale, Colouring colouring, const ColourBar& bar);

/// The same at the upper right of a picture.
void drawColourLegend(Canvas& canvas, const Image& image, Colouring colouring, const ColourBar& bar);
}  // namespace devo_evo
