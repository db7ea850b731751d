#pragma once

#include "devo_evo/picture/image.h"
#include "devo_evo/picture/scene.h"

#include <memory>
#include <string>

namespace devo_evo
{
/// Draws scenes with light, a soft shadow on the floor and smooth edges, by software (OSMesa): it needs neither display
/// nor graphics hardware. Not thread-safe; use an object where it was made: OpenGL belongs to a thread.
class ScenePainter
{
public:
  /// @param width, height of its pictures [pixels]. @throw InvalidInput, PictureError
  ScenePainter(int width, int height);
  ~ScenePainter();
  ScenePainter(const ScenePainter&) = delete;
  ScenePainter& operator=(const ScenePainter&) = delete;

  /// @throw PictureError if OpenGL reports an error, or if the picture is blank.
  Image paint(const Scene& scene, const Camera& camera);

  /// Who draws, as OpenGL names it.
  std::string driver() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};
}  // namespace devo_evo
