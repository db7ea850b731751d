#include "devo_evo/picture/image.h"

#include "archive/test_tools.h"
#include "devo_evo/soft_body/settings.h"
#include "picture/canvas.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace devo_evo
{
namespace
{
using test::messageOf;
using test::TemporaryFolder;

TEST(Image, RefusesSidesThatAreNoPicture)
{
  EXPECT_THROW(Image(0, 10), InvalidInput);
  EXPECT_THROW(Image(10, -1), InvalidInput);
  EXPECT_THROW(Image(Image::MAXIMUM_SIDE + 1, 10), InvalidInput);
}

TEST(Image, PlacesAPictureAndCutsWhatDoesNotFit)
{
  Image ground(4, 3), patch(2, 2);
  Canvas(patch).fillRectangle(0, 0, 2, 2, { 1, 0, 0, 1 });
  ground.place(patch, 3, 2);
  ground.place(patch, -1, -1);
  const std::array<int, 3> red = { 255, 0, 0 }, black = { 0, 0, 0 };
  EXPECT_EQ(ground.rgb(3, 2), red);
  EXPECT_EQ(ground.rgb(2, 2), black);
  EXPECT_EQ(ground.rgb(0, 0), red);
  EXPECT_EQ(ground.rgb(1, 1), black);
}

TEST(Image, WritesPng)
{
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/picture.png";
  Image image(20, 10);
  Canvas(image).fillRectangle(5, 5, 10, 5, { 0, 0.5, 1, 1 });
  image.writePng(path);
  std::ifstream file(path, std::ios::binary);
  char start[8];
  file.read(start, sizeof start);
  EXPECT_EQ(std::string(start, 8), "\x89PNG\r\n\x1a\n");
}

TEST(Image, RefusesToWriteABlankOne)
{
  const TemporaryFolder folder;
  EXPECT_NE(messageOf<PictureError>([&] { Image(20, 10).writePng(folder.path() + "/black.png"); }).find("one colour"),
            std::string::npos);
  EXPECT_FALSE(std::ifstream(folder.path() + "/black.png").good());
}

TEST(Image, SaysWhyItCannotBeWritten)
{
  Image image(20, 10);
  Canvas(image).fillRectangle(5, 5, 10, 5, { 0, 0.5, 1, 1 });
  EXPECT_NE(messageOf<PictureError>([&] { image.writePng("/nowhere/picture.png"); }).find("No such file"),
            std::string::npos);
  EXPECT_NE(messageOf<PictureError>([&] { image.writePng("/dev/full"); }).find("No space left"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(Canvas, WritesTextThatTakesRoom)
{
  Image image(200, 40);
  Canvas canvas(image);
  canvas.fillRectangle(0, 0, 200, 40, { 1, 1, 1, 1 });
  const double width = canvas.textWidth("W_L 0.33", 20);
  EXPECT_GT(width, 60);
  EXPECT_LT(width, 130);
  canvas.drawText(10, 30, "W_L 0.33", 20, { 0, 0, 0, 1 });
  int dark = 0;
  for (int x = 10; x < 10 + static_cast<int>(width); ++x)
  {
    for (int y = 10; y < 35; ++y)
    {
      dark += image.rgb(x, y)[0] < 100 ? 1 : 0;
    }
  }
  EXPECT_GT(dark, 100);
  EXPECT_EQ(image.rgb(195, 20)[0], 255);
}
}  // namespace
}  // namespace devo_evo
