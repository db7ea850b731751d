#pragma once

#include "devo_evo/rigid_body/quadruped.h"

#include <ode/ode.h>

#include <array>

namespace devo_evo
{
/// An ODE world with one quadruped on its floor. Everything in it is made, stepped and summed in a fixed order.
class QuadrupedBody
{
public:
  /// @param leg_length at birth, per leg [1, 0 to 1].
  QuadrupedBody(const RigidBodySettings& settings, const std::array<double, LEG_COUNT>& leg_length);
  ~QuadrupedBody();
  QuadrupedBody(const QuadrupedBody&) = delete;
  QuadrupedBody& operator=(const QuadrupedBody&) = delete;

  /// Sets what the motors of a leg seek. @param angle of the hinge [rad]. @param length [1, 0 to 1].
  void drive(size_t leg, double angle, double length);

  /// Advances by one time step.
  void step();

  PartState abdomen() const;
  PartState leg(size_t leg) const;
  double hingeAngle(size_t leg) const;
  double legLength(size_t leg) const;
  bool abdomenTouches() const { return abdomen_touches_; }
  bool legTouches(size_t leg) const { return legs_[leg].touches; }
  double mechanicalEnergy() const;

  /// Whether every part is where numbers can say, and nowhere near the end of the world.
  bool withinBounds() const;

  /// Of the state of every part.
  uint64_t stateHash() const;

  const Eigen::Vector3d& floorNormal() const { return normal_; }
  const Eigen::Vector3d& downhill() const { return downhill_; }
  Eigen::Vector3d light() const { return settings_.light_distance * downhill_ + settings_.light_height * normal_; }
  double rodLength() const;

private:
  struct Leg
  {
    dBodyID socket;  ///< swings on the hinge, with no shape of its own
    dBodyID rod;     ///< slides in the socket
    dGeomID shape;   ///< of the rod
    dJointID hinge;
    dJointID hinge_motor;  ///< apart from the hinge: ODE's joints let their motor push blindly while at a stop
    dJointID slider;
    dJointID actuator;       ///< likewise
    double length_at_birth;  ///< [1], at which the slider's position counts as zero
    bool touches = false;
  };

  void makeAbdomen(double height);
  Leg makeLeg(size_t leg, double height, double length);
  void makeHinge(Leg& leg, const Eigen::Vector3d& root);
  void makeSlider(Leg& leg, const Eigen::Vector3d& direction);
  dBodyID makePart(const dMass& mass, const Eigen::Vector3d& place, const Eigen::Quaterniond& orientation);

  /// Joins a shape to the floor wherever they touch; tells whether they do.
  bool makeContacts(dGeomID shape);

  /// Calls visit(part) for abdomen, sockets and rods, in this order.
  template <class Visit>
  void forEachPart(Visit visit) const;

  const RigidBodySettings settings_;
  Eigen::Vector3d normal_;
  Eigen::Vector3d downhill_;
  Eigen::Quaterniond tilt_;  ///< of the robot at birth: upright on the floor
  dSurfaceParameters surface_ = {};
  dThreadingImplementationID threading_;  ///< its own: ODE's default one is shared by all worlds, without a lock
  dWorldID world_;
  dJointGroupID contacts_;
  dGeomID floor_;
  dBodyID abdomen_ = nullptr;
  dGeomID abdomen_shape_ = nullptr;
  bool abdomen_touches_ = false;
  std::array<Leg, LEG_COUNT> legs_;
};
}  // namespace devo_evo
