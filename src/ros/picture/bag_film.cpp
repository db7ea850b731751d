#include "cli/bag_film.h"

#include "devo_evo/picture/film_writer.h"
#include "devo_evo/soft_body/settings.h"
#include "ros/picture/marker_picture.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace devo_evo
{
namespace
{
using visualization_msgs::MarkerArray;

constexpr double LONGEST_GAP = 5.0;  // without a message, after which a film goes on at the next one [s]

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The topics of one robot: of several, those of the first by name.
std::vector<std::string> robotTopics(rosbag::Bag& bag, const std::string& path)
{
  std::vector<std::string> names;
  for (const rosbag::ConnectionInfo* connection : rosbag::View(bag).getConnections())
  {
    if (connection->datatype == "visualization_msgs/MarkerArray" && endsWith(connection->topic, "/robot"))
    {
      names.push_back(connection->topic.substr(0, connection->topic.size() - 5));
    }
  }
  if (names.empty())
  {
    throw InvalidInput(path +
                       ": the bag shows no robot: it has no topic of visualization_msgs/MarkerArray that ends in "
                       "/robot, as bags of lineages and recorded runs do");
  }
  const std::string first = *std::min_element(names.begin(), names.end());
  return { first + "robot", first + "floor" };
}

void addMarkers(const MarkerArray& markers, const std::string& bag_path, MarkerPicture& picture)
{
  try
  {
    picture.add(markers);
  }
  catch (const InvalidInput& error)
  {
    throw InvalidInput(bag_path + ": " + error.what());
  }
}

void film(rosbag::Bag& bag, const std::string& bag_path, const std::string& path, const PictureFormat& format,
          const FilmProgress& progress)
{
  rosbag::View view(bag, rosbag::TopicQuery(robotTopics(bag, bag_path)));
  if (view.size() == 0)
  {
    throw InvalidInput(bag_path + ": the bag has no messages that show a robot");
  }
  const double interval = format.speed / format.pictures_per_s;
  const double begin = view.getBeginTime().toSec(), end = view.getEndTime().toSec();
  const auto total = static_cast<int64_t>((end - begin) / interval) + 1;
  MarkerPicture picture(format.width, format.height, 1.0 / format.pictures_per_s);
  const auto writer = makeFilmWriter(path, format.width, format.height, format.pictures_per_s);
  double next = begin;
  const auto paint = [&]
  {
    writer->add(picture.paint());
    next += interval;
    progress(std::min(total, static_cast<int64_t>(std::lround((next - begin) / interval))), total);
  };
  for (const rosbag::MessageInstance& message : view)
  {
    const double time = message.getTime().toSec();
    while (picture.hasRobot() && next < time && time - next < LONGEST_GAP)
    {
      paint();
    }
    next = picture.hasRobot() && time - next < LONGEST_GAP ? next : time;
    if (const MarkerArray::ConstPtr markers = message.instantiate<MarkerArray>())
    {
      addMarkers(*markers, bag_path, picture);
    }
  }
  if (picture.hasRobot())
  {
    paint();
  }
  writer->finish();
}
}  // namespace

void filmBag(const std::string& bag_path, const std::string& path, const PictureFormat& format,
             const FilmProgress& progress)
{
  format.validate();
  try
  {
    rosbag::Bag bag(bag_path, rosbag::bagmode::Read);
    film(bag, bag_path, path, format, progress);
  }
  catch (const rosbag::BagException& error)
  {
    throw InvalidInput(bag_path + ": it cannot be read as a bag: " + error.what());
  }
}
}  // namespace devo_evo
