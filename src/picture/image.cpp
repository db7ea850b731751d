#include "devo_evo/picture/image.h"

#include "devo_evo/soft_body/settings.h"
#include "devo_evo/soft_body/text.h"
#include "picture/canvas.h"

#include <algorithm>
#include <cstring>

namespace devo_evo
{
namespace
{
constexpr size_t BYTES = 4;  // of a pixel

size_t checkedByteCount(int width, int height)
{
  for (const int side : { width, height })
  {
    if (side < 1 || side > Image::MAXIMUM_SIDE)
    {
      throw InvalidInput("a picture of " + toText(width) + " x " + toText(height) +
                         " pixels: sides must be within 1 to " + toText(Image::MAXIMUM_SIDE));
    }
  }
  return BYTES * static_cast<size_t>(width) * static_cast<size_t>(height);
}
}  // namespace

Image::Image(int width, int height) : width_(width), height_(height), pixels_(checkedByteCount(width, height), 0)
{
}

std::array<int, 3> Image::rgb(int x, int y) const
{
  const uint8_t* pixel =
      pixels_.data() + BYTES * (static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x));
  return { pixel[2], pixel[1], pixel[0] };
}

void Image::place(const Image& picture, int x, int y)
{
  const int first_column = std::max(0, -x), columns = std::min(picture.width_, width_ - x) - first_column;
  const int first_row = std::max(0, -y), last_row = std::min(picture.height_, height_ - y);
  for (int row = first_row; row < last_row && columns > 0; ++row)
  {
    const size_t from =
        static_cast<size_t>(row) * static_cast<size_t>(picture.width_) + static_cast<size_t>(first_column);
    const size_t to =
        static_cast<size_t>(y + row) * static_cast<size_t>(width_) + static_cast<size_t>(x + first_column);
    std::memcpy(pixels_.data() + BYTES * to, picture.pixels_.data() + BYTES * from,
                BYTES * static_cast<size_t>(columns));
  }
}

bool Image::isBlank() const
{
  const std::array<int, 3> first = rgb(0, 0);
  for (int y = 0; y < height_; ++y)
  {
    for (int x = 0; x < width_; ++x)
    {
      if (rgb(x, y) != first)
      {
        return false;
      }
    }
  }
  return true;
}

void Image::writePng(const std::string& path) const
{
  if (isBlank())
  {
    throw PictureError(path + ": the picture is of one colour throughout: the renderer failed; nothing was written");
  }
  Image copy = *this;  // Cairo wants to write to what it reads
  Canvas(copy).writePng(path);
}
}  // namespace devo_evo
