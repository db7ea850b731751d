#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace devo_evo
{
/// Thrown when a picture or a film cannot be made or written; says which, why, and what would help.
class PictureError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A picture of opaque pixels, rows from top to bottom.
class Image
{
public:
  /// Black. @throw InvalidInput unless both sides are within 1 to MAXIMUM_SIDE.
  Image(int width, int height);

  static constexpr int MAXIMUM_SIDE = 8192;  ///< [pixels]

  int width() const { return width_; }
  int height() const { return height_; }

  /// Bytes blue, green, red, unused of each pixel, without gaps between rows (ffmpeg's "bgr0").
  uint8_t* data() { return pixels_.data(); }
  const uint8_t* data() const { return pixels_.data(); }
  size_t byteCount() const { return pixels_.size(); }

  /// Red, green and blue of a pixel, 0 to 255; x to the right, y down.
  std::array<int, 3> rgb(int x, int y) const;

  /// Copies another picture into this one, its upper left corner at (x, y); what does not fit is left out.
  void place(const Image& picture, int x, int y);

  /// Whether all pixels have one colour: what a renderer that failed silently leaves behind.
  bool isBlank() const;

  /// @throw PictureError if the file cannot be written, or if the picture is blank.
  void writePng(const std::string& path) const;

private:
  int width_, height_;
  std::vector<uint8_t> pixels_;
};
}  // namespace devo_evo
