// Sensors of robots with dynamics against what the laws of motion say that they feel.

#include <gtest/gtest.h>

#include "book/page.h"
#include "modules/single_body.h"

namespace murosimf::motion {
namespace {

constexpr double kG = 9.81;

/// A box that carries an inertial measurement unit at p, turned by R.
RobotBlueprint boxWithImu(const Pose& X_BI) {
  RobotBlueprint print = bodyOf(makeBox({0.2, 0.1, 0.06}), boxMass(2, {0.2, 0.1, 0.06}, {}));
  ImuMount imu;
  imu.name = "imu", imu.body = 0, imu.X_BI = X_BI;
  print.model.imus.push_back(imu);
  return print;
}

SurfacePair hardGround() {
  SurfacePair pair;
  pair.stiffness = 1e4, pair.dissipation = 20;
  return pair;
}

TEST(DynamicInertialSensor, AtRestItFeelsTheGroundPushUpwardInItsOwnAxes) {
  book::Page page({book::Chapter::kSensors,
                   "At rest an accelerometer feels the ground push upward in its own axes",
                   R"(f_y = g \sin\alpha, \quad f_z = g \cos\alpha)",
                   "Specific force of a body at rest",
                   {{"\\alpha", "the unit is mounted turned about x by it", "rad"}},
                   {"angle $\\alpha$", "rad"},
                   {"specific force $f$", "m/s^2"}});
  page.series("$f_y$").curve(-1.5, 1.5, [](double angle) { return kG * std::sin(angle); });
  page.series("$f_z$").curve(-1.5, 1.5, [](double angle) { return kG * std::cos(angle); });
  for (const double angle : {-1.5, -0.5, 0.0, 0.5, 1.5}) {
    const Rotation3 R_BI = rotationX(angle) * rotationZ(angle == 0.5 ? 0.3 : 0);
    SingleBody b(boxWithImu({R_BI, {0.05, 0.02, 0.01}}), hardGround(), 1e-3, "hunt_crossley_contact", "implicit_euler");
    b.set({rotationZ(1.0), {0, 0, 0.03 - 2 * kG / 1e4}});
    b.run(0.5);
    EXPECT_LT(norm(b.accelerometer() - applyTransposed(R_BI, Vector3{0, 0, kG})), 1e-9);
    EXPECT_LT(norm(b.gyroscope()), 1e-9);
    if (angle == 0.5) continue;  // turned about z too
    EXPECT_TRUE(page.series("$f_y$").near(angle, b.accelerometer().y, kG * std::sin(angle), 1e-9));
    EXPECT_TRUE(page.series("$f_z$").near(angle, b.accelerometer().z, kG * std::cos(angle), 1e-9));
  }
}

TEST(DynamicInertialSensor, InFreeFallItFeelsOnlyItsCircleAboutTheCentreOfMass) {
  book::Page page({book::Chapter::kSensors,
                   "In free fall an accelerometer feels only its circle about the centre of mass",
                   R"(f = -\omega^2 p_x)",
                   "Specific force of a point of a falling body that spins about a principal axis",
                   {{"p_x", "place of the unit, here 0.05", "m"}},
                   {"rate $\\omega$", "rad/s"},
                   {"specific force along x $f$", "m/s^2"}});
  const Vector3 p{0.05, 0.02, 0.01};
  page.curve(0, 10, [&](double rate) { return -rate * rate * p.x; });
  for (const double rate : {0.0, 3.0, 7.0, 10.0}) {
    const Vector3 w{0, 0, rate};
    SingleBody b(boxWithImu({Rotation3{}, p}), hardGround(), 1e-3, "hunt_crossley_contact", "runge_kutta_4");
    b.set({rotationX(0.4), {0, 0, 5}}, {w, {1, 2, 3}});  // about a principal axis: w stays
    b.run(0.2);
    EXPECT_TRUE(page.near(rate, b.accelerometer().x, -rate * rate * p.x, 1e-9));
    EXPECT_LT(norm(b.accelerometer() - cross(w, cross(w, p))), 1e-9);
    EXPECT_LT(norm(b.gyroscope() - w), 1e-9);
  }
}

struct Standing {
  Vector3 centre_of_pressure, centre_of_mass;  // in W
  double force = 0, mass = 0;
};

/// KS21 with the feet as in walking and its hips turned forward by `lean` [rad], when it has come to rest.
Standing standing(double lean) {
  constexpr std::size_t kHipPitches[2] = {11, 17};
  std::vector<double> q = gait(0, {}, 0);
  for (const std::size_t hip : kHipPitches) q[hip] -= lean;
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", ks21(), q);
  DynamicLevel level = multibody();
  level.modules.emplace_back("foot_pressure");
  world.link(level);
  world.run(10);
  const auto soles = *world.world().findShared(robot, kSoles);
  const std::vector<KernelRow> rows = kernelRows(ks21().flat.table);
  std::vector<Pose> X{world.base(robot)};
  Standing all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int row = static_cast<int>(i);
    if (row > 0) {
      X.push_back(childPose(X[static_cast<std::size_t>(rows[i].parent)], rows[i],
                            world.get(robot, kJointPosition, subset::kJoints, row - 1)));
    }
    const RigidInertia<double> body =
        *world.world().find(world.world().members(robot, subset::kBodies)[i], kBodyInertia);
    all.mass += body.m;
    all.centre_of_mass += X[i] * (body.mc * (1 / body.m)) * body.m;
  }
  all.centre_of_mass = all.centre_of_mass * (1 / all.mass);
  for (int s = 0; s < 2; ++s) {
    const SolePlace& sole = soles[static_cast<std::size_t>(s)];
    const CornerForces<> corners = world.get(robot, kSolePressure, subset::kSoles, s);
    for (int k = 0; k < 4; ++k) {
      const Vector3 corner{(k & 1) != 0 ? sole.half_length : -sole.half_length,
                           (k & 2) != 0 ? sole.half_width : -sole.half_width, 0};
      all.force += corners.of[k];
      all.centre_of_pressure += X[static_cast<std::size_t>(sole.mount.row)] * sole.mount.X_RM * corner * corners.of[k];
    }
  }
  all.centre_of_pressure = all.centre_of_pressure * (1 / all.force);
  return all;
}

TEST(FootPressure, OfAStandingRobotIsItsWeightAndItsCentreLiesUnderTheCentreOfMass) {
  book::Page page({book::Chapter::kSensors,
                   "The centre of pressure of a standing robot lies under its centre of mass, however it leans",
                   R"(\frac{\sum f_i p_i}{\sum f_i} = \frac{\sum m_k c_k}{\sum m_k}, \quad \sum f_i = m g)",
                   "Statics: balance of forces and moments; horizontal coordinates",
                   {{"f_i, p_i", "forces that the corners of the soles read, and where these are", "N, m"},
                    {"m_k, c_k", "masses of KS21's bodies, and where their centres are", "kg, m"}},
                   {"turn of both hips forward", "rad"},
                   {"centre of pressure from where the robot was put", "m"}});
  for (const double lean : {-0.08, -0.04, 0.0, 0.04, 0.08}) {
    const Standing robot = standing(lean);
    EXPECT_NEAR(robot.force, robot.mass * kG, 1e-3 * robot.mass * kG) << lean;
    EXPECT_TRUE(page.series("forward").near(lean, robot.centre_of_pressure.x, robot.centre_of_mass.x, 1e-5));
    EXPECT_TRUE(page.series("to the left").near(lean, robot.centre_of_pressure.y, robot.centre_of_mass.y, 1e-5));
  }
}

TEST(JointTorqueSensor, OfAStandingRobotHoldsWhatHangsOnTheJoints) {
  DynamicWorld world(1e-3);
  const ObjectId robot = world.add("robot", ks21(), gait(0, {}, 0));
  DynamicLevel level = multibody();
  level.modules.emplace_back("joint_torque_sensor");
  world.link(level);
  world.run(3);
  // At rest each servo's torque is its gain times how far it gives way; the elbow carries its forearm alone.
  const std::vector<double> wanted = gait(0, {}, 0);
  for (int j = 0; j < 21; ++j) {
    const ObjectId joint = world.world().members(robot, subset::kJoints)[static_cast<std::size_t>(j)];
    const double gain = *world.world().find(joint, kServoStiffness);
    const double error = wanted[static_cast<std::size_t>(j)] - world.get(robot, kJointPosition, subset::kJoints, j);
    EXPECT_NEAR(world.get(robot, kMeasuredTorque, subset::kJoints, j), gain * error, 2e-4) << j;
  }
  const double knee = world.get(robot, kMeasuredTorque, subset::kJoints, 12);
  EXPECT_NEAR(std::fabs(knee), 0.62, 0.08);  // ks21's table of torques: walk-ready, two legs
}

}  // namespace
}  // namespace murosimf::motion
