#include "ros/picture/lineage_bag.h"

#include "devo_evo/render/life_playback.h"
#include "devo_evo/render/scene.h"
#include "devo_evo/render/shown_robot.h"
#include "devo_evo/soft_body/text.h"
#include "ros/conversions.h"
#include "ros/robot_transforms.h"
#include "ros/scene_markers.h"

#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace devo_evo
{
namespace
{
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double FIRST_STAMP = 1.0;          // [s]
constexpr double ANNOTATION_INTERVAL = 0.2;  // of path, velocity and caption [s]
constexpr const char* NAME_SPACE = "/lineage/";

/// The body alone: its edges and voxels would double the bag and show nothing more.
MarkerArray bodyOnly(MarkerArray markers)
{
  auto& list = markers.markers;
  list.erase(std::remove_if(list.begin(), list.end(), [](const Marker& marker) { return marker.ns != "body"; }),
             list.end());
  for (Marker& marker : list)
  {
    for (std_msgs::ColorRGBA& colour : marker.colors)
    {
      constexpr float levels = 256.0f;  // what screens show: the bag compresses the better
      colour.r = std::round(colour.r * levels) / levels;
      colour.g = std::round(colour.g * levels) / levels;
      colour.b = std::round(colour.b * levels) / levels;
    }
  }
  return markers;
}

/// Writes life after life into a bag.
class LineageWriter
{
public:
  LineageWriter(rosbag::Bag& bag, const LineageBagOptions& options) : bag_(bag), options_(options) {}

  void record(const ShownRobot& robot, const EvolvedRobot& individual)
  {
    const LifeSurvey survey = surveyLife(robot);
    const std::string difference = disagreement(robot, survey.evaluation);
    if (!difference.empty())
    {
      throw std::runtime_error(difference);
    }
    const ros::Time birth(life_start_);
    const SceneMarkers markers(robot.body, Eigen::Vector3d::Zero());
    write("individual", birth, individual);
    MarkerArray floor = nothing();
    append(floor, markers.floor(floorPlan(survey, makeAppearance(robot.body)->surroundings())));
    setStamp(floor, birth);
    write("floor", birth, floor);
    recordMotion(robot, survey.evaluation, markers);
    const EvaluationRequest request{ individual.trial, individual.id, robot.program };
    VelocityTelemetry telemetry = telemetryOf(request, survey.evaluation, *makeBody(robot.body), "lineage");
    telemetry.header.stamp = stamp_;
    write("velocity", stamp_, telemetry);
    life_start_ = stamp_.toSec() + options_.pause;
  }

private:
  void recordMotion(const ShownRobot& robot, const Evaluation& evaluation, const SceneMarkers& markers)
  {
    const double lifetime = makeBody(robot.body)->lifetime();
    LifePlayback playback(robot.body, robot.program);
    MotionTrace trace;
    double next_annotation = 0.0;
    for (int64_t picture = 0; !playback.finished(); ++picture)
    {
      const double time = static_cast<double>(picture) / options_.rate;
      playback.advanceTo(time < lifetime ? time : std::numeric_limits<double>::infinity());
      if (playback.diverged() || !playback.frame().finite())
      {
        return;
      }
      const RobotFrame frame = playback.frame();
      trace.add(frame.time_since_birth, frame.center_of_mass);
      stamp_ = ros::Time(life_start_ + frame.time_since_birth);
      MarkerArray array = bodyOnly(markers.robot(frame, options_.colouring));
      if (frame.time_since_birth >= next_annotation || playback.finished())
      {
        append(array, markers.annotations(frame, trace, captionText(robot, evaluation, frame.time_since_birth)));
        next_annotation = frame.time_since_birth + ANNOTATION_INTERVAL;
      }
      setStamp(array, stamp_);
      write("robot", stamp_, array);
      tf2_msgs::TFMessage transforms;
      transforms.transforms = robotTransforms("lineage", frame.center_of_mass, frame.orientation, stamp_);
      bag_.write("/tf", stamp_, transforms);
    }
  }

  template <class Message>
  void write(const std::string& topic, const ros::Time& stamp, const Message& message)
  {
    bag_.write(NAME_SPACE + topic, stamp, message);
  }

  rosbag::Bag& bag_;
  const LineageBagOptions options_;
  double life_start_ = FIRST_STAMP;  ///< birth of the next one [s]
  ros::Time stamp_{ FIRST_STAMP };   ///< of the last message
};
}  // namespace

void LineageBagOptions::validate() const
{
  const auto check = [](const char* name, double value, double low, double high)
  {
    if (!(value >= low && value <= high))
    {
      throw InvalidInput(std::string(name) + " is " + toText(value) + "; it must be within " + toText(low) + " to " +
                         toText(high));
    }
  };
  check("rate", rate, 1.0, 200.0);
  check("pause", pause, 0.1, 60.0);
}

void writeLineageBag(const Archive& archive, const Lineage& lineage, const LineageBagOptions& options,
                     const std::string& path, const LineageProgress& progress)
{
  options.validate();
  const std::vector<size_t> positions = evenlySpaced(lineage.individuals.size(), options.count);
  const std::string partial = path + ".partial";
  struct Removal  // whatever happens, no part of a bag stays behind
  {
    const std::string& file;
    ~Removal()
    {
      std::error_code ignored;
      std::filesystem::remove(file, ignored);
    }
  } removal{ partial };
  try
  {
    rosbag::Bag bag(partial, rosbag::bagmode::Write);
    bag.setCompression(rosbag::compression::BZ2);
    LineageWriter writer(bag, options);
    for (size_t i = 0; i < positions.size(); ++i)
    {
      progress(i, positions.size());
      const ArchivedIndividual& archived = lineage.individuals[positions[i]];
      RobotChoice choice;
      choice.trial = archived.individual.trial;
      choice.id = archived.individual.id;
      writer.record(*findRobot(archive, choice), toMsg(archived, lineage.settings));
    }
    bag.close();
  }
  catch (const rosbag::BagException& error)
  {
    throw std::runtime_error(path + ": the bag cannot be written: " + error.what());
  }
  std::error_code error;
  std::filesystem::rename(partial, path, error);
  if (error)
  {
    throw std::runtime_error(path + ": the bag cannot be written: " + error.message());
  }
  progress(positions.size(), positions.size());
}
}  // namespace devo_evo
