#pragma once

#define GL_GLEXT_PROTOTYPES
#include "picture/scene_geometry.h"

#include <GL/osmesa.h>
#include <GL/glext.h>

#include <array>
#include <string>
#include <vector>

namespace devo_evo
{
/// A software OpenGL 3.3 context, current on the thread that made it until another one is.
class OpenGlContext
{
public:
  /// @throw PictureError
  OpenGlContext();
  ~OpenGlContext();
  OpenGlContext(const OpenGlContext&) = delete;
  OpenGlContext& operator=(const OpenGlContext&) = delete;

  /// @throw PictureError
  void makeCurrent();

  /// @throw PictureError naming what was being done if there was an error since the last look.
  static void check(const std::string& doing);

private:
  OSMesaContext context_;
  std::array<unsigned char, 4 * 16 * 16> unused_{};  ///< OSMesa wants a picture of its own; we draw into framebuffers
};

/// Shaders, linked.
class ShaderProgram
{
public:
  /// @throw PictureError with what the compiler says.
  ShaderProgram(const char* vertex_shader, const char* fragment_shader);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void use() const { glUseProgram(program_); }
  GLint uniform(const char* name) const { return glGetUniformLocation(program_, name); }

private:
  GLuint program_;
};

/// Vertices of a number of attributes, all floats, that are replaced at every picture.
class VertexStream
{
public:
  /// @param sizes number of floats of each attribute, in the order of their locations.
  explicit VertexStream(const std::vector<int>& sizes);
  ~VertexStream();
  VertexStream(const VertexStream&) = delete;
  VertexStream& operator=(const VertexStream&) = delete;

  void set(const std::vector<float>& values);
  void draw(GLenum primitive) const;

private:
  GLuint array_ = 0, buffer_ = 0;
  int floats_per_vertex_ = 0;
  GLsizei vertices_ = 0;
};

/// Something to draw into.
class Framebuffer
{
public:
  /// @param samples per pixel; 0: a picture that can be read.
  /// @throw PictureError if the driver cannot.
  Framebuffer(int width, int height, GLenum format, int samples, bool depth);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  void bind() const;

  /// Copies a part to the same place of another one, which is bound then.
  void copyTo(const Framebuffer& other, const PictureArea& area) const;

private:
  GLuint framebuffer_ = 0, color_ = 0, depth_ = 0;
  int width_, height_;
};
}  // namespace devo_evo
