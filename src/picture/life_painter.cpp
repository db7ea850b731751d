#include "picture/life_painter.h"

#include "picture/overlay.h"

#include <cmath>

namespace devo_evo
{
Image LifePainter::paint(const LifeScene& life, const std::string& title)
{
  Image image = painter_.paint(life.scene(), life.camera());
  const Surroundings surroundings = life.appearance().surroundings();
  Readings readings = life.readings();
  if (!title.empty())
  {
    readings.name = title;
  }
  Canvas canvas(image);
  drawFloorMarks(canvas, image,
                 floorMarks(life.birthplace(), life.camera(), surroundings.body_length, surroundings.body_size),
                 life.camera());
  drawReadings(canvas, image, readings);
  drawColourLegend(canvas, image, colouring_, life.appearance().colourBar(colouring_));
  return image;
}

ViewOptions viewOf(const PictureFormat& format, double speed)
{
  ViewOptions view;
  view.colouring = format.colouring;
  view.interval = speed / format.pictures_per_s;
  return view;
}

int64_t picturesOfLife(const BodySettings& body, const ViewOptions& view)
{
  return 1 + static_cast<int64_t>(std::ceil(makeBody(body)->lifetime() / view.interval - 1e-9));
}
}  // namespace devo_evo
