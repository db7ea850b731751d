#include "picture/opengl.h"

#include "devo_evo/picture/image.h"
#include "devo_evo/soft_body/text.h"

namespace devo_evo
{
namespace
{
GLuint compileShader(GLenum kind, const char* source)
{
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_TRUE)
  {
    char log[2048] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw PictureError(std::string("OpenGL cannot compile a shader: ") + log);
  }
  return shader;
}
}  // namespace

OpenGlContext::OpenGlContext()
{
  const int attributes[] = { OSMESA_FORMAT,
                             OSMESA_BGRA,
                             OSMESA_DEPTH_BITS,
                             0,
                             OSMESA_PROFILE,
                             OSMESA_CORE_PROFILE,
                             OSMESA_CONTEXT_MAJOR_VERSION,
                             3,
                             OSMESA_CONTEXT_MINOR_VERSION,
                             3,
                             0 };
  context_ = OSMesaCreateContextAttribs(attributes, nullptr);
  if (context_ == nullptr)
  {
    throw PictureError(
        "OSMesa, which draws without a display, cannot give OpenGL 3.3; is libosmesa6 of version 20 or "
        "later installed?");
  }
  makeCurrent();
  // Linked behind another OpenGL library, OSMesa makes a context that draws nothing and reports no error.
  if (glGetString(GL_VERSION) == nullptr)
  {
    OSMesaDestroyContext(context_);
    throw PictureError("another OpenGL library took the place of OSMesa's; link OSMesa first");
  }
}

OpenGlContext::~OpenGlContext()
{
  OSMesaDestroyContext(context_);
}

void OpenGlContext::makeCurrent()
{
  if (OSMesaGetCurrentContext() != context_ &&
      OSMesaMakeCurrent(context_, unused_.data(), GL_UNSIGNED_BYTE, 16, 16) != GL_TRUE)
  {
    throw PictureError("OSMesa cannot make its context current");
  }
}

void OpenGlContext::check(const std::string& doing)
{
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR)
  {
    throw PictureError("OpenGL error " + toText(static_cast<int64_t>(error)) + " while " + doing);
  }
}

ShaderProgram::ShaderProgram(const char* vertex_shader, const char* fragment_shader) : program_(glCreateProgram())
{
  for (const GLuint shader :
       { compileShader(GL_VERTEX_SHADER, vertex_shader), compileShader(GL_FRAGMENT_SHADER, fragment_shader) })
  {
    glAttachShader(program_, shader);
    glDeleteShader(shader);  // once the program is gone
  }
  glLinkProgram(program_);
  GLint linked = GL_FALSE;
  glGetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE)
  {
    char log[2048] = "";
    glGetProgramInfoLog(program_, sizeof log, nullptr, log);
    throw PictureError(std::string("OpenGL cannot link shaders: ") + log);
  }
}

ShaderProgram::~ShaderProgram()
{
  glDeleteProgram(program_);
}

VertexStream::VertexStream(const std::vector<int>& sizes)
{
  for (const int size : sizes)
  {
    floats_per_vertex_ += size;
  }
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &buffer_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  size_t offset = 0;
  for (size_t i = 0; i < sizes.size(); ++i)
  {
    const GLuint location = static_cast<GLuint>(i);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, sizes[i], GL_FLOAT, GL_FALSE,
                          static_cast<GLsizei>(sizeof(float)) * floats_per_vertex_,
                          reinterpret_cast<const void*>(offset));
    offset += sizeof(float) * static_cast<size_t>(sizes[i]);
  }
}

VertexStream::~VertexStream()
{
  glDeleteBuffers(1, &buffer_);
  glDeleteVertexArrays(1, &array_);
}

void VertexStream::set(const std::vector<float>& values)
{
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data(), GL_STREAM_DRAW);
  vertices_ = static_cast<GLsizei>(values.size()) / floats_per_vertex_;
}

void VertexStream::draw(GLenum primitive) const
{
  glBindVertexArray(array_);
  glDrawArrays(primitive, 0, vertices_);
}

Framebuffer::Framebuffer(int width, int height, GLenum format, int samples, bool depth) : width_(width), height_(height)
{
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glGenRenderbuffers(1, &color_);
  glBindRenderbuffer(GL_RENDERBUFFER, color_);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
  if (depth)
  {
    glGenRenderbuffers(1, &depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  }
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    throw PictureError("OpenGL cannot draw pictures of " + toText(width) + " x " + toText(height) + " pixels");
  }
}

Framebuffer::~Framebuffer()
{
  glDeleteRenderbuffers(1, &color_);
  glDeleteRenderbuffers(1, &depth_);
  glDeleteFramebuffers(1, &framebuffer_);
}

void Framebuffer::bind() const
{
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, width_, height_);
}

void Framebuffer::copyTo(const Framebuffer& other, const PictureArea& area) const
{
  const int right = area.x + area.width, top = area.y + area.height;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, other.framebuffer_);
  glBlitFramebuffer(area.x, area.y, right, top, area.x, area.y, right, top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, other.framebuffer_);
}
}  // namespace devo_evo
