#include "cli/bag_film.h"

#include "devo_evo/soft_body/settings.h"

namespace devo_evo
{
void filmBag(const std::string& bag, const std::string& /*path*/, const PictureFormat& /*format*/,
             const FilmProgress& /*progress*/)
{
  throw InvalidInput(bag + ": this devo_evo was built without ROS and cannot read bags");
}
}  // namespace devo_evo
