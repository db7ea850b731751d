#include "devo_evo/picture/scene_painter.h"

#include "picture/opengl.h"
#include "picture/scene_geometry.h"
#include "picture/shaders.h"

#include <algorithm>
#include <cmath>

namespace devo_evo
{
namespace
{
constexpr int SAMPLES = 4;  // per pixel, against jagged edges

const Eigen::Vector3f TO_LIGHT = Eigen::Vector3f(0.5f, 0.28f, 1.0f).normalized();

void setUniform(GLint location, const Eigen::Vector3f& value)
{
  glUniform3f(location, value.x(), value.y(), value.z());
}

void setUniform(GLint location, const Eigen::Vector2f& value)
{
  glUniform2f(location, value.x(), value.y());
}

void setUniform(GLint location, const Eigen::Matrix4f& value)
{
  glUniformMatrix4fv(location, 1, GL_FALSE, value.data());
}

/// Shadows on the floor: drawn as seen from the lamp and from above, then softened.
class ShadowTexture
{
public:
  ShadowTexture()
  {
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    for (const GLenum wrap : { GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T })
    {
      glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  }
  ~ShadowTexture() { glDeleteTextures(1, &texture_); }
  ShadowTexture(const ShadowTexture&) = delete;
  ShadowTexture& operator=(const ShadowTexture&) = delete;

  /// Leaves the texture bound. @param bodies as the vertex stream holds them.
  void update(const VertexStream& bodies, const ShadowArea& area, float body_size)
  {
    resize(area, body_size);
    drawing_->bind();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MAX);
    program_.use();
    setUniform(program_.uniform("to_light"), TO_LIGHT);
    setUniform(program_.uniform("shadow_center"), area.center);
    setUniform(program_.uniform("shadow_extent"), area.extent);
    glUniform1f(program_.uniform("body_size"), body_size);
    for (const int from_above : { 0, 1 })
    {
      glUniform1i(program_.uniform("from_above"), from_above);
      bodies.draw(GL_TRIANGLES);
    }
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    soften(body_size);
  }

  static constexpr float MARGIN = 0.4f;  ///< around the bodies, for soft edges [body sizes]

private:
  // In body sizes.
  static constexpr float PIXEL = 0.02f;
  static constexpr float LAMP_BLUR = 0.045f;
  static constexpr float TOUCH_BLUR = 0.03f;

  static constexpr int LONGEST = 2048;  // side of the texture [pixels]

  void resize(const ShadowArea& area, float body_size)
  {
    const auto pixels = [=](float half)
    { return static_cast<int>(std::clamp(2 * half / (PIXEL * body_size), 16.0f, static_cast<float>(LONGEST))); };
    // Multiples of 32, so that a moving robot seldom needs another size.
    const int width = (pixels(area.extent.x()) + 31) / 32 * 32, height = (pixels(area.extent.y()) + 31) / 32 * 32;
    pixel_ = 2 * area.extent.y() / static_cast<float>(height);
    if (width != width_ || height != height_)
    {
      width_ = width;
      height_ = height;
      drawing_ = std::make_unique<Framebuffer>(width, height, GL_RGBA8, 0, false);
    }
  }

  void soften(float body_size)
  {
    const size_t count = static_cast<size_t>(width_) * static_cast<size_t>(height_);
    pixels_.resize(4 * count);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels_.data());
    lamp_.resize(count);
    touch_.resize(count);
    for (size_t i = 0; i < count; ++i)
    {
      lamp_[i] = pixels_[4 * i];
      touch_[i] = pixels_[4 * i + 1];
    }
    const auto radius = [&](float length)
    { return std::max(1, static_cast<int>(std::lround(length * body_size / pixel_))); };
    blur(lamp_, width_, height_, radius(LAMP_BLUR));
    blur(touch_, width_, height_, radius(TOUCH_BLUR));
    for (size_t i = 0; i < count; ++i)
    {
      pixels_[4 * i] = lamp_[i];
      pixels_[4 * i + 1] = touch_[i];
    }
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels_.data());
  }

  ShaderProgram program_{ SHADOW_VERTEX_SHADER, SHADOW_FRAGMENT_SHADER };
  GLuint texture_ = 0;
  std::unique_ptr<Framebuffer> drawing_;
  int width_ = 0, height_ = 0;
  float pixel_ = 1.0f;  ///< [m]
  std::vector<uint8_t> pixels_, lamp_, touch_;
};
}  // namespace

class ScenePainter::Implementation
{
public:
  Implementation(int width, int height)
    : width_(width)
    , height_(height)
    , drawing_(width, height, GL_RGBA8, SAMPLES, true)
    , picture_(width, height, GL_RGBA8, 0, false)
  {
    OpenGlContext::check("setting up");
  }

  ~Implementation() { context_.makeCurrent(); }

  Image paint(const Scene& scene, const Camera& camera)
  {
    context_.makeCurrent();
    bodies_.set(bodyVertices(scene.bodies));
    scenery_.set(bodyVertices(scene.scenery));
    const ShadowArea area = shadowArea(scene.bodies, TO_LIGHT, ShadowTexture::MARGIN * scene.body_size);
    shadow_.update(bodies_, area, scene.body_size);

    Eigen::Matrix4d projection = camera.projection(static_cast<double>(width_) / height_);
    projection.row(1) *= -1.0;  // OpenGL's pictures begin at the bottom, ours at the top
    const Eigen::Matrix4f matrix = projection.cast<float>();
    const auto draw_floor = [&]
    {
      drawFloor(matrix, scene.floor, camera, area);
      drawFloorLines(matrix);
    };
    floor_lines_.set(floorLineVertices(scene.floor_lines));
    picture_.bind();
    clear(scene.floor.background);
    draw_floor();

    // Bodies need several samples a pixel to look smooth, which is slow: only where they are.
    for (const std::vector<ColouredTriangles>* surfaces : { &scene.scenery, &scene.bodies })
    {
      if (surfaces->empty())
      {
        continue;
      }
      const PictureArea place = pictureArea(*surfaces, matrix, width_, height_);
      glEnable(GL_SCISSOR_TEST);
      glScissor(place.x, place.y, place.width, place.height);
      drawing_.bind();
      glEnable(GL_DEPTH_TEST);
      clear(scene.floor.background);
      drawBodies(matrix, camera, scene.body_size);
      draw_floor();
      glDisable(GL_DEPTH_TEST);
      glDisable(GL_SCISSOR_TEST);
      drawing_.copyTo(picture_, place);
    }
    return readPicture();
  }

  std::string driver()
  {
    context_.makeCurrent();
    return std::string(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) + ", OpenGL " +
           reinterpret_cast<const char*>(glGetString(GL_VERSION));
  }

private:
  static void clear(const Eigen::Vector3f& colour)
  {
    glClearColor(colour.x(), colour.y(), colour.z(), 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }

  void drawBodies(const Eigen::Matrix4f& projection, const Camera& camera, float body_size)
  {
    body_program_.use();
    setUniform(body_program_.uniform("projection"), projection);
    setUniform(body_program_.uniform("to_light"), TO_LIGHT);
    const Eigen::Vector3d to_eye(std::cos(camera.elevation) * std::cos(camera.azimuth),
                                 std::cos(camera.elevation) * std::sin(camera.azimuth), std::sin(camera.elevation));
    setUniform(body_program_.uniform("to_eye"), Eigen::Vector3f(to_eye.cast<float>()));
    glUniform1f(body_program_.uniform("body_size"), body_size);
    bodies_.draw(GL_TRIANGLES);
    scenery_.draw(GL_TRIANGLES);
  }

  void drawFloor(const Eigen::Matrix4f& projection, const Floor& floor, const Camera& camera, const ShadowArea& area)
  {
    const float x = static_cast<float>(camera.target.x()), y = static_cast<float>(camera.target.y());
    const float far = floor.fade_end;
    floor_.set({ x - far, y - far, x + far, y - far, x - far, y + far, x + far, y + far });
    floor_program_.use();
    const auto uniform = [this](const char* name) { return floor_program_.uniform(name); };
    setUniform(uniform("projection"), projection);
    setUniform(uniform("floor_color"), floor.colour);
    setUniform(uniform("line_color"), floor.line_colour);
    setUniform(uniform("background"), floor.background);
    setUniform(uniform("target"), Eigen::Vector2f(x, y));
    setUniform(uniform("fade"), Eigen::Vector2f(floor.fade_start, floor.fade_end));
    glUniform1f(uniform("line_distance"), floor.lines ? floor.line_distance : 0.0f);
    setUniform(uniform("line_origin"), floor.line_origin);
    setUniform(uniform("shadow_center"), area.center);
    setUniform(uniform("shadow_extent"), area.extent);
    glUniform1i(uniform("shadow"), 0);
    floor_.draw(GL_TRIANGLE_STRIP);
  }

  void drawFloorLines(const Eigen::Matrix4f& projection)
  {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    line_program_.use();
    setUniform(line_program_.uniform("projection"), projection);
    floor_lines_.draw(GL_TRIANGLES);
    glDisable(GL_BLEND);
  }

  Image readPicture()
  {
    Image image(width_, height_);
    glReadPixels(0, 0, width_, height_, GL_BGRA, GL_UNSIGNED_BYTE, image.data());
    OpenGlContext::check("drawing a scene");
    if (image.isBlank())
    {
      throw PictureError("OpenGL drew a blank picture (" + driver() + ")");
    }
    return image;
  }

  const int width_, height_;
  OpenGlContext context_;
  Framebuffer drawing_, picture_;  ///< with several samples a pixel, and with one
  ShadowTexture shadow_;
  ShaderProgram body_program_{ BODY_VERTEX_SHADER, BODY_FRAGMENT_SHADER };
  ShaderProgram floor_program_{ FLOOR_VERTEX_SHADER, FLOOR_FRAGMENT_SHADER };
  ShaderProgram line_program_{ LINE_VERTEX_SHADER, LINE_FRAGMENT_SHADER };
  VertexStream bodies_{ { 3, 3, 3, 3 } }, scenery_{ { 3, 3, 3, 3 } };
  VertexStream floor_{ { 2 } };
  VertexStream floor_lines_{ { 2, 4, 3 } };
};

ScenePainter::ScenePainter(int width, int height)
{
  Image(width, height);  // checks the sides
  implementation_ = std::make_unique<Implementation>(width, height);
}

ScenePainter::~ScenePainter() = default;

Image ScenePainter::paint(const Scene& scene, const Camera& camera)
{
  return implementation_->paint(scene, camera);
}

std::string ScenePainter::driver() const
{
  return implementation_->driver();
}
}  // namespace devo_evo
