// Robots of other teams: their joints move as the published ones, their devices bear the published names.
//
// Figures are those of github.com/RoboCup-Humanoid-TC/hlvs_webots, protos/robots, written out here once more.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "murosimf/algorithms/collision/detect_contact.h"
#include "murosimf/robot/urdf_reader.h"
#include "robot/published_guests.h"

namespace murosimf {
namespace {

const RobotModel& guest(const std::string& name) {
  static std::map<std::string, RobotModel> models;
  const auto known = models.find(name);
  if (known != models.end()) return known->second;
  Diagnostics diagnostics;
  ReadResult model = readUrdf(MUROSIMF_SOURCE_DIR "/robots/" + name + ".urdf", diagnostics);
  EXPECT_EQ(diagnostics.text(), "");
  return models.emplace(name, model ? *model : RobotModel{}).first->second;
}
const std::vector<std::string> kGuests{"darwin_op", "wolfgang", "nugus"};

const DeviceMount* find(const RobotModel& model, const std::string& device) {
  for (const DeviceMount& d : model.devices) {
    if (d.name == device) return &d;
  }
  return nullptr;
}
std::size_t jointOf(const RobotModel& model, const std::string& motor) {
  const DeviceMount* device = find(model, motor);
  if (device == nullptr || device->kind != MountedDevice::kMotor) throw std::runtime_error("no motor " + motor);
  return static_cast<std::size_t>(device->part);
}

TEST(Guests, JointsStandAndTurnWhereThePublishedOnesDoForTheSameCommands) {
  for (const published::Limb& limb : published::kLimbs) {
    const RobotModel& model = guest(limb.robot);
    for (const double step : {0.0, 0.3, -0.8}) {
      std::vector<double> q(model.tree.joints.size(), 0.0);
      double command = step;
      for (const published::Hinge& hinge : limb.hinges) q[jointOf(model, hinge.motor)] = command, command *= -0.7;
      const std::vector<Pose> elements = elementPoses(model.tree, q);
      Pose parent;
      for (const published::Hinge& hinge : limb.hinges) {
        const Joint& joint = model.tree.joints[jointOf(model, hinge.motor)];
        const Pose& here = elements[static_cast<std::size_t>(joint.element)];
        EXPECT_LT(norm(here.translation - parent * hinge.anchor), 2e-4) << hinge.motor << " at " << step;
        EXPECT_LT(norm(here.rotation * joint.axis - parent.rotation * hinge.axis), 1e-3) << hinge.motor;
        parent = parent * hinge.at(q[jointOf(model, hinge.motor)]);
      }
    }
  }
}

/// The first body that a joint turns, on the base.
MassProperties massOnBase(const RobotModel& model, std::size_t joint, const std::vector<Pose>& elements) {
  for (const Body& body : model.tree.bodies) {
    if (body.joint != static_cast<int>(joint)) continue;
    return moved(elements[static_cast<std::size_t>(body.element)], body.mass);
  }
  return {};
}

TEST(Guests, BodiesWeighAndSpreadTheirMassAsThePublishedOnesDo) {
  int bodies = 0;
  for (const published::Limb& limb : published::kLimbs) {
    const RobotModel& model = guest(limb.robot);
    const std::vector<Pose> elements = elementPoses(model.tree, std::vector<double>(model.tree.joints.size(), 0.0));
    Pose X_BaseBody;
    for (const published::Hinge& hinge : limb.hinges) {
      X_BaseBody = X_BaseBody * hinge.at(0);
      if (hinge.mass == 0) continue;
      ++bodies;
      const MassProperties expected = moved(X_BaseBody, hinge.bodyMass());
      const MassProperties ours = massOnBase(model, jointOf(model, hinge.motor), elements);
      EXPECT_NEAR(ours.mass, expected.mass, 1e-6) << hinge.motor;
      EXPECT_LT(norm(ours.p_BC_B - expected.p_BC_B), 2e-4) << hinge.motor;
      const SymmetricMatrix &I = ours.I_C_B, &J = expected.I_C_B;
      const double trace = J.xx + J.yy + J.zz;
      for (const auto& [a, b] :
           {std::pair{I.xx, J.xx}, {I.yy, J.yy}, {I.zz, J.zz}, {I.xy, J.xy}, {I.xz, J.xz}, {I.yz, J.yz}})
        EXPECT_NEAR(a, b, 2e-3 * trace) << hinge.motor;
    }
  }
  EXPECT_EQ(bodies, 24);
}

/// Middle of the sole of one side on the base, in the posture of these commands.
Vector3 soleOf(const RobotModel& model, Side side, const std::map<std::string, double>& commands) {
  std::vector<double> q(model.tree.joints.size(), 0.0);
  for (const auto& [motor, command] : commands) q[jointOf(model, motor)] = command;
  const std::vector<Pose> elements = elementPoses(model.tree, q);
  for (const Sole& sole : model.soles) {
    if (sole.side != side) continue;
    const Body& foot = model.tree.bodies[static_cast<std::size_t>(sole.body)];
    const Pose X_BaseSole = elements[static_cast<std::size_t>(foot.element)] * sole.X_BSole;
    EXPECT_NEAR(X_BaseSole.rotation.z.z, 1, 1e-6) << "the sole is to be level";
    return X_BaseSole.translation;
  }
  return {};
}

TEST(Guests, DarwinsSolesLieUnderItsHipsWhereItsLegsReach) {
  const RobotModel& darwin = guest("darwin_op");
  // Hip .122 below the shoulders, thigh and shank .093, sole .0337 below the ankle: half of a plate of .013 at .0272.
  EXPECT_LT(norm(soleOf(darwin, Side::kLeft, {}) - Vector3{-0.006, 0.0475, -0.122 - 0.186 - 0.0337}), 1e-4);
  const double bend = 0.6;
  const Vector3 bent{-0.006, 0.0475, -0.122 - 0.186 * std::cos(bend) - 0.0337};
  EXPECT_LT(
      norm(soleOf(darwin, Side::kLeft, {{"LegUpperL", bend}, {"LegLowerL", -2 * bend}, {"AnkleL", -bend}}) - bent),
      1e-4);
  const Vector3 right{bent.x, -bent.y, bent.z};
  EXPECT_LT(
      norm(soleOf(darwin, Side::kRight, {{"LegUpperR", -bend}, {"LegLowerR", 2 * bend}, {"AnkleR", bend}}) - right),
      1e-4);
}

TEST(Guests, NUgusBendsItsKneesAsMuchAsItsLegsAreLong) {
  const RobotModel& nugus = guest("nugus");
  const double bend = 0.5;
  const auto legs = [](double a, const std::string& side) {
    return std::map<std::string, double>{
        {side + "_hip_pitch", -a}, {side + "_knee_pitch", 2 * a}, {side + "_ankle_pitch", -a}};
  };
  const Vector3 straight = soleOf(nugus, Side::kRight, legs(0, "right"));
  // Ankle .44975 below the hips; a stud's sphere of .009 ends .0644 below it.
  EXPECT_NEAR(straight.z, -0.44975 - 0.0644, 2e-4);
  // The right thigh is .205 long and the shank .19975.
  const Vector3 moved = soleOf(nugus, Side::kRight, legs(bend, "right")) - straight;
  EXPECT_NEAR(moved.z, (0.205 + 0.19975) * (1 - std::cos(bend)), 1e-4);
  EXPECT_NEAR(moved.x, (0.205 - 0.19975) * std::sin(bend), 1e-4);
}

TEST(Guests, HaveThePublishedMass) {
  // Sums of all bodies' masses; Darwin has four crosses of a gear's mass, .001 kg, besides.
  const double darwin = 0.975599 + 0.0243577 + 0.158042 +
                        2 * (0.1774664 + 0.1357538 + 0.095376 + 0.221488 + 0.025913 + 0.168377 + 0.0592885);
  EXPECT_NEAR(guest("darwin_op").tree.mass(), darwin + 4 * 0.001, 1e-6);
  const double wolfgang = 2.0839 + 0.148233 + 0.301358 +
                          2 * (0.041445 + 0.228498 + 0.207774 + 0.068973 + 0.319807 + 0.242311 + 0.088064 + 0.319807 +
                               0.26824 + 4 * 0.00166);
  EXPECT_NEAR(guest("wolfgang").tree.mass(), wolfgang, 1e-6);
  const double nugus =
      2.539 + 0.135 + 0.419 + 2 * (0.025434 + 0.297 + 0.26 + 0.067 + 0.306 + 0.387 + 0.177 + 0.306 + 0.205 + 4 * 0.02);
  EXPECT_NEAR(guest("nugus").tree.mass(), nugus, 1e-6);
}

using DeviceList = std::vector<std::pair<MountedDevice, std::string>>;

DeviceList devicesOfDarwin() {
  DeviceList list;
  for (const std::string motor : {"Neck",
                                  "Head",
                                  "ShoulderL[shoulder]",
                                  "ShoulderR[shoulder]",
                                  "ArmUpperL",
                                  "ArmUpperR",
                                  "ArmLowerL",
                                  "ArmLowerR",
                                  "PelvYL",
                                  "PelvYR",
                                  "PelvL[hip]",
                                  "PelvR[hip]",
                                  "LegUpperL",
                                  "LegUpperR",
                                  "LegLowerL",
                                  "LegLowerR",
                                  "AnkleL",
                                  "AnkleR",
                                  "FootL",
                                  "FootR"}) {
    list.emplace_back(MountedDevice::kMotor, motor);
    list.emplace_back(MountedDevice::kPositionSensor, motor.substr(0, motor.find('[')) + "S");
  }
  list.emplace_back(MountedDevice::kImuAccelerometer, "Accelerometer");
  list.emplace_back(MountedDevice::kImuGyro, "Gyro");
  list.emplace_back(MountedDevice::kCamera, "Camera");
  list.emplace_back(MountedDevice::kCamera, "Camera2");
  return list;
}

DeviceList devicesOfWolfgang() {
  DeviceList list;
  const auto motor = [&list](const std::string& name) {
    list.emplace_back(MountedDevice::kMotor, name);
    list.emplace_back(MountedDevice::kPositionSensor, name + "_sensor");
  };
  for (const std::string side : {"R", "L"}) {
    for (const char* joint : {"ShoulderPitch [shoulder]", "ShoulderRoll", "Elbow", "HipYaw", "HipRoll [hip]",
                              "HipPitch", "Knee", "AnklePitch", "AnkleRoll"})
      motor(side + joint);
  }
  motor("HeadPan"), motor("HeadTilt");
  for (const char* cleat : {"llb", "llf", "lrf", "lrb", "rlb", "rlf", "rrf", "rrb"})
    list.emplace_back(MountedDevice::kForce, cleat);
  for (const std::string imu : {"imu", "imu_head"}) {
    list.emplace_back(MountedDevice::kImuAccelerometer, imu + " accelerometer");
    list.emplace_back(MountedDevice::kImuGyro, imu + " gyro");
  }
  list.emplace_back(MountedDevice::kCamera, "camera");
  return list;
}

DeviceList devicesOfNugus() {
  DeviceList list;
  const auto motor = [&list](const std::string& name, const std::string& tag = "") {
    list.emplace_back(MountedDevice::kMotor, name + tag);
    list.emplace_back(MountedDevice::kPositionSensor, name + "_sensor");
  };
  for (const std::string side : {"left_", "right_"}) {
    motor(side + "shoulder_pitch", " [shoulder]"), motor(side + "shoulder_roll"), motor(side + "elbow_pitch");
    motor(side + "hip_yaw"), motor(side + "hip_roll", " [hip]"), motor(side + "hip_pitch");
    motor(side + "knee_pitch"), motor(side + "ankle_pitch"), motor(side + "ankle_roll");
    for (const char* corner : {"bl", "br", "fl", "fr"})
      list.emplace_back(MountedDevice::kBumper, side + "touch_sensor_" + corner);
    list.emplace_back(MountedDevice::kCamera, side + "camera");
  }
  motor("neck_yaw"), motor("head_pitch");
  list.emplace_back(MountedDevice::kImuAccelerometer, "accelerometer");
  list.emplace_back(MountedDevice::kImuGyro, "gyroscope");
  return list;
}

TEST(Guests, HaveAllPublishedDevicesAndNoOthers) {
  const std::map<std::string, DeviceList> published{
      {"darwin_op", devicesOfDarwin()}, {"wolfgang", devicesOfWolfgang()}, {"nugus", devicesOfNugus()}};
  for (const auto& [name, list] : published) {
    const RobotModel& model = guest(name);
    for (const auto& [kind, device] : list) {
      const DeviceMount* found = find(model, device);
      ASSERT_NE(found, nullptr) << name << " has no " << device;
      EXPECT_EQ(found->kind, kind) << name << ": " << device;
    }
    EXPECT_EQ(model.devices.size(), list.size()) << name;
    EXPECT_EQ(model.tree.joints.size(), 20U) << name;
  }
}

TEST(Guests, CornersOfWolfgangsFeetLieWhereTheirNamesSay) {
  const RobotModel& wolfgang = guest("wolfgang");
  for (const std::string foot : {"l", "r"}) {
    for (const std::string side : {"l", "r"}) {
      for (const std::string end : {"b", "f"}) {
        const DeviceMount* device = find(wolfgang, foot + side + end);
        ASSERT_NE(device, nullptr);
        EXPECT_EQ(wolfgang.soles[static_cast<std::size_t>(device->part)].side,
                  foot == "l" ? Side::kLeft : Side::kRight);
        const std::string corner = std::string(end == "b" ? "rear_" : "front_") + (side == "l" ? "left" : "right");
        EXPECT_EQ(kSoleCorners[device->corner], corner) << foot + side + end;
      }
    }
  }
}

TEST(Guests, SensorsReadInThePublishedNumbers) {
  const auto reading = [](const std::string& robot, const char* device, double value) {
    const DeviceMount* d = find(guest(robot), device);
    return clamp(d->offset + d->scale * value, d->lowest, d->highest);
  };
  // Ends of the published look-up tables, and beyond.
  EXPECT_NEAR(reading("darwin_op", "Accelerometer", -39.24), 0, 1e-3);
  EXPECT_NEAR(reading("darwin_op", "Accelerometer", 39.24), 1024, 1e-3);
  EXPECT_EQ(reading("darwin_op", "Accelerometer", 100), 1024);
  EXPECT_NEAR(reading("darwin_op", "Gyro", -27.925), 0, 1e-3);
  EXPECT_NEAR(reading("darwin_op", "Gyro", 27.925), 1024, 1e-3);
  EXPECT_NEAR(reading("nugus", "accelerometer", 9.81), 109.81, 1e-9);
  EXPECT_EQ(reading("nugus", "accelerometer", -50), 60.76);
  EXPECT_NEAR(reading("nugus", "gyroscope", 8.72665), 108.762, 1e-4);
  EXPECT_NEAR(reading("nugus", "gyroscope", -8.72665), 91.238, 1e-4);
  EXPECT_EQ(reading("wolfgang", "imu accelerometer", 9.81), 9.81);
  EXPECT_EQ(reading("wolfgang", "imu_head gyro", 40), 34.90659);
}

TEST(Guests, DarwinsAccelerometerPointsItsXAxisRightAndItsGyroBackward) {
  const RobotModel& darwin = guest("darwin_op");
  const auto unit = [&](const char* device) -> const ImuMount& {
    return darwin.imus[static_cast<std::size_t>(find(darwin, device)->part)];
  };
  // Turned about z by -pi/2 and by pi.
  EXPECT_LT(norm(unit("Accelerometer").X_BI.rotation.x - Vector3{0, -1, 0}), 1e-9);
  EXPECT_LT(norm(unit("Gyro").X_BI.rotation.x - Vector3{-1, 0, 0}), 1e-9);
}

std::vector<double> restOf(const RobotModel& model) {
  std::vector<double> q;
  for (const Joint& joint : model.tree.joints) {
    const auto told = model.properties.find({joint.name, "initial_position"});
    q.push_back(told == model.properties.end() ? 0.0 : told->second.numbers.at(0));
    EXPECT_GE(q.back(), joint.limits.lower) << joint.name;
    EXPECT_LE(q.back(), joint.limits.upper) << joint.name;
  }
  return q;
}

bool touch(const BodyShape& a, const Pose& X_WA, const BodyShape& b, const Pose& X_WB) {
  ContactManifold found;
  detectContact(collisionShapeOf(a.shape, a.hull.get()), X_WA * a.X_BS, collisionShapeOf(b.shape, b.hull.get()),
                X_WB * b.X_BS, found);
  return found.count > 0;
}

/// Pairs of bodies that touch and may touch, and how many pairs of shapes were looked at.
int lookForContacts(const RobotModel& model, const std::vector<double>& q, std::vector<std::string>& touching) {
  const std::vector<Pose> elements = elementPoses(model.tree, q);
  const std::vector<Body>& bodies = model.tree.bodies;
  int pairs = 0;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      if (model.ignoresContact(static_cast<int>(a), static_cast<int>(b))) continue;
      for (const BodyShape& s : bodies[a].shapes) {
        for (const BodyShape& other : bodies[b].shapes) {
          if (!s.collides || !other.collides) continue;
          ++pairs;
          if (touch(s, elements[static_cast<std::size_t>(bodies[a].element)], other,
                    elements[static_cast<std::size_t>(bodies[b].element)]))
            touching.push_back(bodies[a].name + " " + bodies[b].name);
        }
      }
    }
  }
  return pairs;
}

TEST(Guests, NoBodyTouchesAnotherAtRestNorWithStraightLegs) {
  for (const std::string& name : kGuests) {
    const RobotModel& model = guest(name);
    std::vector<std::string> touching;
    EXPECT_GT(lookForContacts(model, restOf(model), touching), 60) << name;
    lookForContacts(model, std::vector<double>(20, 0.0), touching);
    EXPECT_EQ(touching, std::vector<std::string>{}) << name;
  }
}

}  // namespace
}  // namespace murosimf
