#include "rigid_body/quadruped_body.h"

#include "rigid_body/cycle_functions.h"
#include "soft_body/state_hash.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <mutex>
#include <stdexcept>

namespace devo_evo
{
namespace
{
constexpr double HALF_ROOT = 0.7071067811865476;  // sine and cosine of 45 degrees
constexpr double TWO_PI = 6.283185307179586;
constexpr double SOCKET_SHARE = 0.1;  // of a leg's mass

/// ODE keeps data of its own in every thread; both calls do nothing when repeated.
void prepareThread()
{
  static std::once_flag initialised;
  std::call_once(initialised,
                 []
                 {
                   // On standard error it would tell of degenerate contacts, which it solves as well as can be.
                   dSetMessageHandler([](int, const char*, va_list) {});
                   if (dInitODE2(0) == 0)
                   {
                     throw std::runtime_error("the physics library ODE could not be initialised");
                   }
                 });
  if (dAllocateODEDataForThread(dAllocateMaskAll) == 0)
  {
    throw std::runtime_error("the physics library ODE could not allocate its data for this thread");
  }
}

/// Where a leg points at rest, in the robot's frame: outwards and down by 45 degrees each.
Eigen::Vector3d directionAtRest(size_t leg)
{
  const double right = leg % 2 == 0 ? -1.0 : 1.0;
  const double front = leg < 2 ? 1.0 : -1.0;
  return { 0.5 * right, 0.5 * front, -HALF_ROOT };
}

/// How far the end of a leg is from the place where it leaves the abdomen [m].
double protrusion(const RigidBodySettings& settings, double length)
{
  return settings.leg_residual + settings.leg_range * length;
}

/// Height of the abdomen's centre above the floor at which an upright robot just touches it [m].
double heightAtBirth(const RigidBodySettings& settings, const std::array<double, LEG_COUNT>& leg_length)
{
  double height = settings.abdomen_radius;
  for (const double length : leg_length)
  {
    const double center_of_end = settings.abdomen_radius + protrusion(settings, length) - settings.leg_radius;
    height = std::max(height, center_of_end * HALF_ROOT + settings.leg_radius);
  }
  return height;
}

Eigen::Vector3d vector(const dReal* numbers)
{
  return { numbers[0], numbers[1], numbers[2] };
}

PartState stateOf(dBodyID part)
{
  const dReal* q = dBodyGetQuaternion(part);
  return { vector(dBodyGetPosition(part)), Eigen::Quaterniond(q[0], q[1], q[2], q[3]), vector(dBodyGetLinearVel(part)),
           vector(dBodyGetAngularVel(part)) };
}

/// The floor at a contact as a spring with a damper, so that how it gives does not depend on the time step (ODE manual,
/// "How to use ERP and CFM").
dSurfaceParameters surfaceOf(const RigidBodySettings& settings)
{
  const double spring = settings.time_step * settings.contact_stiffness;
  dSurfaceParameters surface = {};
  surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
  surface.mu = settings.friction;
  surface.soft_erp = spring / (spring + settings.contact_damping);
  surface.soft_cfm = 1.0 / (spring + settings.contact_damping);
  return surface;
}
}  // namespace

QuadrupedBody::QuadrupedBody(const RigidBodySettings& settings, const std::array<double, LEG_COUNT>& leg_length)
  : settings_(settings)
{
  prepareThread();
  const double sine = sineOfCycles(settings.slope / 360.0);
  const double cosine = cosineOfCycles(settings.slope / 360.0);
  normal_ = { 0.0, sine, cosine };
  downhill_ = { 0.0, cosine, -sine };
  tilt_ = { cosineOfCycles(settings.slope / 720.0), -sineOfCycles(settings.slope / 720.0), 0.0, 0.0 };
  surface_ = surfaceOf(settings);

  threading_ = dThreadingAllocateSelfThreadedImplementation();
  if (threading_ == nullptr)
  {
    throw std::runtime_error("this build of the physics library ODE cannot step worlds in threads of their own");
  }
  world_ = dWorldCreate();
  dWorldSetGravity(world_, 0.0, 0.0, -settings.gravity);
  dWorldSetAutoDisableFlag(world_, 0);
  dWorldSetStepThreadingImplementation(world_, dThreadingImplementationGetFunctions(threading_), threading_);
  contacts_ = dJointGroupCreate(0);
  floor_ = dCreatePlane(nullptr, normal_.x(), normal_.y(), normal_.z(), 0.0);
  const double height = heightAtBirth(settings, leg_length);
  makeAbdomen(height);
  for (size_t leg = 0; leg < LEG_COUNT; ++leg)
  {
    legs_[leg] = makeLeg(leg, height, leg_length[leg]);
  }
}

QuadrupedBody::~QuadrupedBody()
{
  dGeomDestroy(floor_);
  dGeomDestroy(abdomen_shape_);
  for (const Leg& leg : legs_)
  {
    dGeomDestroy(leg.shape);
  }
  dJointGroupDestroy(contacts_);
  dWorldDestroy(world_);
  dThreadingFreeImplementation(threading_);
}

dBodyID QuadrupedBody::makePart(const dMass& mass, const Eigen::Vector3d& place, const Eigen::Quaterniond& orientation)
{
  const dBodyID part = dBodyCreate(world_);
  dBodySetMass(part, &mass);
  dBodySetPosition(part, place.x(), place.y(), place.z());
  const dQuaternion rotation = { orientation.w(), orientation.x(), orientation.y(), orientation.z() };
  dBodySetQuaternion(part, rotation);
  return part;
}

void QuadrupedBody::makeAbdomen(double height)
{
  dMass mass;
  dMassSetSphereTotal(&mass, settings_.abdomen_mass, settings_.abdomen_radius);
  abdomen_ = makePart(mass, height * normal_, tilt_);
  abdomen_shape_ = dCreateSphere(nullptr, settings_.abdomen_radius);
  dGeomSetBody(abdomen_shape_, abdomen_);
}

QuadrupedBody::Leg QuadrupedBody::makeLeg(size_t number, double height, double length)
{
  const Eigen::Vector3d direction = tilt_ * directionAtRest(number);
  const Eigen::Vector3d root = height * normal_ + settings_.abdomen_radius * direction;
  const double rod_center = protrusion(settings_, length) - 0.5 * rodLength() - settings_.leg_radius;
  const Eigen::Quaterniond along = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), direction);

  Leg leg;
  leg.length_at_birth = length;
  dMass mass;
  dMassSetSphereTotal(&mass, SOCKET_SHARE * settings_.leg_mass, 2.0 * settings_.leg_radius);
  leg.socket = makePart(mass, root, along);
  constexpr int along_z = 3;
  dMassSetCapsuleTotal(&mass, (1.0 - SOCKET_SHARE) * settings_.leg_mass, along_z, settings_.leg_radius, rodLength());
  leg.rod = makePart(mass, root + rod_center * direction, along);
  leg.shape = dCreateCapsule(nullptr, settings_.leg_radius, rodLength());
  dGeomSetBody(leg.shape, leg.rod);

  makeHinge(leg, root);
  makeSlider(leg, direction);
  return leg;
}

void QuadrupedBody::makeHinge(Leg& leg, const Eigen::Vector3d& root)
{
  leg.hinge = dJointCreateHinge(world_, nullptr);
  dJointAttach(leg.hinge, leg.socket, abdomen_);
  dJointSetHingeAnchor(leg.hinge, root.x(), root.y(), root.z());
  dJointSetHingeAxis(leg.hinge, 1.0, 0.0, 0.0);
  const double limit = settings_.hinge_limit / 360.0 * TWO_PI;
  dJointSetHingeParam(leg.hinge, dParamLoStop, -limit);
  dJointSetHingeParam(leg.hinge, dParamHiStop, limit);

  leg.hinge_motor = dJointCreateAMotor(world_, nullptr);
  dJointAttach(leg.hinge_motor, leg.socket, abdomen_);
  dJointSetAMotorNumAxes(leg.hinge_motor, 1);
  constexpr int with_second_body = 2;
  dJointSetAMotorAxis(leg.hinge_motor, 0, with_second_body, 1.0, 0.0, 0.0);
  dJointSetAMotorParam(leg.hinge_motor, dParamFMax, settings_.hinge_torque);
  dJointSetAMotorParam(leg.hinge_motor, dParamCFM, 1.0 / settings_.hinge_damping);
}

void QuadrupedBody::makeSlider(Leg& leg, const Eigen::Vector3d& direction)
{
  leg.slider = dJointCreateSlider(world_, nullptr);
  dJointAttach(leg.slider, leg.rod, leg.socket);
  dJointSetSliderAxis(leg.slider, direction.x(), direction.y(), direction.z());
  dJointSetSliderParam(leg.slider, dParamLoStop, -settings_.leg_range * leg.length_at_birth);
  dJointSetSliderParam(leg.slider, dParamHiStop, settings_.leg_range * (1.0 - leg.length_at_birth));

  leg.actuator = dJointCreateLMotor(world_, nullptr);
  dJointAttach(leg.actuator, leg.rod, leg.socket);
  dJointSetLMotorNumAxes(leg.actuator, 1);
  constexpr int with_second_body = 2;
  dJointSetLMotorAxis(leg.actuator, 0, with_second_body, direction.x(), direction.y(), direction.z());
  dJointSetLMotorParam(leg.actuator, dParamFMax, settings_.actuator_force);
  dJointSetLMotorParam(leg.actuator, dParamCFM, 1.0 / settings_.actuator_damping);
}

double QuadrupedBody::rodLength() const
{
  return settings_.leg_residual + settings_.leg_range - 2.0 * settings_.leg_radius;
}

void QuadrupedBody::drive(size_t number, double angle, double length)
{
  const Leg& leg = legs_[number];
  const double angle_missing = angle - dJointGetHingeAngle(leg.hinge);
  const double length_missing =
      settings_.leg_range * (length - leg.length_at_birth) - dJointGetSliderPosition(leg.slider);
  dJointSetAMotorParam(leg.hinge_motor, dParamVel, settings_.hinge_gain * angle_missing);
  dJointSetLMotorParam(leg.actuator, dParamVel, settings_.actuator_gain * length_missing);
}

bool QuadrupedBody::makeContacts(dGeomID shape)
{
  constexpr int most_contacts = 4;
  dContactGeom found[most_contacts];
  const int count = dCollide(floor_, shape, most_contacts, found, sizeof(dContactGeom));
  for (int i = 0; i < count; ++i)
  {
    dContact contact = {};
    contact.surface = surface_;
    contact.geom = found[i];
    const dJointID joint = dJointCreateContact(world_, contacts_, &contact);
    dJointAttach(joint, dGeomGetBody(found[i].g1), dGeomGetBody(found[i].g2));
  }
  return count > 0;
}

void QuadrupedBody::step()
{
  abdomen_touches_ = makeContacts(abdomen_shape_);
  for (Leg& leg : legs_)
  {
    leg.touches = makeContacts(leg.shape);
  }
  dWorldStep(world_, settings_.time_step);  // not dWorldQuickStep(), which shuffles constraints at random
  dJointGroupEmpty(contacts_);
}

PartState QuadrupedBody::abdomen() const
{
  return stateOf(abdomen_);
}

PartState QuadrupedBody::leg(size_t leg) const
{
  return stateOf(legs_[leg].rod);
}

double QuadrupedBody::hingeAngle(size_t leg) const
{
  return dJointGetHingeAngle(legs_[leg].hinge);
}

double QuadrupedBody::legLength(size_t number) const
{
  const Leg& leg = legs_[number];
  const double moved = dJointGetSliderPosition(leg.slider);
  return leg.length_at_birth + (settings_.leg_range > 0.0 ? moved / settings_.leg_range : 0.0);
}

template <class Visit>
void QuadrupedBody::forEachPart(Visit visit) const
{
  visit(abdomen_);
  for (const Leg& leg : legs_)
  {
    visit(leg.socket);
    visit(leg.rod);
  }
}

double QuadrupedBody::mechanicalEnergy() const
{
  double energy = 0.0;
  forEachPart(
      [&](dBodyID part)
      {
        dMass mass;
        dBodyGetMass(part, &mass);
        const PartState state = stateOf(part);
        const Eigen::Vector3d turning = state.orientation.conjugate() * state.angular_velocity;
        const Eigen::Vector3d inertia(mass.I[0], mass.I[5], mass.I[10]);
        energy += 0.5 * mass.mass * state.velocity.squaredNorm() + 0.5 * inertia.dot(turning.cwiseProduct(turning)) +
                  mass.mass * settings_.gravity * state.position.z();
      });
  return energy;
}

bool QuadrupedBody::withinBounds() const
{
  constexpr double farthest = 1e6;  // [m], and in m/s and rad/s
  bool within = true;
  forEachPart(
      [&](dBodyID part)
      {
        const PartState state = stateOf(part);
        // Comparisons that NaN fails.
        within = within && state.position.cwiseAbs().maxCoeff() < farthest &&
                 state.velocity.cwiseAbs().maxCoeff() < farthest &&
                 state.angular_velocity.cwiseAbs().maxCoeff() < farthest &&
                 state.position.sum() == state.position.sum();
      });
  return within;
}

uint64_t QuadrupedBody::stateHash() const
{
  StateHash hash;
  forEachPart(
      [&](dBodyID part)
      {
        const PartState state = stateOf(part);
        for (const double number :
             { state.position.x(), state.position.y(), state.position.z(), state.orientation.w(), state.orientation.x(),
               state.orientation.y(), state.orientation.z(), state.velocity.x(), state.velocity.y(), state.velocity.z(),
               state.angular_velocity.x(), state.angular_velocity.y(), state.angular_velocity.z() })
        {
          hash.add(number);
        }
      });
  return hash.finish();
}
}  // namespace devo_evo
