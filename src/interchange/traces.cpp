#include "devo_evo/interchange/traces.h"

#include "devo_evo/soft_body/simulation.h"
#include "devo_evo/soft_body/text.h"

#include <initializer_list>

namespace devo_evo
{
namespace
{
std::string joined(std::initializer_list<double> numbers)
{
  std::string text;
  for (const double number : numbers)
  {
    text += (text.empty() ? "" : ",") + toText(number);
  }
  return text;
}

std::string momentOf(const Simulation& simulation)
{
  return joined({ simulation.time(), simulation.time() - SETTLING_TIME });
}

void writeCenterOfMass(const Simulation& simulation, const LineSink& sink)
{
  const Eigen::Vector3d center = simulation.centerOfMass(0);
  const Eigen::Quaterniond turn = simulation.meanOrientation(0);
  sink(momentOf(simulation) + "," +
       joined({ center.x(), center.y(), center.z(), turn.w(), turn.x(), turn.y(), turn.z() }));
}

void writeVoxels(const Simulation& simulation, int voxel_count, const LineSink& sink)
{
  const std::string moment = momentOf(simulation);
  for (int voxel = 0; voxel < voxel_count; ++voxel)
  {
    const VoxelState state = simulation.voxel(0, voxel);
    const Eigen::Vector3d& position = state.position;
    const Eigen::Quaterniond& turn = state.orientation;
    const Eigen::Vector3d& velocity = state.velocity;
    const Eigen::Vector3d& spin = state.angular_velocity;
    sink(moment + "," + toText(voxel) + "," +
         joined({ position.x(), position.y(), position.z(), turn.w(), turn.x(), turn.y(), turn.z(), velocity.x(),
                  velocity.y(), velocity.z(), spin.x(), spin.y(), spin.z(), state.scale,
                  simulation.restingLength(0, voxel) }) +
         "," + (state.static_friction ? "1" : "0"));
  }
}
}  // namespace

Evaluation writeTrace(const SoftBodySettings& settings, const DevelopmentalProgram& program, TraceKind kind,
                      double interval, const LineSink& sink)
{
  if (!(interval >= settings.timeStep()))
  {
    throw InvalidInput("the interval of a trace is " + toText(interval) + " s; it must be at least a time step, " +
                       toText(settings.timeStep()) + " s");
  }
  const auto simulation = makeSimulation(settings, { program }, InstructionSet::SCALAR);
  const auto write = [&]
  {
    kind == TraceKind::CENTER_OF_MASS ? writeCenterOfMass(*simulation, sink)
                                      : writeVoxels(*simulation, settings.voxelCount(), sink);
  };
  sink(kind == TraceKind::CENTER_OF_MASS ? "time_s,since_birth_s,x_m,y_m,z_m,q_w,q_x,q_y,q_z"
                                         : "time_s,since_birth_s,voxel,x_m,y_m,z_m,q_w,q_x,q_y,q_z,v_x_m_per_s,"
                                           "v_y_m_per_s,v_z_m_per_s,w_x_rad_per_s,w_y_rad_per_s,w_z_rad_per_s,"
                                           "scale_m,resting_length_m,static_friction");
  write();
  for (int64_t line = 1; !simulation->finished();)
  {
    simulation->step();
    if (!simulation->diverged(0) &&
        (simulation->finished() || simulation->time() >= static_cast<double>(line) * interval))
    {
      write();
      ++line;
    }
  }
  return simulation->evaluation(0);
}
}  // namespace devo_evo
