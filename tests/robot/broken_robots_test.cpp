/// @file Files that people get wrong: each mistake is told with its line, all at once, and nothing crashes.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/robot/urdf_reader.h"

namespace murosimf {
namespace {

struct Expected {
  int line;
  const char* words;
};
struct BrokenFile {
  const char* name;
  std::vector<Expected> errors;  ///< all of them
};

const std::vector<BrokenFile> kBrokenFiles{
    {"unknown_names",
     {{3, "unknown element <inertail> in <link> (did you mean \"inertial\"?)"},
      {6, "unknown element <colision> in <link> (did you mean \"collision\"?)"},
      {7, "<sphere>: unknown attribute \"raduis\" (did you mean \"radius\"?)"},
      {7, "<sphere>: attribute \"radius\" is missing"},
      {7, "\"gray\", which no material has (did you mean \"grey\"?)"},
      {10, "xacro is not evaluated"},
      {11, "unknown element <lnik> in <robot> (did you mean \"link\"?)"}}},
    {"bad_wheels",
     {{6, "stands in a link that collides as another shape, expected a cylinder or a sphere"},
      {7, "attribute \"rays\" is 1, expected more between two angles"},
      {8, "attribute \"largest\" is 0.1 m, expected more than least, 0.5 m"},
      {8, "attribute \"period\" is 0 s, expected more than 0"},
      {8, "attribute \"first_angle\" is -90, expected an angle in rad, from -2 pi to 2 pi"},
      {8, "attribute \"last_angle\" is 90, expected an angle in rad"},
      {9, "attribute \"noise\" is -1, expected 0 or more"},
      {9, "attribute \"half_angle\" is 2 rad, expected 0 (one ray) or more, below pi/2"},
      {10, "unknown attribute \"rays\""},
      {17, "attribute \"friction\" is -1, expected 0 or more"},
      {17, "attribute \"roller_angle\" is 2 rad, expected an angle between -pi/2 and pi/2"},
      {18, "is the second wheel or castor of its link, after the one in line 17, expected one"},
      {18, "stands at a wheel without rollers=\"true\""},
      {19, "unknown attribute \"creepage\""},
      {19, "is the second wheel or castor of its link"},
      {19, "attribute \"stick_speed\" is 0, expected more than 0"}}},
    {"wheels_askew",
     {{5, "wheel \"of_the_base\" stands in a link that no joint turns, expected one of type continuous, or <castor>"},
      {10, "wheel \"lies\": its cylinder stands 1.571 rad askew on the axis of joint \"drive_left\""},
      {16, "wheel \"wobbles\": the centre of its shape is 0.01 m away from the axis of joint \"drive_right\""},
      {22, "castor \"driven\" stands in a link that joint \"drive_rear\" turns"}}},
    {"bad_inertia",
     {{3, "mass is 0 kg, expected more than 0"},
      {8, "-0.001, 0.001, 0.003 kg m^2, expected all to be positive"},
      {14, "0.001, 0.001, 0.003 kg m^2, expected the two smaller ones to add up to at least the largest"},
      {18, "attribute \"value\" is \"nan\", expected a number"},
      {20, "element <inertia> is missing"}}},
    {"bad_numbers",
     {{4, "\"0 0\", expected 3 numbers"},
      {5, "\"1.5.2\", expected a number"},
      {6, "attribute \"iyy\" is \"inf\", expected a number (numbers are finite"},
      {6, "attribute \"izz\" is empty"},
      {9, "(numbers stand apart by spaces"},
      {9, "(angles are in rad)"},
      {10, "attribute \"size\" is \"0.1 0.1\", expected 3 numbers"},
      {13, "(xacro expressions are not evaluated"},
      {14, "attribute \"radius\" is \"1e400\", expected a number (numbers are finite and reach to 1e9)"},
      {14, "attribute \"length\" is missing"},
      {17, "attribute \"rpy\" has the angle 180, expected rad"},
      {18, "half sizes -0.1, -0.1, -0.1 m, expected all to be positive"}}},
    {"bad_joints",
     {{9, "is the zero vector, expected a direction"},
      {10, "lower limit 2 is above upper limit -2"},
      {12, "\"revolut\", expected revolute, continuous, prismatic or fixed (did you mean \"revolute\"?)"},
      {15, "element <limit> is missing"},
      {17, "joints that follow others are not supported"},
      {18, "attribute \"damping\" is -1"},
      {18, "attribute \"friction\" is -0.5, expected 0 or more"},
      {19, "\"MX-28\", which no <servo_type> has"},
      {21, "attribute \"name\" is missing"},
      {21, "element <child> is missing"}}},
    {"bad_devices",
     {{4, "<motor>: unknown attribute \"sensr\" (did you mean \"sensor\"?)"},
      {5, "unknown element <moter> in <player_api> (did you mean \"motor\"?)"},
      {6, "device name is \" Neck\", expected 1 to 100 printable ASCII characters, no space at the ends"},
      {7, "attribute \"scale\" is 0, expected what one SI unit adds to the reading"},
      {7, "attribute \"highest\" is 1, expected more than lowest, 2"},
      {8, "\"rear_lft\", expected one of rear_right, front_right, rear_left, front_left (did you mean \"rear_left\"?)"},
      {9, "<camera>: unknown attribute \"scale\""},
      {10, "device \"Camera\": the name is used in line 9 already"},
      {11, "attribute \"imu\" is missing"}}},
    {"unknown_devices",
     {{5, "joint \"nek\" does not exist (did you mean \"neck\"?)"},
      {7, "motor \"Head2\" moves joint \"neck\", as \"Head\" in line 6 does already, expected one motor a joint"},
      {8, "imu \"trunk\" does not exist"},
      {9, "camera \"eyes\" does not exist (did you mean \"eye\"?)"},
      {10, "pressure_sensor \"presure\" does not exist (did you mean \"pressure\"?)"},
      {11, "pressure_sensor \"points\" has points of its own, expected one that names a sole"},
      {12, "force_sensor \"ankle\" does not exist"},
      {13, "touch_sensor \"toes\" does not exist"}}},
    {"cycle", {{6, "joints form a cycle: \"a_to_b\", \"b_to_c\", \"c_to_a\""}}},
    {"only_a_cycle", {{3, "joints form a cycle: \"to_itself\""}}},
    {"disconnected",
     {{2, "link \"left_over\" is not connected"},
      {8, "link \"hand\" is the child of joint \"second_wrist\" and of joint \"wrist\" in line 7"}}},
    {"unknown_links",
     {{5, "link \"trnk\" does not exist (did you mean \"trunk\"?)"}, {10, "link \"forearm\" does not exist"}}},
    {"duplicate_names",
     {{3, "<mass>: stands twice in <inertial>, first in line 3"},
      {4, "imu \"trunk\": the name is used in line 2 already"},
      {7, "link \"arm\": the name is used in line 6 already"},
      {9, "joint \"shoulder\": the name is used in line 8 already"},
      {9, "link \"arm\" is the child of joint \"shoulder\""},
      {7, "link \"arm\" is not connected"},
      {10, "name \"my shoulder\" holds something else than letters, digits, _ and -"}}},
    {"attribute_twice", {{4, "or is given twice"}}},
    {"mesh", {{6, "\"package://robot/meshes/trunk.stl\", which was not found"}, {10, "holds 2 shapes"}}},
    {"massless", {{2, "link \"world\" has no mass"}, {4, "joint \"rail\" moves no mass"}}},
    {"bad_mounts",
     {{3, "stall_torque is 0 N m, expected more than 0"},
      {10, "\"middle\", expected left or right"},
      {10, "attribute \"size\" is not positive"},
      {11, "attribute \"height\" is 0, expected a whole number from 1 to 8192"},
      {11, "attribute \"hfov\" is not between 0 and pi rad"},
      {11, "attribute \"period\" is 0, expected more than 0"},
      {12, "expected either \"hfov\" [rad] or \"fx\" [pixels]"},
      {12, "has 3 numbers, expected 4, 5, 8 or 12"},
      {13, "attribute \"width\" is 640.5, expected a whole number"},
      {14, "\"soul\", which is no sole of this link (did you mean \"sole\"?)"},
      {15, "has 4 numbers, expected three for each point"},
      {16, "attribute \"value\" is missing"}}},
    {"bad_sensors",
     {{5, "<touch_sensor>: stands in a link that touches nothing, expected one with a <collision>"},
      {6, "attribute \"xyz\" is \"0 0\", expected 3 numbers"},
      {12, "attribute \"threshold\" is -1 N, expected 0 or more"},
      {13, "unknown attribute \"treshold\" (did you mean \"threshold\"?)"},
      {13, "<touch_sensor>: is the second of its link, after the one in line 12, expected one"}}},
    {"force_on_nothing",
     {{4, "force_sensor \"of_trunk\" stands in a link that carries the others, expected one that a joint moves"},
      {7, "force_sensor \"of_plate\" stands in a link that is fixed to \"trunk\", expected one that a joint moves"}}},
    {"unknown_objects",
     {{3, "link \"trnk\" does not exist (did you mean \"trunk\"?)"},
      {4, "object \"truck\" does not exist in this robot (did you mean \"trunk\"?)"},
      {6, "property \"friction\" is set in line 5 already"},
      {11, "link \"skull\" does not exist"}}},
    {"not_a_robot", {{2, "found the element \"mujoco\", expected <robot>"}}},
    {"mismatched_tags", {{3, "a closing tag does not fit"}}},
    {"truncated", {{132, "not XML"}}},
    {"empty", {{0, "file is empty, expected <robot>"}}},
    {"garbage_bytes", {{1, "not XML"}}},
    {"zero_byte", {{3, "not a text file: it holds a zero byte"}}},
};

std::string broken(const std::string& name) {
  return std::string(MUROSIMF_SOURCE_DIR "/tests/data/broken/robot_") + name + ".urdf";
}

bool tells(const Diagnostics& diagnostics, const Expected& expected) {
  const auto& all = diagnostics.all();
  return std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) {
    return d.severity == Diagnostic::Severity::kError && d.where.line == expected.line &&
           d.message.find(expected.words) != std::string::npos;
  });
}

TEST(BrokenRobots, GetEveryMistakeWithItsLineAtOnce) {
  for (const BrokenFile& file : kBrokenFiles) {
    Diagnostics diagnostics;
    EXPECT_FALSE(readUrdf(broken(file.name), diagnostics).has_value()) << file.name;
    for (const Expected& expected : file.errors) {
      EXPECT_TRUE(tells(diagnostics, expected)) << file.name << ":" << expected.line << " " << expected.words << "\n"
                                                << diagnostics.text();
    }
    EXPECT_EQ(diagnostics.errorCount(), static_cast<int>(file.errors.size())) << diagnostics.text();
    for (const Diagnostic& d : diagnostics.all()) EXPECT_EQ(d.where.file, broken(file.name));
  }
}

TEST(BrokenRobots, AreAllInTheList) {
  for (const auto& entry : std::filesystem::directory_iterator(MUROSIMF_SOURCE_DIR "/tests/data/broken")) {
    const std::string stem = entry.path().stem().string();
    if (!stem.starts_with("robot_")) continue;
    EXPECT_TRUE(std::any_of(kBrokenFiles.begin(), kBrokenFiles.end(), [&](const BrokenFile& f) {
      return stem.substr(6) == f.name;
    })) << stem;
  }
}

TEST(BrokenRobots, OneHundredThousandNestedElementsAreRefused) {
  std::string text = "<robot name=\"deep\">\n";
  for (int i = 0; i < 100000; ++i) text += "<link>\n";
  Diagnostics diagnostics;
  EXPECT_FALSE(readUrdfText(text, "deep.urdf", diagnostics).has_value());
  ASSERT_EQ(diagnostics.errorCount(), 1);
  EXPECT_NE(diagnostics.text().find("nested too deeply"), std::string::npos) << diagnostics.text();
  EXPECT_GT(diagnostics.all()[0].where.line, 90);
}

TEST(BrokenRobots, ChainOfTooManyLinksIsRefusedAndAThousandAreRead) {
  const auto chain = [](int count) {
    const std::string inertial = "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>";
    std::string text = "<robot name='chain'><link name='l0'>" + inertial + "</link>\n";
    for (int i = 1; i < count; ++i) {
      const std::string child = "l" + std::to_string(i), parent = "l" + std::to_string(i - 1);
      text += "<link name='" + child + "'>" + inertial + "</link>";
      text += "<joint name='j" + std::to_string(i) + "' type='continuous'><parent link='" + parent +
              "'/><child link='" + child + "'/></joint>\n";
    }
    return text + "</robot>";
  };
  Diagnostics diagnostics;
  const ReadResult thousand = readUrdfText(chain(1000), "chain.urdf", diagnostics);
  ASSERT_TRUE(thousand.has_value()) << diagnostics.text();
  EXPECT_EQ(thousand->tree.joints.size(), 999U);
  EXPECT_FALSE(readUrdfText(chain(1001), "chain.urdf", diagnostics).has_value());
  EXPECT_NE(diagnostics.text().find("expected at most 1000 of each"), std::string::npos);
}

TEST(BrokenRobots, HugeHostileFilesAreRefusedInNoTime) {
  std::string names = "<robot name='names'>", shapes = "<robot name='shapes'><link name='trunk'>";
  for (int i = 0; i < 20000; ++i) {
    const std::string number = std::to_string(i);
    names += "<material name='a_long_name_of_a_material_" + number + "'><color rgba='1 1 1 1'/></material>";
    names += "<link name='l" + number +
             "'><visual><geometry><sphere radius='1'/></geometry><material name='a_lng_name" + number +
             "'/></visual></link>\n";
    shapes += "<visual><geometry><sphere radius='1'/></geometry></visual>";
    shapes += "<collision><geometry><sphere radius='2'/></geometry></collision>";
  }
  const auto start = std::chrono::steady_clock::now();
  for (const std::string& text : {names + "</robot>", shapes + "</link></robot>"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(readUrdfText(text, "hostile.urdf", diagnostics).has_value());
    EXPECT_NE(diagnostics.text().find("expected at most 1000"), std::string::npos);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));  // quadratic work would take minutes
}

TEST(BrokenRobots, WhatIsNoFileIsTold) {
  Diagnostics diagnostics;
  EXPECT_FALSE(readUrdf("no/such/robot.urdf", diagnostics).has_value());
  EXPECT_FALSE(readUrdf(MUROSIMF_SOURCE_DIR, diagnostics).has_value());
  EXPECT_EQ(diagnostics.text(), MUROSIMF_SOURCE_DIR
            ": error: not a file, expected a robot (URDF)\n"
            "no/such/robot.urdf: error: file does not exist, expected a robot (URDF)\n");
}

}  // namespace
}  // namespace murosimf
