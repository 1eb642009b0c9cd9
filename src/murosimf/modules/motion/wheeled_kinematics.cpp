#include "murosimf/modules/motion/wheeled_kinematics.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "murosimf/algorithms/centroidal_motion.h"
#include "murosimf/algorithms/gravity.h"
#include "murosimf/linking/links.h"

namespace murosimf {

namespace {

constexpr Variable<PlanarBody<double>> kPlanarBody{"planar_body", "SI", "mass, inertia about z, centre of mass x and y",
                                                   Storage::kKept};
constexpr double kLevel = 1e-3;  // sine of an axle's tilt
constexpr double kEven = 5e-3;   // [m] by which a wheel may hang above the others

double* numbersOf(const BlockMemory& block, ColumnRef column, int width) {
  return block.piece[static_cast<int>(column.memory)] + column.offset * width;
}

/// Sums of places, 1, x and y, of all wheels.
struct Spread {
  double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  double determinant() const { return n * (xx * yy - xy * xy) - x * (x * yy - xy * y) + y * (x * xy - xx * y); }
};
Spread spreadOf(const std::vector<PlanarWheel>& wheels) {
  Spread s;
  for (const PlanarWheel& w : wheels) {
    s.n += 1, s.x += w.x, s.y += w.y;
    s.xx += w.x * w.x, s.yy += w.y * w.y, s.xy += w.x * w.y;
  }
  return s;
}

/// Loads a + b x + c y that carry a weight at a place: what equal springs below a rigid body do.
struct LoadPlane {
  double a, b, c;
};
LoadPlane loadPlane(const Spread& s, double weight, double x, double y) {
  const double per = weight / s.determinant();
  const double xx = s.xx * s.yy - s.xy * s.xy, xy = s.xy * s.y - s.x * s.yy, xz = s.x * s.xy - s.xx * s.y;
  const double yy = s.n * s.yy - s.y * s.y, yz = s.x * s.y - s.n * s.xy, zz = s.n * s.xx - s.x * s.x;
  return {per * (xx + xy * x + xz * y), per * (xy + yy * x + yz * y), per * (xz + yz * x + zz * y)};
}

}  // namespace

void WheeledKinematics::declare(Declaration& d) const {
  d.runsIn(Phase::kAdvance);
  d.needs(kTree);
  d.needs(kWheels);
  d.needs(kWheelFriction, subset::kWheels);
  d.needs(kWheelStickSpeed, subset::kWheels);
  d.needs(kWheelCreepage, subset::kWheels);
  d.needs(kBodyInertia, subset::kBodies);
  d.uses(kInitialPosition, 0.0, subset::kJoints);
  d.reads(kJointRateDemand, subset::kJoints);
  d.adds(kJointPosition, subset::kJoints);
  d.adds(kJointVelocity, subset::kJoints);
  d.adds(kBasePose);
  d.adds(kBaseVelocity);
  d.adds(kPairForce, subset::kBodies);
  d.adds(kPairTouch);
  joints_yield_.declare(d);
  manner_.declare(d);
  d.adds(kPlanarBody);
  d.adds(kWheelLoad, subset::kWheels);
  d.adds(kWheelSlip, subset::kWheels);
}

void WheeledKinematics::placeWheels(const TreeTable& tree, const std::vector<WheelPlace>& places) {
  for (const WheelPlace& place : places) {
    const std::size_t number = wheels_.size() + 1;
    const TreeRow& row = tree.rows[static_cast<std::size_t>(place.row)];
    const bool castor = place.kind == WheelKind::kCastor;
    if ((castor ? place.row : row.parent) != 0)
      throw std::invalid_argument(
          fmt::format("wheel {} of the robot hangs on another joint than its own; expected one "
                      "on the base",
                      number));
    const Pose X_BR = castor ? Pose{} : row.X_PF;
    const Vector3 p = X_BR * place.centre, axle = X_BR.rotation * place.axle;
    if (!castor && abs(axle.z) > kLevel)
      throw std::invalid_argument(fmt::format(
          "the axle of wheel {} of the robot is tilted by {:.3g} rad; expected a level one", number, asin(axle.z)));
    PlanarWheel& wheel = wheels_.emplace_back();
    wheel.x = p.x, wheel.y = p.y;
    heights_.push_back(p.z - place.radius);
    if (castor) continue;
    const double length = sqrt(axle.x * axle.x + axle.y * axle.y);
    wheel.drive_x = axle.y / length, wheel.drive_y = -axle.x / length;
    const SinCos<double> angle = sincos(place.roller_angle);
    wheel.roller_x = angle.cos * wheel.drive_x - angle.sin * wheel.drive_y;
    wheel.roller_y = angle.sin * wheel.drive_x + angle.cos * wheel.drive_y;
    wheel.radius = place.radius;
    wheel.rollers = place.kind == WheelKind::kRollers;
    wheel.joint = place.row - 1;
  }
}

void WheeledKinematics::checkStand(const std::vector<WheelPlace>& places) const {
  const double lowest = *std::min_element(heights_.begin(), heights_.end());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (heights_[i] - lowest > kEven)
      throw std::invalid_argument(
          fmt::format("wheel {} of the robot hangs {:.3g} m above the ground on which the "
                      "lowest one stands; expected all within {} m",
                      i + 1, heights_[i] - lowest, kEven));
  }
  const Spread s = spreadOf(wheels_);
  const double size = s.xx + s.yy;
  if (s.n < 3 || s.determinant() < 1e-6 * size * size)
    throw std::invalid_argument(
        fmt::format("the robot has {} wheels and castors that stand in one line; expected three "
                    "that do not, as without its balance it would fall",
                    places.size()));
}

void WheeledKinematics::link(Links& links) {
  const TreeTable tree = links.shared(kTree);
  const std::vector<WheelPlace> places = links.shared(kWheels);
  placeWheels(tree, places);
  checkStand(places);
  rows_ = kernelRows(tree);
  WheeledKinematicsArguments& a = arguments_;
  a.rows = rows_.data(), a.bodies = tree.bodyCount();
  a.wheels = wheels_.data(), a.count = static_cast<int>(wheels_.size());
  a.height = -*std::min_element(heights_.begin(), heights_.end());
  a.q = links.column(kJointPosition, subset::kJoints);
  a.dq = links.column(kJointVelocity, subset::kJoints);
  a.demand = links.column(kJointRateDemand, subset::kJoints);
  a.base_pose = links.column(kBasePose);
  a.base_velocity = links.column(kBaseVelocity);
  a.pair_touch = links.column(kPairTouch);
  a.pair_force = links.column(kPairForce, subset::kBodies);
  a.body = links.column(kPlanarBody);
  a.load = links.column(kWheelLoad, subset::kWheels);
  a.slip = links.column(kWheelSlip, subset::kWheels);
  a.friction = links.column(kWheelFriction, subset::kWheels);
  a.stick_speed = links.column(kWheelStickSpeed, subset::kWheels);
  a.creepage = links.column(kWheelCreepage, subset::kWheels);
  joints_yield_.link(links);
  manner_.link(links);
  initial_ = links.column(kInitialPosition, subset::kJoints);
  inertia_ = links.column(kBodyInertia, subset::kBodies);
  width_ = links.width();
  kernel_ = kernelOfWidth<WheeledKinematicsArguments>(width_);
}

void WheeledKinematics::initialise(const BlockMemory& block) const {
  copyColumn(block, initial_, arguments_.q, arguments_.bodies - 1, width_);
  joints_yield_.initialise(block);
  manner_.initialise(block);
  for (int lane = 0; lane < width_; ++lane) weigh(block, lane);
}

/// Mass, centre and loads of the robot in its first posture.
void WheeledKinematics::weigh(const BlockMemory& block, int lane) const {
  const LaneValues<RigidInertia<double>> inertia(numbersOf(block, inertia_, width_) + lane, width_);
  const LaneValues<double> first(numbersOf(block, initial_, width_) + lane, width_);
  std::vector<Pose> X_BR(rows_.size());
  RigidInertia<double> all;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const int row = static_cast<int>(i);
    if (row > 0) X_BR[i] = childPose(X_BR[static_cast<std::size_t>(rows_[i].parent)], rows_[i], first.get(row - 1));
    const RigidInertia<double> there = inertia.get(row);
    const Rotation3& R = X_BR[i].rotation;
    all += shifted(RigidInertia<double>{there.m, R * there.mc, turned(R, there.I)}, X_BR[i].translation);
  }
  const Vector3 centre = all.mc * (1 / all.m);
  LaneValues<PlanarBody<double>>(numbersOf(block, arguments_.body, width_) + lane, width_)
      .set({all.m, aboutCentre(all, centre).zz, centre.x, centre.y});
  const LoadPlane plane = loadPlane(spreadOf(wheels_), all.m * kGravity, centre.x, centre.y);
  const LaneValues<double> loads(numbersOf(block, arguments_.load, width_) + lane, width_);
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const double load = plane.a + plane.b * wheels_[i].x + plane.c * wheels_[i].y;
    if (load < 0)
      throw std::invalid_argument(
          fmt::format("wheel {} of the robot carries {:.3g} N and would lift off: its centre of "
                      "mass lies at ({:.3g}, {:.3g}) m; expected it between wheels and castors",
                      i + 1, load, centre.x, centre.y));
    loads.set(load, static_cast<int>(i));
  }
}

void WheeledKinematics::adopt(const BlockMemory& one) const {
  joints_yield_.adopt(one);
  manner_.adopt(one);
  const LaneValues<Pose> pose(numbersOf(one, arguments_.base_pose, 1), 1);
  const Pose X_WB = pose.get();
  pose.set({rotationZ(atan2(X_WB.rotation.x.y, X_WB.rotation.x.x)),
            {X_WB.translation.x, X_WB.translation.y, arguments_.height}});
}

}  // namespace murosimf
