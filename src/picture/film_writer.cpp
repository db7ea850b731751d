#include "devo_evo/picture/film_writer.h"

#include "devo_evo/soft_body/settings.h"
#include "devo_evo/soft_body/text.h"
#include "picture/child_process.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

namespace devo_evo
{
namespace
{
namespace fs = std::filesystem;

/// How ffmpeg is asked to encode what it gets.
struct FilmFormat
{
  const char* suffix;
  std::vector<std::string> options;
};

const std::vector<FilmFormat>& filmFormats()
{
  static const std::vector<FilmFormat> formats = {
    { ".mp4",
      { "-c:v", "libx264", "-preset", "veryfast", "-crf", "19", "-pix_fmt", "yuv420p", "-vf",
        "crop=trunc(iw/2)*2:trunc(ih/2)*2", "-movflags", "+faststart", "-f", "mp4" } },
    { ".gif",
      { "-vf", "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=5", "-loop", "0",
        "-f", "gif" } },
    { ".webp", { "-c:v", "libwebp_anim", "-quality", "72", "-compression_level", "3", "-loop", "0", "-f", "webp" } },
  };
  return formats;
}

const FilmFormat* formatOf(const std::string& path)
{
  const std::string suffix = fs::path(path).extension().string();
  for (const FilmFormat& format : filmFormats())
  {
    if (suffix == format.suffix)
    {
      return &format;
    }
  }
  return nullptr;
}

bool namesFolder(const std::string& path)
{
  return !path.empty() && path.back() == '/';
}

void checkSize(const Image& picture, int width, int height)
{
  if (picture.width() != width || picture.height() != height)
  {
    throw InvalidInput("a picture of " + toText(picture.width()) + " x " + toText(picture.height()) +
                       " pixels in a film of " + toText(width) + " x " + toText(height));
  }
}

/// Encodes by ffmpeg into a file beside the film, which becomes the film at the end.
class EncodedFilm : public FilmWriter
{
public:
  EncodedFilm(const std::string& path, const FilmFormat& format, int width, int height, int pictures_per_s)
    : path_(path)
    , partial_(path + ".partial")
    , width_(width)
    , height_(height)
    , ffmpeg_("ffmpeg",
              [&]
              {
                std::vector<std::string> arguments = { "-hide_banner", "-loglevel",
                                                       "error",        "-y",
                                                       "-f",           "rawvideo",
                                                       "-pix_fmt",     "bgr0",
                                                       "-s",           toText(width) + "x" + toText(height),
                                                       "-framerate",   toText(pictures_per_s),
                                                       "-i",           "-" };
                arguments.insert(arguments.end(), format.options.begin(), format.options.end());
                arguments.push_back("file:" + partial_);
                return arguments;
              }())
  {
  }

  ~EncodedFilm() override
  {
    ffmpeg_.kill();
    std::error_code ignored;
    fs::remove(partial_, ignored);
  }

  void add(const Image& picture) override
  {
    checkSize(picture, width_, height_);
    if (!ffmpeg_.write(picture.data(), picture.byteCount()))
    {
      ffmpeg_.finish();
      throw PictureError(path_ + ": ffmpeg gave up: " + ffmpeg_.complaints());
    }
  }

  void finish() override
  {
    const int status = ffmpeg_.finish();
    if (status != 0)
    {
      throw PictureError(path_ + ": ffmpeg failed with status " + toText(status) + ": " + ffmpeg_.complaints());
    }
    fs::rename(partial_, path_);
  }

private:
  const std::string path_, partial_;
  const int width_, height_;
  ChildProcess ffmpeg_;
};

/// 00000.png, 00001.png, … in a folder.
class NumberedPictures : public FilmWriter
{
public:
  NumberedPictures(const std::string& folder, int width, int height) : folder_(folder), width_(width), height_(height)
  {
  }

  void add(const Image& picture) override
  {
    checkSize(picture, width_, height_);
    const std::string number = toText(count_++);
    picture.writePng(folder_ + std::string(number.size() < 5 ? 5 - number.size() : 0, '0') + number + ".png");
  }

  void finish() override {}

private:
  const std::string folder_;
  const int width_, height_;
  int count_ = 0;
};

/// @throw PictureError unless a file can be made in this folder.
void checkWritable(const fs::path& folder)
{
  const fs::path place = folder.empty() ? fs::path(".") : folder;
  if (!canWriteInto(place.string()))
  {
    throw PictureError("nothing can be written to the folder " + place.string() + ": " + std::strerror(errno));
  }
}
}  // namespace

bool isFilmPath(const std::string& path)
{
  return namesFolder(path) || formatOf(path) != nullptr;
}

std::unique_ptr<FilmWriter> makeFilmWriter(const std::string& path, int width, int height, int pictures_per_s)
{
  if (namesFolder(path))
  {
    std::error_code error;
    fs::create_directories(path, error);
    if (error)
    {
      throw PictureError(path + ": the folder cannot be made: " + error.message());
    }
    checkWritable(path);
    return std::make_unique<NumberedPictures>(path, width, height);
  }
  const FilmFormat* format = formatOf(path);
  if (format == nullptr)
  {
    throw InvalidInput(path +
                       ": a film ends in .mp4, .gif or .webp, or is a folder of PNG files, with a slash at its end");
  }
  checkWritable(fs::path(path).parent_path());
  if (!isInstalled("ffmpeg"))
  {
    throw PictureError(path +
                       ": the program ffmpeg, which makes films, is not installed (Debian: apt-get install ffmpeg). "
                       "PNG files need none: give a folder, such as " +
                       fs::path(path).stem().string() + "/");
  }
  return std::make_unique<EncodedFilm>(path, *format, width, height, pictures_per_s);
}
}  // namespace devo_evo
