#pragma once

#include "devo_evo/picture/image.h"
#include "devo_evo/picture/life_scene.h"
#include "devo_evo/picture/pictures.h"
#include "devo_evo/picture/scene_painter.h"

#include <string>

namespace devo_evo
{
/// Draws lives with their instruments, all of one size.
class LifePainter
{
public:
  LifePainter(int width, int height, Colouring colouring) : painter_(width, height), colouring_(colouring) {}

  /// @param title instead of "Robot 1/644"; empty: that.
  Image paint(const LifeScene& life, const std::string& title = "");

private:
  ScenePainter painter_;
  const Colouring colouring_;
};

/// How lives are shown in films of a format. @param speed seconds of life per second of film.
ViewOptions viewOf(const PictureFormat& format, double speed);

/// Number of pictures that a whole life takes.
int64_t picturesOfLife(const BodySettings& body, const ViewOptions& view);
}  // namespace devo_evo
