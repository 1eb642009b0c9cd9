#include "peers/ode_robot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "murosimf/algorithms/tree_rows.h"

namespace murosimf::peers {

namespace {

constexpr int kContactsPerSole = 4;
constexpr double kGravity = 9.81;  // [m/s^2]

/// ODE wants to be woken up once.
void startOde() {
  static const bool started = dInitODE2(0) != 0;
  if (!started) throw std::runtime_error("ODE does not start");
}

void setRotation(const Rotation3& r, dMatrix3 m) {
  const std::array<double, 12> rows{r.x.x, r.y.x, r.z.x, 0, r.x.y, r.y.y, r.z.y, 0, r.x.z, r.y.z, r.z.z, 0};
  std::copy(rows.begin(), rows.end(), m);
}
Rotation3 rotationFrom(const dReal* m) { return {{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}}; }
Vector3 vectorFrom(const dReal* v) { return {v[0], v[1], v[2]}; }

Vector3 axisOf(const TreeRow& row) { return row.axis == 0 ? kAxisX : row.axis == 1 ? kAxisY : kAxisZ; }

}  // namespace

OdeRobot::OdeRobot(const PeerScene& scene) : scene_(scene) {
  startOde();
  world_ = dWorldCreate();
  space_ = dSimpleSpaceCreate(nullptr);
  ground_ = dCreatePlane(space_, 0, 0, 1, 0);
  contact_group_ = dJointGroupCreate(0);
  dWorldSetGravity(world_, 0, 0, -kGravity);
  dWorldSetQuickStepNumIterations(world_, 20);
  const std::size_t rows = scene.robot.flat.table.rows.size();
  for (std::size_t row = 0; row < rows; ++row) addBody(row);
  const std::vector<Pose> X_WR = rowPoses({}, std::vector<double>(rows - 1, 0.0));
  placeBodies(X_WR);
  for (std::size_t row = 1; row < rows; ++row) addHinge(row, X_WR);
  addSoles();
  wanted_.assign(rows - 1, 0.0);
  if (scene.robot.model.imus.empty()) return;
  const ImuMount& imu = scene.robot.model.imus.front();
  const RowPlace& mount = scene.robot.flat.bodies[static_cast<std::size_t>(imu.body)];
  imu_ = {mount.row, mount.X_RB * imu.X_BI};
}

OdeRobot::~OdeRobot() {
  dJointGroupDestroy(contact_group_);
  dSpaceDestroy(space_);
  dWorldDestroy(world_);
}

void OdeRobot::addBody(std::size_t row) {
  const MassProperties& m = scene_.robot.flat.row_mass[row];
  const SymmetricMatrix& I = m.I_C_B;
  std::array<double, 3> rotor{};
  if (row > 0 && scene_.robot.model.tree.joints[row - 1].servo) {
    const TreeRow& tree_row = scene_.robot.flat.table.rows[row];
    rotor[static_cast<std::size_t>(tree_row.axis)] = scene_.robot.model.tree.joints[row - 1].servo->armature;
  }
  dMass mass;
  dMassSetParameters(&mass, m.mass, 0, 0, 0, I.xx + rotor[0], I.yy + rotor[1], I.zz + rotor[2], I.xy, I.xz, I.yz);
  BodyOnRow& body = bodies_.emplace_back();
  body.id = dBodyCreate(world_);
  body.p_RC = m.p_BC_B;
  dBodySetMass(body.id, &mass);
}

void OdeRobot::addHinge(std::size_t row, const std::vector<Pose>& X_WR) {
  const TreeRow& tree_row = scene_.robot.flat.table.rows[row];
  const Joint& joint = scene_.robot.model.tree.joints[row - 1];
  if (tree_row.kind != JointKind::kRevolute) throw std::invalid_argument("ODE's robot has hinges only");
  Hinge& hinge = hinges_.emplace_back();
  hinge.id = dJointCreateHinge(world_, nullptr);
  hinge.servo = joint.servo.value_or(ServoParameters{});
  hinge.damping = joint.damping;
  dJointAttach(hinge.id, bodies_[row].id, bodies_[static_cast<std::size_t>(tree_row.parent)].id);
  const Vector3 p = X_WR[row].translation, a = X_WR[row].rotation * axisOf(tree_row);
  dJointSetHingeAnchor(hinge.id, p.x, p.y, p.z);
  dJointSetHingeAxis(hinge.id, a.x, a.y, a.z);
}

void OdeRobot::addSoles() {
  for (const Sole& sole : scene_.robot.model.soles) {
    const RowPlace box = soleBox(scene_.robot, sole);
    const BodyOnRow& body = bodies_[static_cast<std::size_t>(box.row)];
    dGeomID geom = soles_.emplace_back(dCreateBox(space_, sole.length, sole.width, kSoleThickness));
    dGeomSetBody(geom, body.id);
    const Vector3 p = box.X_RB.translation - body.p_RC;
    dGeomSetOffsetPosition(geom, p.x, p.y, p.z);
    dMatrix3 R;
    setRotation(box.X_RB.rotation, R);
    dGeomSetOffsetRotation(geom, R);
  }
}

std::vector<Pose> OdeRobot::rowPoses(const Pose& X_WB, const std::vector<double>& q) const {
  const std::vector<KernelRow> rows = kernelRows(scene_.robot.flat.table);
  std::vector<Pose> X_WR{X_WB};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    X_WR.push_back(childPose(X_WR[static_cast<std::size_t>(rows[i].parent)], rows[i], q[i - 1]));
  }
  return X_WR;
}

void OdeRobot::placeBodies(const std::vector<Pose>& X_WR) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Vector3 p = X_WR[i] * bodies_[i].p_RC;
    dMatrix3 R;
    setRotation(X_WR[i].rotation, R);
    dBodySetPosition(bodies_[i].id, p.x, p.y, p.z);
    dBodySetRotation(bodies_[i].id, R);
    dBodySetLinearVel(bodies_[i].id, 0, 0, 0);
    dBodySetAngularVel(bodies_[i].id, 0, 0, 0);
  }
}

void OdeRobot::place(const Pose& X_WB, const std::vector<double>& q) {
  placeBodies(rowPoses(X_WB, q));
  imu_velocity_last_ = {};
}

void OdeRobot::drive() {
  for (std::size_t j = 0; j < hinges_.size(); ++j) {
    const Hinge& hinge = hinges_[j];
    const ServoParameters& s = hinge.servo;
    const double q = dJointGetHingeAngle(hinge.id), dq = dJointGetHingeAngleRate(hinge.id);
    const double share = dq / s.no_load_speed;
    const double most = s.stall_torque * std::clamp(1 - share, 0.0, 1.0);
    const double least = -s.stall_torque * std::clamp(1 + share, 0.0, 1.0);
    const double torque = std::clamp(s.kp * (wanted_[j] - q) - s.kd * dq, least, most);
    dJointAddHingeTorque(hinge.id, torque - hinge.damping * dq);
  }
}

void OdeRobot::collide() {
  contacts_ = 0;
  for (dGeomID sole : soles_) {
    std::array<dContact, kContactsPerSole> contacts;
    const int count = dCollide(sole, ground_, kContactsPerSole, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      dContact& contact = contacts[static_cast<std::size_t>(i)];
      contact.surface.mode = dContactApprox1;
      contact.surface.mu = scene_.friction;
      dJointAttach(dJointCreateContact(world_, contact_group_, &contact), dGeomGetBody(sole), nullptr);
    }
    contacts_ += count;
  }
}

void OdeRobot::step() {
  imu_velocity_last_ = imuVelocity();
  drive();
  collide();
  dWorldQuickStep(world_, scene_.step);
  dJointGroupEmpty(contact_group_);
}

void OdeRobot::read(PeerSensors& sensors) const {
  for (std::size_t j = 0; j < hinges_.size(); ++j) {
    sensors.q[j] = dJointGetHingeAngle(hinges_[j].id);
    sensors.dq[j] = dJointGetHingeAngleRate(hinges_[j].id);
  }
  const auto row = static_cast<std::size_t>(imu_.row);
  const Rotation3 R_WI = rowPose(row).rotation * imu_.X_RB.rotation;
  const Vector3 a = (imuVelocity() - imu_velocity_last_) * (1 / scene_.step);
  sensors.gyroscope = applyTransposed(R_WI, vectorFrom(dBodyGetAngularVel(bodies_[row].id)));
  sensors.accelerometer = applyTransposed(R_WI, a + Vector3{0, 0, kGravity});
}

Pose OdeRobot::rowPose(std::size_t row) const {
  const Rotation3 R = rotationFrom(dBodyGetRotation(bodies_[row].id));
  return {R, vectorFrom(dBodyGetPosition(bodies_[row].id)) - R * bodies_[row].p_RC};
}

Vector3 OdeRobot::imuVelocity() const {
  const auto row = static_cast<std::size_t>(imu_.row);
  const dBodyID body = bodies_[row].id;
  const Vector3 arm = rotationFrom(dBodyGetRotation(body)) * (imu_.X_RB.translation - bodies_[row].p_RC);
  return vectorFrom(dBodyGetLinearVel(body)) + cross(vectorFrom(dBodyGetAngularVel(body)), arm);
}

double OdeRobot::height() const { return rowPose(0).translation.z; }

}  // namespace murosimf::peers
