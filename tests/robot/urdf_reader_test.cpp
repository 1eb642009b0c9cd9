/// @file What URDF and its extension elements mean.

#include "murosimf/robot/urdf_reader.h"

#include <gtest/gtest.h>

#include <limits>

#include "murosimf/robot/flatten_tree.h"

namespace murosimf {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
const std::string kInertial = "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>";

struct Reading {
  ReadResult model;
  Diagnostics diagnostics;
};

/// Reads a robot whose root element holds this text.
Reading read(const std::string& inside) {
  Reading out;
  out.model = readUrdfText("<robot name='test'>" + inside + "</robot>", "test.urdf", out.diagnostics);
  return out;
}

/// A trunk with an arm on joint "shoulder", which is described by the text.
std::string withShoulder(const std::string& type, const std::string& joint) {
  return "<link name='trunk'>" + kInertial + "</link><link name='arm'>" + kInertial +
         "</link><joint name='shoulder' type='" + type + "'><parent link='trunk'/><child link='arm'/>" + joint +
         "</joint>";
}

TEST(UrdfReader, OriginIsATranslationAndThenRollPitchYawAboutFixedAxes) {
  const Reading r = read(withShoulder(
      "continuous",
      "<origin xyz='1 2 3' rpy='0.1 0.2 0.3'/><axis xyz='0 0 2'/><dynamics damping='.5' friction='0.1'/>"));
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  const FlatTree flat = flattenTree(r.model->tree);
  EXPECT_EQ(flat.table.rows[1].X_PF.translation, (Vector3{1, 2, 3}));
  EXPECT_EQ(flat.table.rows[1].X_PF.rotation, rotationZ(0.3) * (rotationY(0.2) * rotationX(0.1)));
  EXPECT_EQ(flat.table.rows[1].axis, 2);
  EXPECT_TRUE(flat.table.rows[1].turned);
  const Joint& joint = r.model->tree.joints[0];
  EXPECT_EQ(joint.limits, JointLimits{});
  EXPECT_EQ(joint.damping, 0.5);
  EXPECT_EQ(joint.friction, 0.1);
}

TEST(UrdfReader, JointWithoutAxisTurnsAboutX) {
  const Reading r = read(withShoulder("prismatic", "<limit lower='-1' upper='2' effort='3' velocity='4'/>"));
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  EXPECT_EQ(r.model->tree.joints[0].axis, kAxisX);
  EXPECT_EQ(r.model->tree.joints[0].kind, JointKind::kPrismatic);
  EXPECT_EQ(r.model->tree.joints[0].limits, (JointLimits{-1, 2, 4, 3}));
}

TEST(UrdfReader, ZeroEffortOrVelocityIsWarnedOfAndIsNoLimit) {
  const Reading r = read(withShoulder("continuous", "<limit effort='0' velocity='0'/>"));
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  EXPECT_EQ(r.model->tree.joints[0].limits.largest_torque, kNone);
  EXPECT_EQ(r.model->tree.joints[0].limits.largest_velocity, kNone);
  EXPECT_EQ(r.diagnostics.text(),
            "test.urdf:1: warning: <limit>: effort is 0: the joint could not push; taken as no limit\n"
            "test.urdf:1: warning: <limit>: velocity is 0: the joint could not move; taken as no limit\n");
}

TEST(UrdfReader, FixedJointsMakeNoRow) {
  const Reading r = read(withShoulder("fixed", "<origin xyz='0 0 1'/>"));
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  const FlatTree flat = flattenTree(r.model->tree);
  EXPECT_EQ(flat.table.bodyCount(), 1);
  EXPECT_EQ(flat.row_mass[0].mass, 2);
  EXPECT_EQ(flat.bodies[1].X_RB.translation, kAxisZ);
}

TEST(UrdfReader, InertiaIsTurnedIntoTheAxesOfTheLink) {
  const Reading r = read(
      "<link name='trunk'><inertial><origin xyz='1 0 0' rpy='0 0 1.5707963267948966'/><mass value='2'/>"
      "<inertia ixx='1' iyy='2' izz='2.5'/></inertial></link>");
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  const MassProperties& mass = r.model->tree.bodies[0].mass;
  EXPECT_EQ(mass.p_BC_B, kAxisX);
  EXPECT_NEAR(mass.I_C_B.xx, 2, 1e-15);
  EXPECT_NEAR(mass.I_C_B.yy, 1, 1e-15);
}

TEST(UrdfReader, ShapesDrawnAndTouchingInTheSamePlaceAreOne) {
  const Reading r = read(
      "<murosimf surface='rubber'/><material name='pink'><color rgba='1 0.5 0.75 1'/></material><link name='trunk'>" +
      kInertial +
      "<visual><geometry><box size='1 2 3'/></geometry><material name='pink'/></visual>"
      "<visual><geometry><sphere radius='2'/></geometry><murosimf colour='team'/></visual>"
      "<collision><geometry><box size='1 2 3'/></geometry></collision>"
      "<collision><origin xyz='0 0 1'/><geometry><cylinder radius='1' length='4'/></geometry>"
      "<murosimf surface='ice'/></collision>"
      "<collision><geometry><ellipsoid radii='1 2 3'/></geometry></collision></link>");
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  const std::vector<BodyShape>& shapes = r.model->tree.bodies[0].shapes;
  ASSERT_EQ(shapes.size(), 4U);
  EXPECT_TRUE(shapes[0].drawn && shapes[0].collides);
  EXPECT_EQ(shapes[0].colour, (Colour{1, 0.5F, 0.75F}));
  EXPECT_EQ(shapes[0].surface, "rubber");
  EXPECT_EQ(shapes[0].shape.half_size, (Vector3{0.5, 1, 1.5}));
  EXPECT_TRUE(shapes[1].drawn && !shapes[1].collides && shapes[1].team_colour);
  EXPECT_EQ(shapes[1].shape.kind, ShapeKind::kEllipsoid);
  EXPECT_TRUE(!shapes[2].drawn && shapes[2].collides);
  EXPECT_EQ(shapes[2].surface, "ice");
  EXPECT_EQ(shapes[2].shape.half_size, (Vector3{1, 1, 2}));
  EXPECT_EQ(shapes[3].shape.half_size, (Vector3{1, 2, 3}));
}

TEST(UrdfReader, LinkThatIsOnlyDrawnIsWarnedOfUnlessItSaysSo) {
  const std::string visual = kInertial + "<visual><geometry><sphere radius='1'/></geometry></visual>";
  const Reading silent = read("<link name='trunk'>" + visual + "</link>");
  EXPECT_TRUE(silent.model.has_value());
  EXPECT_NE(silent.diagnostics.text().find("warning: <link>: \"trunk\" is drawn but has no <collision>"),
            std::string::npos);
  const Reading said = read("<link name='trunk'>" + visual + "<murosimf collides='false'/></link>");
  EXPECT_TRUE(said.model.has_value());
  EXPECT_EQ(said.diagnostics.text(), "");
}

TEST(UrdfReader, NumbersAtTheServoGoBeforeThoseOfItsType) {
  const Reading r = read(
      "<murosimf><servo_type name='MX-28' stall_torque='2.5' no_load_speed='6' kp='20' kd='0.4' resolution='0.01'/>"
      "</murosimf>" +
      withShoulder("continuous", "<murosimf><servo type='MX-28' kp='25'/></murosimf>"));
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  EXPECT_EQ(r.model->tree.joints[0].servo, (ServoParameters{"MX-28", 2.5, 6, 25, 0.4, 0, 0.01}));
  ASSERT_EQ(r.model->joint_sensors.size(), 1U);
  EXPECT_EQ(r.model->joint_sensors[0].resolution, 0.01);
}

TEST(UrdfReader, ServosMayHaveBacklash) {
  const std::string type =
      "<servo_type name='MX-28' stall_torque='2.5' no_load_speed='6' kp='20' kd='0.4' backlash='0.0058'/>";
  const auto robot = [&](const char* own) {
    const std::string servo = "<murosimf><servo type='MX-28'" + std::string(own) + "/></murosimf>";
    return read("<murosimf>" + type + "</murosimf>" + withShoulder("continuous", servo));
  };
  EXPECT_EQ(robot("").model->tree.joints[0].servo->backlash, 0.0058);
  EXPECT_EQ(robot(" backlash='0'").model->tree.joints[0].servo->backlash, 0);
  EXPECT_NE(robot(" backlash='-1'").diagnostics.text().find("backlash is -1 rad, expected 0 or more"),
            std::string::npos);
}

TEST(UrdfReader, ServosMayNameAParameterFile) {
  for (const char* own : {"", " file='own.json'"}) {
    const Reading r = read(
        "<murosimf><servo_type name='MX-28' stall_torque='2.5' no_load_speed='6' kp='20' kd='0.4' file='mx28.json'/>"
        "</murosimf>" +
        withShoulder("continuous", "<murosimf><servo type='MX-28'" + std::string(own) + "/></murosimf>"));
    ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
    EXPECT_EQ(r.model->tree.joints[0].servo->file, *own == 0 ? "mx28.json" : "own.json");
  }
}

TEST(UrdfReader, JointWithoutServoMayHaveASensor) {
  const Reading r = read(withShoulder("continuous", "<murosimf><joint_sensor resolution='0.5'/></murosimf>"));
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  ASSERT_EQ(r.model->joint_sensors.size(), 1U);
  EXPECT_EQ(r.model->joint_sensors[0].resolution, 0.5);
  EXPECT_TRUE(read(withShoulder("continuous", "")).model->joint_sensors.empty());
}

TEST(UrdfReader, TouchAndForceSensorsStandOnTheirLinks) {
  const std::string arm = "<link name='hand'>" + kInertial +
                          "<collision><geometry><sphere radius='0.1'/></geometry></collision><murosimf>"
                          "<touch_sensor name='palm' threshold='2.5'/><force_sensor name='wrist' xyz='0 0 0.1' "
                          "rpy='0 0.3 0'/></murosimf></link><joint name='wrist_joint' type='continuous'><parent "
                          "link='arm'/><child link='hand'/></joint>";
  const Reading r = read(withShoulder("continuous", "") + arm);
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  ASSERT_EQ(r.model->touch_sensors.size(), 1U);
  EXPECT_EQ(r.model->touch_sensors[0].name, "palm");
  EXPECT_EQ(r.model->touch_sensors[0].body, r.model->tree.bodyIndex("hand"));
  EXPECT_EQ(r.model->touch_sensors[0].threshold, 2.5);
  ASSERT_EQ(r.model->force_sensors.size(), 1U);
  EXPECT_EQ(r.model->force_sensors[0].body, r.model->tree.bodyIndex("hand"));
  EXPECT_EQ(r.model->force_sensors[0].X_BM.translation, (Vector3{0, 0, 0.1}));
  EXPECT_EQ(r.model->force_sensors[0].X_BM.rotation, rotationY(0.3));
}

TEST(UrdfReader, AnyPropertyMayBeSetOnAnyObject) {
  const Reading r = read(
      "<murosimf><property name='wind' value='1 2 3'/><property object='eye' name='noise' "
      "value='0.5'/></murosimf><link name='trunk'>" +
      kInertial +
      "<murosimf><property name='paint' value='matt 7'/><camera name='eye' width='4' height='2' "
      "fx='3' fy='4' cx='1' skew='0.1' period='0.5' phase='0.25'/></murosimf></link>");
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  const auto& properties = r.model->properties;
  ASSERT_EQ(properties.size(), 3U);
  EXPECT_EQ(properties.at({"", "wind"}).numbers, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(properties.at({"eye", "noise"}).numbers, std::vector<double>{0.5});
  EXPECT_TRUE(properties.at({"trunk", "paint"}).numbers.empty());
  EXPECT_EQ(properties.at({"trunk", "paint"}).text, "matt 7");
  EXPECT_EQ(properties.at({"trunk", "paint"}).where.line, 1);
  const CameraMount& eye = r.model->cameras.at(0);
  EXPECT_EQ(eye.lens.fy, 4);
  EXPECT_EQ(eye.lens.cx, 1);
  EXPECT_EQ(eye.lens.cy, 0.5);
  EXPECT_EQ(eye.lens.skew, 0.1);
  EXPECT_EQ(eye.phase, 0.25);
  EXPECT_EQ(eye.X_BC.rotation * kAxisZ, kAxisX);   // looks forward
  EXPECT_EQ(eye.X_BC.rotation * kAxisY, -kAxisZ);  // image rows go down
}

TEST(UrdfReader, ElementsOfOtherProgramsAreIgnoredWithAWarning) {
  const Reading r = read("<gazebo reference='trunk'><anything/></gazebo><link name='trunk'>" + kInertial + "</link>");
  EXPECT_TRUE(r.model.has_value());
  EXPECT_EQ(r.diagnostics.text(), "test.urdf:1: warning: <gazebo>: belongs to another program: ignored\n");
}

TEST(UrdfReader, JointsAreNumberedDepthFirstInTheOrderOfTheFile) {
  const auto link = [](const char* name) { return std::string("<link name='") + name + "'>" + kInertial + "</link>"; };
  const auto joint = [](const char* name, const char* parent, const char* child) {
    return std::string("<joint name='") + name + "' type='continuous'><parent link='" + parent + "'/><child link='" +
           child + "'/></joint>";
  };
  const Reading r = read(joint("second", "trunk", "b") + joint("third_below_first", "a", "c") + joint("x", "c", "d") +
                         joint("first", "trunk", "a") + link("d") + link("c") + link("b") + link("a") + link("trunk"));
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  std::vector<std::string> names;
  for (const Joint& j : r.model->tree.joints) names.push_back(j.name);
  EXPECT_EQ(names, (std::vector<std::string>{"second", "first", "third_below_first", "x"}));
  const FlatTree flat = flattenTree(r.model->tree);
  EXPECT_EQ(flat.row_names, (std::vector<std::string>{"trunk", "b", "a", "c", "d"}));
  for (std::size_t row = 1; row < flat.table.rows.size(); ++row) {
    EXPECT_LT(flat.table.rows[row].parent, static_cast<int>(row));
  }
}

TEST(UrdfReader, NumbersNeedNoLocaleAndKeepEveryBit) {
  const Reading r = read(withShoulder("continuous", "<origin xyz='+0.1 1e-3 \n -.25'/>"));
  ASSERT_TRUE(r.model.has_value()) << r.diagnostics.text();
  EXPECT_EQ(flattenTree(r.model->tree).table.rows[1].X_PF.translation, (Vector3{0.1, 1e-3, -0.25}));
}

}  // namespace
}  // namespace murosimf
