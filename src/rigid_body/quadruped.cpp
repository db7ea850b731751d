#include "devo_evo/rigid_body/quadruped.h"

#include "devo_evo/soft_body/evaluation.h"
#include "devo_evo/soft_body/simulation.h"
#include "rigid_body/cycle_functions.h"
#include "rigid_body/quadruped_body.h"

#include <algorithm>

namespace devo_evo
{
namespace
{
constexpr double TWO_PI = 6.283185307179586;

const RigidBodySettings& checked(const RigidBodySettings& settings)
{
  settings.validate();
  return settings;
}

const QuadrupedProgram& checked(const QuadrupedProgram& program)
{
  validate(program);
  return program;
}
}  // namespace

double lightIntensity(const Eigen::Vector3d& light, const Eigen::Vector3d& sensor)
{
  return 1.0 / (light - sensor).squaredNorm();
}

/// The robot's body with its nervous system, and the record of its life.
class QuadrupedSimulation::World
{
public:
  World(const RigidBodySettings& settings, const QuadrupedProgram& program)
    : settings_(checked(settings))
    , program_(checked(program))
    , body_(settings, program.leg_length_initial)
    , birth_(body_.abdomen().position)
    , window_start_(birth_)
  {
  }

  const QuadrupedBody& body() const { return body_; }
  int64_t steps() const { return steps_; }
  double time() const { return static_cast<double>(steps_) * settings_.time_step; }
  bool finished() const { return failed_ || steps_ >= settings_.stepCount(); }

  void step()
  {
    control();
    body_.step();
    ++steps_;
    failed_ = !body_.withinBounds();
    if (!failed_)
    {
      record();
    }
  }

  QuadrupedEvaluation evaluation() const
  {
    QuadrupedEvaluation result;
    if (failed_)
    {
      result.failed_step = steps_;
      return result;
    }
    const double steps = static_cast<double>(std::max<int64_t>(steps_, 1));
    const Eigen::Vector3d travelled = body_.abdomen().position - birth_;
    result.valid = true;
    result.fitness = light_sum_ / steps;
    result.descent = travelled.dot(body_.downhill());
    result.sideways = travelled.x();
    result.turns = turned_ / TWO_PI;
    result.abdomen_contact = static_cast<double>(abdomen_contacts_) / steps;
    result.leg_contact = static_cast<double>(leg_contacts_) / steps;
    result.airborne_fraction = static_cast<double>(airborne_) / steps;
    result.first_abdomen_contact_s = first_abdomen_contact_;
    result.first_roll_s = first_roll_;
    result.velocity = velocity_;
    result.state_hash = body_.stateHash();
    return result;
  }

private:
  /// Two generators a quarter of a cycle apart excite the motor neurons, each of which gives its hinge an angle.
  void control()
  {
    const double age = static_cast<double>(steps_ + 1) / static_cast<double>(settings_.stepCount());
    const double cycles = settings_.generator_frequency * time();
    const std::array<double, GENERATOR_COUNT> generators = { sineOfCycles(cycles), cosineOfCycles(cycles) };
    const double limit = settings_.hinge_limit / 360.0 * TWO_PI;
    for (size_t leg = 0; leg < LEG_COUNT; ++leg)
    {
      double excitation = 0.0;
      for (size_t generator = 0; generator < GENERATOR_COUNT; ++generator)
      {
        excitation += program_.weight(leg, generator, age) * generators[generator];
      }
      body_.drive(leg, limit * std::clamp(excitation, -1.0, 1.0), program_.legLength(leg, age));
    }
  }

  void record()
  {
    const PartState abdomen = body_.abdomen();
    light_sum_ += lightIntensity(body_.light(), abdomen.position);
    turned_ -= abdomen.angular_velocity.x() * settings_.time_step;  // rolling downhill, to +y, is about -x
    bool leg_touches = false;
    for (size_t leg = 0; leg < LEG_COUNT; ++leg)
    {
      leg_touches = leg_touches || body_.legTouches(leg);
    }
    const bool abdomen_touches = body_.abdomenTouches();
    abdomen_contacts_ += abdomen_touches ? 1 : 0;
    leg_contacts_ += leg_touches ? 1 : 0;
    airborne_ += abdomen_touches || leg_touches ? 0 : 1;
    if (abdomen_touches && !first_abdomen_contact_)
    {
      first_abdomen_contact_ = time();
    }
    if (turned_ >= 0.5 * TWO_PI && !first_roll_)
    {
      first_roll_ = time();
    }
    if (windowEnds())
    {
      endWindow(abdomen.position);
    }
  }

  bool windowEnds() const
  {
    const double end = Evaluation::VELOCITY_WINDOW * static_cast<double>(velocity_.size() + 1);
    return steps_ == settings_.stepCount() || (static_cast<double>(steps_) + 0.5) * settings_.time_step > end;
  }

  void endWindow(const Eigen::Vector3d& position)
  {
    const double duration = static_cast<double>(steps_ - window_start_step_) * settings_.time_step;
    velocity_.push_back((position - window_start_).dot(body_.downhill()) / duration);
    window_start_ = position;
    window_start_step_ = steps_;
  }

  const RigidBodySettings settings_;
  const QuadrupedProgram program_;
  QuadrupedBody body_;
  const Eigen::Vector3d birth_;
  int64_t steps_ = 0;
  bool failed_ = false;
  double light_sum_ = 0.0;  // [1/m^2]
  double turned_ = 0.0;     // [rad]
  int64_t abdomen_contacts_ = 0;
  int64_t leg_contacts_ = 0;
  int64_t airborne_ = 0;
  std::optional<double> first_abdomen_contact_;
  std::optional<double> first_roll_;
  Eigen::Vector3d window_start_;  // where the abdomen was when the present velocity window began
  int64_t window_start_step_ = 0;
  std::vector<double> velocity_;
};

QuadrupedSimulation::QuadrupedSimulation(const RigidBodySettings& settings, const QuadrupedProgram& program)
  : world_(std::make_unique<World>(checked(settings), checked(program)))
{
}

QuadrupedSimulation::~QuadrupedSimulation() = default;

void QuadrupedSimulation::step()
{
  world_->step();
}

bool QuadrupedSimulation::finished() const
{
  return world_->finished();
}

int64_t QuadrupedSimulation::stepCount() const
{
  return world_->steps();
}

double QuadrupedSimulation::time() const
{
  return world_->time();
}

PartState QuadrupedSimulation::abdomen() const
{
  return world_->body().abdomen();
}

PartState QuadrupedSimulation::leg(size_t leg) const
{
  return world_->body().leg(leg);
}

double QuadrupedSimulation::rodLength() const
{
  return world_->body().rodLength();
}

double QuadrupedSimulation::hingeAngle(size_t leg) const
{
  return world_->body().hingeAngle(leg);
}

double QuadrupedSimulation::legLength(size_t leg) const
{
  return world_->body().legLength(leg);
}

bool QuadrupedSimulation::abdomenTouches() const
{
  return world_->body().abdomenTouches();
}

bool QuadrupedSimulation::legTouches(size_t leg) const
{
  return world_->body().legTouches(leg);
}

Eigen::Vector3d QuadrupedSimulation::light() const
{
  return world_->body().light();
}

Eigen::Vector3d QuadrupedSimulation::floorNormal() const
{
  return world_->body().floorNormal();
}

double QuadrupedSimulation::mechanicalEnergy() const
{
  return world_->body().mechanicalEnergy();
}

QuadrupedEvaluation QuadrupedSimulation::evaluation() const
{
  return world_->evaluation();
}

QuadrupedEvaluation evaluateQuadruped(const RigidBodySettings& settings, const QuadrupedProgram& program,
                                      const std::atomic<bool>* stop)
{
  QuadrupedSimulation simulation(settings, program);
  while (!simulation.finished())
  {
    if (stop && *stop)
    {
      throw EvaluationAbandoned();
    }
    simulation.step();
  }
  return simulation.evaluation();
}
}  // namespace devo_evo
