/// @file Files damaged at random: whatever stands in a file, reading ends with a robot or with errors that have a line.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "murosimf/math/random.h"
#include "murosimf/robot/flatten_tree.h"
#include "murosimf/robot/urdf_reader.h"

namespace murosimf {
namespace {

std::string textOf(const std::string& robot) {
  std::ifstream stream(MUROSIMF_SOURCE_DIR "/robots/" + robot + ".urdf", std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Whole numbers of one damaged file, in order.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : stream_(seed, "damage", 0) {}
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(stream_.bits(step_++) % n); }

 private:
  RandomStream stream_;
  std::uint64_t step_ = 0;
};

/// A digit becomes another one: the file stays XML, and often a robot.
void changeDigit(std::string& text, Dice& dice) {
  const std::size_t digit = text.find_first_of("0123456789", dice.below(text.size()));
  if (digit != std::string::npos) text[digit] = static_cast<char>('0' + dice.below(10));
}

/// One piece of damage: the value of an attribute replaced, a byte changed, a piece cut out or said twice, a word put
/// in.
void damage(std::string& text, Dice& dice) {
  static const std::vector<std::string> kWords{"nan",
                                               "-1",
                                               "0",
                                               "1e308",
                                               "-1e-308",
                                               "\"",
                                               "<",
                                               ">",
                                               "/>",
                                               "<link name=\"trunk\">",
                                               "</link>",
                                               "&#0;",
                                               "&#x110000;",
                                               "<!--",
                                               "<![CDATA[",
                                               "\xff\xfe",
                                               "pelvis",
                                               "trunk",
                                               "continuous",
                                               "fixed",
                                               "999999999999999999999"};
  const std::size_t at = dice.below(text.size()), length = 1 + dice.below(200);
  switch (dice.below(5)) {
    case 0: {
      const std::size_t open = text.find("=\"", at);
      const std::size_t close = open == std::string::npos ? open : text.find('"', open + 2);
      if (close != std::string::npos) text.replace(open + 2, close - open - 2, kWords[dice.below(kWords.size())]);
      break;
    }
    case 1:
      text[at] = static_cast<char>(dice.below(256));
      break;
    case 2:
      text.erase(at, length);
      break;
    case 3:
      text.insert(dice.below(text.size()), text.substr(at, length));
      break;
    default:
      text.insert(at, kWords[dice.below(kWords.size())]);
  }
  if (text.empty()) text = " ";
}

bool allFinite(const FlatTree& flat) {
  for (std::size_t row = 0; row < flat.table.rows.size(); ++row) {
    const Pose& X = flat.table.rows[row].X_PF;
    const MassProperties& mass = flat.row_mass[row];
    if (!std::isfinite(norm(X.translation)) || !(abs(norm(X.rotation.x) - 1) < 1e-9)) return false;
    if (!(mass.mass > 0) || !std::isfinite(mass.I_C_B.xx) || !std::isfinite(norm(mass.p_BC_B))) return false;
  }
  return true;
}

/// Every device is a part that the robot has.
bool devicesAreParts(const RobotModel& model) {
  return std::all_of(model.devices.begin(), model.devices.end(), [&](const DeviceMount& device) {
    const auto isOf = [&](const auto& parts) {
      return device.part >= 0 && std::size(parts) > static_cast<std::size_t>(device.part);
    };
    switch (device.kind) {
      case MountedDevice::kMotor:
      case MountedDevice::kPositionSensor:
        return isOf(model.tree.joints);
      case MountedDevice::kImuAccelerometer:
      case MountedDevice::kImuGyro:
        return isOf(model.imus);
      case MountedDevice::kCamera:
        return isOf(model.cameras);
      case MountedDevice::kForce:
        return isOf(model.soles) && device.corner >= -1 && device.corner < 4;
      case MountedDevice::kForce3d:
        return isOf(model.force_sensors);
      case MountedDevice::kBumper:
        return isOf(model.touch_sensors);
    }
    return false;
  });
}

class MutatedRobots : public testing::TestWithParam<const char*> {};

TEST_P(MutatedRobots, NeverCrashTheReaderAndAlwaysEndInARobotOrInErrors) {
  const std::string whole = textOf(GetParam());
  int robots = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Dice dice(seed);
    std::string text = whole;
    for (std::size_t i = 0, count = 1 + dice.below(4); i < count; ++i)
      seed % 2 == 0 ? changeDigit(text, dice) : damage(text, dice);
    Diagnostics diagnostics;
    const ReadResult model = readUrdfText(text, "damaged.urdf", diagnostics);
    ASSERT_EQ(model.has_value(), !diagnostics.hasErrors()) << "seed " << seed << "\n" << diagnostics.text();
    ASSERT_TRUE(!model || allFinite(flattenTree(model->tree))) << "seed " << seed;
    ASSERT_TRUE(!model || devicesAreParts(*model)) << "seed " << seed;
    for (const Diagnostic& d : diagnostics.all()) ASSERT_GT(d.where.line, 0) << "seed " << seed << " " << d.message;
    ++(model ? robots : refused);
  }
  EXPECT_GT(robots, 300);    // the damage is not always fatal
  EXPECT_GT(refused, 1000);  // nor mostly harmless
}

INSTANTIATE_TEST_SUITE_P(Robots, MutatedRobots, testing::Values("ks21", "wolfgang"),
                         [](const auto& made) { return std::string(made.param); });

}  // namespace
}  // namespace murosimf
