#include "devo_evo/picture/scene_painter.h"

#include "devo_evo/picture/robot_scene.h"
#include "devo_evo/soft_body/settings.h"
#include "render/frames.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>

namespace devo_evo
{
namespace
{
constexpr int WIDTH = 320, HEIGHT = 240;
constexpr double PIXELS_PER_METRE = HEIGHT / 0.12;

/// Looks along -x at a wall 0.16 m wide and 0.12 m high; its middle is (0, 0, 0.04).
Camera sideView()
{
  Camera camera;
  camera.field_of_view = 0.0;
  camera.height = 0.12;
  camera.elevation = 0.0;
  camera.distance = 1.0;
  camera.target = { 0.0, 0.0, 0.04 };
  return camera;
}

/// Looks down on the floor.
Camera topView()
{
  Camera camera = sideView();
  camera.elevation = 1.5;
  camera.target = { 0.0, 0.0, 0.0 };
  return camera;
}

/// A body of one voxel, 0.04 m long, resting on the floor above the origin.
ColouredTriangles block(const Eigen::Vector3f& colour, const Eigen::Vector3f& center = { 0.0f, 0.0f, 0.02f })
{
  SoftBodySettings settings = bodyOf(1, 1, 1);
  settings.voxel_size = 0.04;
  ColouredTriangles triangles =
      robotTriangles(*makeAppearance(BodySettings(settings)), restingFrame(settings), Colouring::RESTING_LENGTH)
          .front();
  for (Eigen::Vector3f& corner : triangles.corners)
  {
    corner += center - Eigen::Vector3f::Constant(0.02f);
  }
  std::fill(triangles.colours.begin(), triangles.colours.end(), colour);
  return triangles;
}

struct Silhouette
{
  int area = 0;
  double x = 0.0, y = 0.0;  ///< centroid [pixels]
};

/// Of all pixels much more red than blue.
Silhouette redPart(const Image& image)
{
  Silhouette part;
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      const auto [red, green, blue] = image.rgb(x, y);
      if (red > green + 25 && red > blue + 25)
      {
        ++part.area;
        part.x += x + 0.5;
        part.y += y + 0.5;
      }
    }
  }
  part.x /= part.area;
  part.y /= part.area;
  return part;
}

int brightnessAt(const Image& image, const Camera& camera, const Eigen::Vector3d& place)
{
  const Eigen::Vector2d pixel = camera.toPicture(place, image.width(), image.height());
  const auto [red, green, blue] = image.rgb(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
  return red + green + blue;
}

const Eigen::Vector3f RED(1.0f, 0.0f, 0.0f);

TEST(ScenePainter, DrawsASilhouetteOfTheRightSizeInTheRightPlace)
{
  Scene scene;
  scene.bodies = { block(RED) };
  const Silhouette part = redPart(ScenePainter(WIDTH, HEIGHT).paint(scene, sideView()));
  const double side = 0.04 * PIXELS_PER_METRE;  // 80 pixels; the dark outline takes up to two at each edge
  EXPECT_NEAR(part.area, side * side, 4 * 2 * side);
  EXPECT_NEAR(part.x, WIDTH / 2, 1.0);
  EXPECT_NEAR(part.y, HEIGHT / 2 + 0.02 * PIXELS_PER_METRE, 1.0);
}

TEST(ScenePainter, ShowsTravelAlongYToTheRightAndHeightUpwards)
{
  Scene scene;
  scene.bodies = { block(RED, { 0.0f, 0.03f, 0.05f }) };
  const Silhouette part = redPart(ScenePainter(WIDTH, HEIGHT).paint(scene, sideView()));
  EXPECT_NEAR(part.x, WIDTH / 2 + 0.03 * PIXELS_PER_METRE, 1.0);
  EXPECT_NEAR(part.y, HEIGHT / 2 - 0.01 * PIXELS_PER_METRE, 1.0);
}

TEST(ScenePainter, HidesWhatIsBehind)
{
  Scene scene;
  scene.bodies = { block(RED), block({ 0.0f, 0.0f, 1.0f }, { 0.05f, 0.0f, 0.02f }) };  // nearer to the camera
  EXPECT_EQ(redPart(ScenePainter(WIDTH, HEIGHT).paint(scene, sideView())).area, 0);
}

TEST(ScenePainter, LightsTheTopMoreThanTheSides)
{
  Scene scene;
  scene.bodies = { block(RED) };
  Camera camera = sideView();
  camera.elevation = 0.6;
  const Image image = ScenePainter(WIDTH, HEIGHT).paint(scene, camera);
  EXPECT_GT(brightnessAt(image, camera, { 0.0, 0.0, 0.04 }), brightnessAt(image, camera, { 0.02, 0.0, 0.02 }) + 20);
}

TEST(ScenePainter, DrawsFloorLinesWhereTheyAre)
{
  Scene scene;
  scene.bodies = { block(RED, { 0.0f, 0.0f, 0.02f }) };
  scene.floor.line_distance = 0.04f;
  scene.floor.line_origin = { 0.01f, 0.01f };
  const Camera camera = topView();
  const Image image = ScenePainter(WIDTH, HEIGHT).paint(scene, camera);
  const int line = brightnessAt(image, camera, { 0.04, 0.05, 0.0 });     // y = 0.01 + 0.04
  const int between = brightnessAt(image, camera, { 0.04, 0.07, 0.0 });  // half-way to the next
  EXPECT_LT(line, between - 40);
}

TEST(ScenePainter, CastsAShadowAwayFromTheLight)
{
  Scene scene;
  scene.floor.lines = false;
  scene.bodies = { block(RED) };
  const Camera camera = topView();
  const Image image = ScenePainter(WIDTH, HEIGHT).paint(scene, camera);
  const int lit = brightnessAt(image, camera, { 0.0, 0.06, 0.0 });  // the lamp is at +x, +y and above
  EXPECT_LT(brightnessAt(image, camera, { -0.029, -0.01, 0.0 }), lit - 60);
  EXPECT_LT(brightnessAt(image, camera, { 0.0, 0.0225, 0.0 }), lit) << "where body and floor touch, it is darker";
}

TEST(ScenePainter, DrawsLinesOnTheFloorInTheirColour)
{
  Scene scene;
  FloorLine line;
  line.points = { { 0.0f, -0.05f }, { 0.0f, 0.05f } };
  line.width = 0.01f;
  line.colour = RED;
  scene.floor.lines = false;
  scene.floor_lines = { line };
  const Silhouette part = redPart(ScenePainter(WIDTH, HEIGHT).paint(scene, topView()));
  EXPECT_NEAR(part.area, 0.01 * 0.1 * PIXELS_PER_METRE * PIXELS_PER_METRE, 450);
  EXPECT_NEAR(part.x, WIDTH / 2, 1.0);
}

/// Two triangles that face the camera of sideView(), 0.04 m wide and high, 0.02 m above the floor.
ColouredTriangles plate(const Eigen::Vector3f& normal)
{
  ColouredTriangles plate;
  const Eigen::Vector3f a(0.0f, -0.02f, 0.02f), b(0.0f, 0.02f, 0.02f), c(0.0f, 0.02f, 0.06f), d(0.0f, -0.02f, 0.06f);
  plate.corners = { a, b, c, a, c, d };
  plate.colours.assign(6, RED);
  plate.normals.assign(6, normal);
  return plate;
}

TEST(ScenePainter, ShadesSmoothSurfacesByTheirNormalsAndWithoutOutlines)
{
  Scene scene;
  scene.bodies = { plate({ 1.0f, 0.0f, 0.0f }) };
  ScenePainter painter(WIDTH, HEIGHT);
  const Image facing = painter.paint(scene, sideView());
  const double side = 0.04 * PIXELS_PER_METRE;
  EXPECT_NEAR(redPart(facing).area, side * side, 2 * side) << "up to its edge";
  scene.bodies = { plate({ 0.0f, -1.0f, 0.0f }) };
  const Image averted = painter.paint(scene, sideView());
  const Eigen::Vector3d middle(0.0, 0.0, 0.04);
  EXPECT_GT(brightnessAt(facing, sideView(), middle), brightnessAt(averted, sideView(), middle) + 20);
}

TEST(ScenePainter, DrawsSceneryWithoutShadow)
{
  Scene with_body, with_scenery;
  with_body.floor.lines = with_scenery.floor.lines = false;
  with_body.bodies = { block(RED) };
  with_scenery.scenery = { block(RED) };
  ScenePainter painter(WIDTH, HEIGHT);
  const Image body = painter.paint(with_body, topView()), scenery = painter.paint(with_scenery, topView());
  EXPECT_EQ(redPart(body).area, redPart(scenery).area);
  const Eigen::Vector3d shadow(-0.029, -0.01, 0.0);
  EXPECT_LT(brightnessAt(body, topView(), shadow), brightnessAt(scenery, topView(), shadow) - 60);
}

TEST(ScenePainter, GivesTheSamePictureAgain)
{
  Scene scene;
  scene.bodies = { block(RED) };
  ScenePainter painter(WIDTH, HEIGHT);
  const Image first = painter.paint(scene, sideView());
  painter.paint(scene, topView());
  const Image again = painter.paint(scene, sideView());
  EXPECT_TRUE(std::equal(first.data(), first.data() + first.byteCount(), again.data()));
}

TEST(ScenePainter, RefusesABlankPicture)
{
  Scene scene;  // nothing but a floor of the background's colour
  scene.floor.lines = false;
  scene.floor.background = scene.floor.colour;
  ScenePainter painter(WIDTH, HEIGHT);
  EXPECT_THROW(painter.paint(scene, topView()), PictureError);
}

TEST(ScenePainter, SeveralPaintersWorkSideBySide)
{
  Scene scene;
  scene.bodies = { block(RED) };
  ScenePainter small(WIDTH / 2, HEIGHT / 2), large(WIDTH, HEIGHT);
  const int large_area = redPart(large.paint(scene, sideView())).area;
  const int small_area = redPart(small.paint(scene, sideView())).area;
  EXPECT_NEAR(large_area / 4.0, small_area, 0.12 * small_area);
}

TEST(Camera, PlacesPointsAsThePictureShowsThem)
{
  const Eigen::Vector2d middle = sideView().toPicture({ 0.3, 0.0, 0.04 }, WIDTH, HEIGHT);
  EXPECT_NEAR(middle.x(), WIDTH / 2, 1e-9);
  EXPECT_NEAR(middle.y(), HEIGHT / 2, 1e-9);
  const Eigen::Vector2d upper_right = sideView().toPicture({ 0.0, 0.08, 0.10 }, WIDTH, HEIGHT);
  EXPECT_NEAR(upper_right.x(), WIDTH, 1e-9);
  EXPECT_NEAR(upper_right.y(), 0.0, 1e-9);
}

TEST(Camera, StandsLevelOnASlope)
{
  Camera camera = sideView();
  camera.target = { 0.0, 0.02, 0.0 };
  camera.slope = 0.1;
  const Eigen::Vector2d middle = camera.toPicture(camera.target, WIDTH, HEIGHT);
  const Eigen::Vector2d ahead = camera.toPicture({ 0.0, 0.06, 0.0 }, WIDTH, HEIGHT);
  EXPECT_NEAR(middle.x(), WIDTH / 2, 1e-9);
  EXPECT_NEAR(middle.y(), HEIGHT / 2, 1e-9);
  EXPECT_NEAR(ahead.x() - middle.x(), 0.04 * std::cos(0.1) * PIXELS_PER_METRE, 1e-9);
  EXPECT_NEAR(ahead.y() - middle.y(), 0.04 * std::sin(0.1) * PIXELS_PER_METRE, 1e-9) << "lower down the slope";
}
}  // namespace
}  // namespace devo_evo
