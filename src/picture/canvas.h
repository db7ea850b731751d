#pragma once

#include "devo_evo/picture/image.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace devo_evo
{
/// Red, green, blue and opacity, 0 to 1.
struct Ink
{
  double red = 0.0, green = 0.0, blue = 0.0, opacity = 1.0;
};

/// Where a text is in relation to the point it is drawn at.
enum class Anchor
{
  LEFT,
  CENTER,
  RIGHT
};

/// A point of the picture: x to the right, y down [pixels].
using PicturePoint = std::pair<double, double>;

/// Draws lines, areas and text onto an image, smoothly (Cairo). The image must outlive it.
class Canvas
{
public:
  explicit Canvas(Image& image);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  void fillRectangle(double x, double y, double width, double height, const Ink& ink, double corner_radius = 0.0);
  void fillCircle(const PicturePoint& center, double radius, const Ink& ink);
  void fillPolygon(const std::vector<PicturePoint>& corners, const Ink& ink);
  void strokeCircle(const PicturePoint& center, double radius, const Ink& ink, double line_width);
  void strokeLine(const std::vector<PicturePoint>& points, const Ink& ink, double line_width);

  /// An arrow from one point to another; a dot if they are the same.
  void drawArrow(const PicturePoint& from, const PicturePoint& to, const Ink& ink, double line_width);

  /// @param y of the base line. @param size of the font [pixels].
  void drawText(double x, double y, const std::string& text, double size, const Ink& ink, Anchor anchor = Anchor::LEFT,
                bool bold = false);

  /// Upwards; (x, y) is the middle of the base line.
  void drawTextUpwards(double x, double y, const std::string& text, double size, const Ink& ink);

  /// Width of a text when drawn [pixels].
  double textWidth(const std::string& text, double size, bool bold = false) const;

  /// Colours from left to right within a rectangle. @param inks at equal distances, at least two.
  void fillWithGradient(double x, double y, double width, double height, const std::vector<Ink>& inks);

  /// @throw PictureError
  void writePng(const std::string& path) const;

private:
  void setFont(double size, bool bold) const;
  void setInk(const Ink& ink) const;

  struct Release
  {
    void operator()(cairo_surface_t* surface) const;
    void operator()(cairo_t* context) const;
  };
  std::unique_ptr<cairo_surface_t, Release> surface_;
  std::unique_ptr<cairo_t, Release> context_;
};
}  // namespace devo_evo
