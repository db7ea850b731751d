#pragma once

#include "devo_evo/picture/image.h"

#include <memory>
#include <string>

namespace devo_evo
{
/// Takes the pictures of a film one by one.
class FilmWriter
{
public:
  virtual ~FilmWriter() = default;

  /// @throw PictureError if it cannot be written; InvalidInput if the picture has another size than the film.
  virtual void add(const Image& picture) = 0;

  /// To be called after the last picture: only then there is a film. @throw PictureError if it could not be written.
  virtual void finish() = 0;
};

/// A film for a path: "….mp4", "….gif" and "….webp" by the program ffmpeg; a folder, written with a slash at its end,
/// for numbered PNG files, which need no ffmpeg. A film that is not finished leaves nothing behind; finished pictures
/// stay.
/// @param pictures_per_s rate of the film.
/// @throw InvalidInput for any other path; PictureError if the place cannot be written to, or if ffmpeg is needed and
/// not installed: the message says how to have PNG files.
std::unique_ptr<FilmWriter> makeFilmWriter(const std::string& path, int width, int height, int pictures_per_s);

/// Whether makeFilmWriter() makes a film of this path, not a picture.
bool isFilmPath(const std::string& path);
}  // namespace devo_evo
