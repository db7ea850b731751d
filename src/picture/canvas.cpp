#include "picture/canvas.h"

#include <cairo.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace devo_evo
{
namespace
{
constexpr double PI = 3.14159265358979323846;
constexpr const char* FONT = "DejaVu Sans";

cairo_status_t writeToFile(void* file, const unsigned char* data, unsigned int length)
{
  const bool written = std::fwrite(data, 1, length, static_cast<std::FILE*>(file)) == length;
  return written ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

void addPath(cairo_t* context, const std::vector<PicturePoint>& points)
{
  cairo_new_path(context);
  for (const auto& [x, y] : points)
  {
    cairo_line_to(context, x, y);
  }
}
}  // namespace

void Canvas::Release::operator()(cairo_surface_t* surface) const
{
  cairo_surface_destroy(surface);
}

void Canvas::Release::operator()(cairo_t* context) const
{
  cairo_destroy(context);
}

Canvas::Canvas(Image& image)
  : surface_(cairo_image_surface_create_for_data(image.data(), CAIRO_FORMAT_RGB24, image.width(), image.height(),
                                                 4 * image.width()))
  , context_(cairo_create(surface_.get()))
{
  if (cairo_status(context_.get()) != CAIRO_STATUS_SUCCESS)
  {
    throw PictureError(std::string("Cairo cannot draw: ") + cairo_status_to_string(cairo_status(context_.get())));
  }
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
}

Canvas::~Canvas()
{
  cairo_surface_flush(surface_.get());
}

void Canvas::setInk(const Ink& ink) const
{
  cairo_set_source_rgba(context_.get(), ink.red, ink.green, ink.blue, ink.opacity);
}

void Canvas::setFont(double size, bool bold) const
{
  cairo_select_font_face(context_.get(), FONT, CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), size);
}

void Canvas::fillRectangle(double x, double y, double width, double height, const Ink& ink, double corner_radius)
{
  const double r = corner_radius;
  cairo_t* context = context_.get();
  cairo_new_path(context);
  if (r > 0.0)
  {
    cairo_arc(context, x + width - r, y + r, r, -PI / 2, 0);
    cairo_arc(context, x + width - r, y + height - r, r, 0, PI / 2);
    cairo_arc(context, x + r, y + height - r, r, PI / 2, PI);
    cairo_arc(context, x + r, y + r, r, PI, 3 * PI / 2);
    cairo_close_path(context);
  }
  else
  {
    cairo_rectangle(context, x, y, width, height);
  }
  setInk(ink);
  cairo_fill(context);
}

void Canvas::fillCircle(const PicturePoint& center, double radius, const Ink& ink)
{
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), center.first, center.second, radius, 0, 2 * PI);
  setInk(ink);
  cairo_fill(context_.get());
}

void Canvas::fillPolygon(const std::vector<PicturePoint>& corners, const Ink& ink)
{
  addPath(context_.get(), corners);
  setInk(ink);
  cairo_fill(context_.get());
}

void Canvas::strokeCircle(const PicturePoint& center, double radius, const Ink& ink, double line_width)
{
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), center.first, center.second, radius, 0, 2 * PI);
  setInk(ink);
  cairo_set_line_width(context_.get(), line_width);
  cairo_stroke(context_.get());
}

void Canvas::strokeLine(const std::vector<PicturePoint>& points, const Ink& ink, double line_width)
{
  addPath(context_.get(), points);
  setInk(ink);
  cairo_set_line_width(context_.get(), line_width);
  cairo_stroke(context_.get());
}

void Canvas::drawArrow(const PicturePoint& from, const PicturePoint& to, const Ink& ink, double line_width)
{
  const double dx = to.first - from.first, dy = to.second - from.second;
  const double length = std::sqrt(dx * dx + dy * dy);
  if (length < line_width)
  {
    fillCircle(from, line_width, ink);
    return;
  }
  const double head = std::min(4.0 * line_width, length), half_width = 0.45 * head;
  const double ux = dx / length, uy = dy / length;
  const PicturePoint neck{ to.first - head * ux, to.second - head * uy };
  strokeLine({ from, neck }, ink, line_width);
  fillPolygon({ to,
                { neck.first - half_width * uy, neck.second + half_width * ux },
                { neck.first + half_width * uy, neck.second - half_width * ux } },
              ink);
}

double Canvas::textWidth(const std::string& text, double size, bool bold) const
{
  setFont(size, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), text.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::drawText(double x, double y, const std::string& text, double size, const Ink& ink, Anchor anchor,
                      bool bold)
{
  const double width = anchor == Anchor::LEFT ? 0.0 : textWidth(text, size, bold);
  setFont(size, bold);
  setInk(ink);
  cairo_move_to(context_.get(), anchor == Anchor::CENTER ? x - width / 2 : x - width, y);
  cairo_show_text(context_.get(), text.c_str());
}

void Canvas::drawTextUpwards(double x, double y, const std::string& text, double size, const Ink& ink)
{
  cairo_save(context_.get());
  cairo_translate(context_.get(), x, y);
  cairo_rotate(context_.get(), -PI / 2);
  drawText(0.0, 0.0, text, size, ink, Anchor::CENTER);
  cairo_restore(context_.get());
}

void Canvas::fillWithGradient(double x, double y, double width, double height, const std::vector<Ink>& inks)
{
  const std::unique_ptr<cairo_pattern_t, decltype(&cairo_pattern_destroy)> pattern(
      cairo_pattern_create_linear(x, 0, x + width, 0), &cairo_pattern_destroy);
  for (size_t i = 0; i < inks.size(); ++i)
  {
    const double offset = static_cast<double>(i) / static_cast<double>(inks.size() - 1);
    cairo_pattern_add_color_stop_rgba(pattern.get(), offset, inks[i].red, inks[i].green, inks[i].blue, inks[i].opacity);
  }
  cairo_new_path(context_.get());
  cairo_rectangle(context_.get(), x, y, width, height);
  cairo_set_source(context_.get(), pattern.get());
  cairo_fill(context_.get());
}

void Canvas::writePng(const std::string& path) const
{
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr)
  {
    throw PictureError(path + ": it cannot be written: " + std::strerror(errno));
  }
  cairo_surface_flush(surface_.get());
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), writeToFile, file);
  const bool closed = std::fclose(file) == 0;
  if (status != CAIRO_STATUS_SUCCESS || !closed)
  {
    const std::string reason = status == CAIRO_STATUS_SUCCESS || status == CAIRO_STATUS_WRITE_ERROR
                                   ? std::strerror(errno)
                                   : cairo_status_to_string(status);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored))  // a device stays
    {
      std::filesystem::remove(path, ignored);
    }
    throw PictureError(path + ": it cannot be written: " + reason);
  }
}
}  // namespace devo_evo
