#include "devo_evo/picture/film_writer.h"

#include "archive/test_tools.h"
#include "devo_evo/soft_body/settings.h"
#include "picture/canvas.h"
#include "picture/child_process.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace devo_evo
{
namespace
{
using test::messageOf;
using test::TemporaryFolder;

constexpr int WIDTH = 64, HEIGHT = 48;

Image pictureAt(int step)
{
  Image image(WIDTH, HEIGHT);
  Canvas(image).fillRectangle(4 * step, 10, 20, 20, { 1, 0.5, 0, 1 });
  return image;
}

/// Takes PATH away for as long as it lives.
class NoPath
{
public:
  NoPath() : path_(std::getenv("PATH")) { setenv("PATH", "/nowhere", 1); }
  ~NoPath() { setenv("PATH", path_.c_str(), 1); }

private:
  const std::string path_;
};

TEST(FilmWriter, KnowsFilmsByTheirPaths)
{
  for (const char* path : { "a.mp4", "b/a.gif", "a.webp", "pictures/" })
  {
    EXPECT_TRUE(isFilmPath(path)) << path;
  }
  for (const char* path : { "a.png", "a", "a.avi", "" })
  {
    EXPECT_FALSE(isFilmPath(path)) << path;
    EXPECT_THROW(makeFilmWriter(path, WIDTH, HEIGHT, 25), InvalidInput) << path;
  }
}

TEST(FilmWriter, WritesFilmsOfEveryKind)
{
  const TemporaryFolder folder;
  for (const char* name : { "film.mp4", "film.gif", "film.webp" })
  {
    const std::string path = folder.path() + "/" + name;
    const auto film = makeFilmWriter(path, WIDTH, HEIGHT, 10);
    for (int step = 0; step < 5; ++step)
    {
      film->add(pictureAt(step));
    }
    EXPECT_FALSE(std::filesystem::exists(path)) << "before it is finished there is no film";
    film->finish();
    EXPECT_GT(std::filesystem::file_size(path), 300u) << name;
    EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
  }
}

TEST(FilmWriter, LeavesNothingOfAnUnfinishedFilm)
{
  const TemporaryFolder folder;
  makeFilmWriter(folder.path() + "/film.mp4", WIDTH, HEIGHT, 10)->add(pictureAt(1));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FilmWriter, WritesNumberedPicturesWithoutFfmpeg)
{
  const TemporaryFolder folder;
  const NoPath no_path;
  const auto film = makeFilmWriter(folder.path() + "/pictures/", WIDTH, HEIGHT, 10);
  film->add(pictureAt(0));
  film->add(pictureAt(1));
  film->finish();
  EXPECT_TRUE(std::filesystem::exists(folder.path() + "/pictures/00000.png"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() + "/pictures/00001.png"));
}

TEST(FilmWriter, SaysWhatToDoWithoutFfmpeg)
{
  const TemporaryFolder folder;
  const NoPath no_path;
  const std::string message =
      messageOf<PictureError>([&] { makeFilmWriter(folder.path() + "/film.mp4", WIDTH, HEIGHT, 10); });
  EXPECT_NE(message.find("ffmpeg"), std::string::npos) << message;
  EXPECT_NE(message.find("PNG files need none"), std::string::npos) << message;
}

TEST(FilmWriter, RefusesAPlaceThatIsNotThere)
{
  EXPECT_NE(messageOf<PictureError>([] { makeFilmWriter("/nowhere/film.mp4", WIDTH, HEIGHT, 10); }).find("/nowhere"),
            std::string::npos);
  EXPECT_NE(
      messageOf<PictureError>([] { makeFilmWriter("/proc/pictures/", WIDTH, HEIGHT, 10); }).find("/proc/pictures/"),
      std::string::npos);
}

TEST(FilmWriter, RefusesAPictureOfAnotherSize)
{
  const TemporaryFolder folder;
  const auto film = makeFilmWriter(folder.path() + "/film.mp4", WIDTH, HEIGHT, 10);
  EXPECT_THROW(film->add(Image(WIDTH, HEIGHT + 1)), InvalidInput);
}

TEST(ChildProcess, TellsWhatAProgramComplainsOf)
{
  ChildProcess process("sh", { "-c", "cat > /dev/null; echo too bad >&2; exit 3" });
  EXPECT_TRUE(process.write("abc", 3));
  EXPECT_EQ(process.finish(), 3);
  EXPECT_EQ(process.complaints(), "too bad\n");
}

TEST(ChildProcess, NoticesThatAProgramIsGone)
{
  ChildProcess process("true", {});
  const std::string much(1 << 20, 'x');
  bool written = true;
  for (int i = 0; written && i < 100; ++i)
  {
    written = process.write(much.data(), much.size());
  }
  EXPECT_FALSE(written);
}

TEST(ChildProcess, RefusesAProgramThatIsNotThere)
{
  EXPECT_THROW(ChildProcess("no-such-program", {}), PictureError);
}
}  // namespace
}  // namespace devo_evo
