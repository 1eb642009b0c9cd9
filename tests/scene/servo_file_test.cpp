// Parameter files of servos become constants; what is wrong in them is told with its place.

#include "murosimf/scene/servo_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "murosimf/modules/actuation/motor_properties.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = MUROSIMF_SOURCE_DIR "/robots/servos";

struct Reading {
  std::map<std::string, double> constants;
  bool good = false;
  std::string said;  ///< "LINE:COLUMN: words" a line
};

Reading read(const std::string& text) {
  Reading r;
  Diagnostics diagnostics;
  if (const auto constants = readServoText(text, "servo.json", diagnostics)) {
    r.good = true;
    for (const ServoConstant& c : *constants) r.constants[std::string(c.property->name)] = c.value;
  }
  for (const Diagnostic& d : diagnostics.all()) {
    r.said += fmt::format("{}:{}: {}\n", d.where.line, d.where.column, d.message);
  }
  return r;
}

std::string contents(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A whole file of model M1 with something before its end.
std::string withM1(const std::string& more) {
  return "{\"model\": \"m1\", \"kt\": 1.6, \"R\": 4, \"armature\": 0.01, \"friction_base\": 0.1,\n"
         "\"friction_viscous\": 0.02" +
         more + "}";
}

TEST(ServoFile, OfModelM4CountsItsLoadOnBothSides) {
  const Reading r = read(contents(kFolder / "mx64_m4.json"));
  EXPECT_EQ(r.said, "");
  const std::map<std::string, double> expected{{"torque_constant", 1.6632},
                                               {"motor_resistance", 3.156},
                                               {"armature", 0.01096},
                                               {"supply_voltage", 15},
                                               {"firmware_kp", 32},
                                               {"error_gain", 0.158},
                                               {"largest_duty", 0.9625},
                                               {"friction_base", 0.0615},
                                               {"friction_viscous", 0.01475},
                                               {"friction_stribeck", 0.0239},
                                               {"friction_speed", 1.5206},
                                               {"friction_exponent", 1.3344},
                                               {"load_friction_motor", 0},
                                               {"load_friction_external", 0},
                                               {"load_friction_motor_stribeck", 0.2343},
                                               {"load_friction_external_stribeck", 0.2343}};
  EXPECT_EQ(r.constants, expected);
}

TEST(ServoFile, OfModelM6HasEveryTerm) {
  const Reading r = read(
      "{\"model\": \"m6\", \"actuator\": \"xl330\", \"kt\": 0.3, \"R\": 2, \"armature\": 0.002, \"friction_base\": 1,"
      "\"friction_viscous\": 2, \"friction_stribeck\": 3, \"load_friction_motor\": 4, \"load_friction_external\": 5,"
      "\"load_friction_motor_stribeck\": 6, \"load_friction_external_stribeck\": 7, \"load_friction_motor_quad\": 8,"
      "\"load_friction_external_quad\": 9, \"dtheta_stribeck\": 10, \"alpha\": 11, \"q_offset\": 0.01}");
  EXPECT_EQ(r.said, "");
  EXPECT_EQ(r.constants.size(), 18U);
  const char* const names[] = {"friction_base",
                               "friction_viscous",
                               "friction_stribeck",
                               "load_friction_motor",
                               "load_friction_external",
                               "load_friction_motor_stribeck",
                               "load_friction_external_stribeck",
                               "load_friction_motor_quad",
                               "load_friction_external_quad",
                               "friction_speed",
                               "friction_exponent"};
  for (int i = 0; i < 11; ++i) EXPECT_EQ(r.constants.at(names[i]), i + 1) << names[i];
  EXPECT_EQ(r.constants.at("supply_voltage"), 7.5);
}

TEST(ServoFile, MaySayItselfWhatDrivesTheMotor) {
  const Reading r = read(withM1(", \"vin\": 12, \"kp\": 10, \"error_gain\": 0.5, \"max_current\": 2"));
  EXPECT_EQ(r.said, "");
  EXPECT_EQ(r.constants.at("supply_voltage"), 12);
  EXPECT_EQ(r.constants.at("firmware_kp"), 10);
  EXPECT_EQ(r.constants.at("error_gain"), 0.5);
  EXPECT_EQ(r.constants.at("largest_duty"), 1);
  EXPECT_EQ(r.constants.at("largest_current"), 2);
  const Reading over = read(withM1(", \"actuator\": \"mx64\", \"kp\": 8, \"error_gain_ratio\": 2"));
  EXPECT_EQ(over.said, "");
  EXPECT_EQ(over.constants.at("supply_voltage"), 15);
  EXPECT_EQ(over.constants.at("firmware_kp"), 8);
  EXPECT_EQ(over.constants.at("error_gain"), 0.316);
}

struct Mistake {
  const char* name;
  std::string text;
  const char* said;
};

class ServoFileMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(ServoFileMistakes, AreToldWithTheirPlace) {
  const Reading r = read(GetParam().text);
  EXPECT_FALSE(r.good);
  EXPECT_EQ(r.said, GetParam().said);
}

const std::string kDriven = ", \"actuator\": \"mx64\"";

INSTANTIATE_TEST_SUITE_P(
    ServoFile, ServoFileMistakes,
    testing::Values(
        Mistake{"Empty", "", "1:1: not JSON: expected an object of keys and numbers\n"},
        Mistake{"CutOff", "{\"kt\": 1,\n \"R\": ", "2:7: not JSON: expected an object of keys and numbers\n"},
        Mistake{"List", "[1, 2]", "1:1: found array, expected an object of keys and numbers\n"},
        Mistake{"NoModel", "{\"actuator\": \"mx64\"}", "0:0: model is missing, expected a text\n"},
        Mistake{"UnknownModel", "{\"actuator\": \"mx64\",\n\"model\": \"m7\"}",
                "2:1: model is \"m7\", expected m1, m2, m3, m4, m5 or m6 (did you mean \"m1\"?)\n"},
        Mistake{"MissingNumber",
                "{\"model\": \"m1\", \"actuator\": \"mx64\", \"kt\": 1, \"armature\": 0, \"friction_base\": 0}",
                "0:0: R is missing, expected a number [Ohm] in a file of model m1\n"
                "0:0: friction_viscous is missing, expected a number [N m s/rad] in a file of model m1\n"},
        Mistake{
            "WrongNumber", withM1(kDriven + ",\n\"vin\": 0, \"max_pwm\": \"all\", \"kp\": -3"),
            "3:1: vin is 0, expected a number greater than 0\n3:29: kp is -3, expected a number greater than 0\n3:11: "
            "max_pwm is string, expected a number greater than 0\n"},
        Mistake{"NegativeFriction",
                "{\"model\": \"m1\", \"actuator\": \"mx64\", \"kt\": 1, \"R\": 1, \"armature\": 0,\n"
                " \"friction_base\": -0.1, \"friction_viscous\": null}",
                "2:2: friction_base is -0.1, expected a number of 0 or more\n"
                "2:25: friction_viscous is null, expected a number of 0 or more\n"},
        Mistake{"NoActuator", withM1(""), "0:0: actuator is missing, expected a text\n"},
        Mistake{"UnknownActuator", withM1(",\n\"actuator\": \"mx46\""),
                "3:1: actuator \"mx46\" is not known, expected mx64, mx106, xl320, xl330, sts3215, waveshare_st3025, "
                "or vin [V], kp and error_gain [1/rad] in the file (did you mean \"mx64\"?)\n"},
        Mistake{"DrivenByCurrent", withM1(",\n\"actuator\": \"erob80_50\""),
                "3:1: actuator \"erob80_50\" is driven by current, expected one that is driven by voltage, as mx64, "
                "mx106, xl320, xl330, sts3215, waveshare_st3025\n"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(ServoFile, WarnsOfWhatItPassesOver) {
  const Reading r = read(withM1(kDriven + ",\n\"alpha\": 2, \"fricton_base\": 1"));
  EXPECT_TRUE(r.good);
  EXPECT_EQ(r.said,
            "3:1: alpha is passed over: model m1 does not have it\n"
            "3:13: unknown key \"fricton_base\" is passed over (did you mean \"friction_base\"?)\n");
  EXPECT_FALSE(r.constants.contains("friction_exponent"));
}

TEST(ServoFile, CutOffAnywhereIsRefused) {
  const std::string whole = contents(kFolder / "mx106_m4.json");
  for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
    EXPECT_FALSE(read(whole.substr(0, length)).good) << length;
  }
}

TEST(ServoFile, ThatIsNoneIsNamed) {
  Diagnostics diagnostics;
  EXPECT_FALSE(readServoFile((kFolder / "none.json").string(), diagnostics));
  EXPECT_NE(diagnostics.text().find("none.json: error: cannot be read"), std::string::npos) << diagnostics.text();
}

TEST(ServoFile, AllThatComeWithTheProgramAreGood) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    Diagnostics diagnostics;
    EXPECT_TRUE(readServoFile(entry.path().string(), diagnostics)) << entry.path();
    EXPECT_EQ(diagnostics.text(), "");
    ++files;
  }
  EXPECT_EQ(files, 4);
}

}  // namespace
}  // namespace murosimf
