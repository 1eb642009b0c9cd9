// What cannot be built although the scenario can be read: each mistake with its place and words.

#include <fstream>
#include <sstream>

#include "scene/built_world.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

/// Two robots, and below them (from line 8 on) what is wrong.
Lines saidOf(const std::string& more) { return BuiltWorld(kTwoRobots + more).complaints(); }

void expectStarts(const Lines& said, const Lines& starts) {
  ASSERT_EQ(said.size(), starts.size()) << fmt::format("{}", fmt::join(said, "\n"));
  for (std::size_t i = 0; i < said.size(); ++i) EXPECT_TRUE(startsWith(said[i], starts[i])) << said[i];
}

TEST(BuilderErrors, UnknownModule) {
  expectStarts(saidOf("[robots.red.1.motion]\nmodule = \"kinematic_waking\""),
               {"9:10: robots.red.1: unknown module \"kinematic_waking\" for motion; expected none or one of "
                "kinematic_walking, wheeled_kinematics, multibody_dynamics, composite_body_dynamics, "
                "simplified_dynamics (did you mean "
                "\"kinematic_walking\"?)"});
  const Lines said = saidOf("[robots.red.1.modules]\nwalker = {speed = 1}");
  expectStarts(said, {"9:1: robots.red.1: unknown module \"walker\"; expected one of ideal_servo, "});
}

TEST(BuilderErrors, ModuleOfAnotherConcern) {
  expectStarts(saidOf("[robots.red.1.motion]\nmodule = \"ideal_servo\""),
               {"9:10: robots.red.1: module ideal_servo is for actuation, not for motion"});
}

TEST(BuilderErrors, SlotThatTheLevelDoesNotHave) {
  expectStarts(saidOf("[robots.red.1.contact]\nmodule = \"soles\"\n[robots.blue.1.integration]\nperiod = 0.001"),
               {"9:10: robots.red.1: level \"kinematic\" has no contact; it has actuation, motion, collision, "
                "kinematics, sensing",
                "11:10: robots.blue.1: level \"kinematic\" has no integration; it has"});
}

TEST(BuilderErrors, WrongParametersOfModules) {
  const Lines said = saidOf("[robots.red.1.motion]\nhysteresis = 1.0\nblend_tim = 0.1\nphase = 0.001");
  expectStarts(said, {"11:9: robots.red.1: phase of motion is 0.001 s; expected 0"});
  expectStarts(saidOf("[robots.red.1.motion]\nhysteresis = 1.0\nblend_tim = 0.1\n"),
               {"9:1: parameter hysteresis of module ", "10:1: module kinematic_walking has no parameter"});
}

TEST(BuilderErrors, UnknownCameraAndModuleAndParameters) {
  expectStarts(saidOf("[robots.red.1.cameras]\nhed = {noise = 0.1}\nhead = {module = \"ray_castor\"}\n"
                      "chest = {noise = 0.6, gian = 1.0, gain = 0, antialias = 1}"),
               {"9:8: robots.red.1 has no camera \"hed\"; it has ",
                "10:18: robots.red.1: unknown camera module "
                "\"ray_castor\"; expected one of none, ray_caster, oracle (did you mean \"ray_caster\"?)",
                "11:18: noise is 0.6, expected a number from 0 to 0.5",
                "11:23: module ray_caster has no parameter \"gian\"; it knows noise, gain, antialias, shadows, "
                "lens, extrapolate, chain, format, rolling_shutter_readout, motion_blur_exposure, ",
                "11:42: gain is 0, expected a number from 0.01 to 100", "11:57: antialias is neither true nor false"});
}

TEST(BuilderErrors, ShadowsOfACameraAreASwitch) {
  expectStarts(saidOf("[robots.red.1.cameras]\nhead = {shadows = 1}"), {"9:19: shadows is neither true nor false"});
}

TEST(BuilderErrors, CameraFasterThanItsControlSoftware) {
  expectStarts(saidOf("[robots.red.1.cameras]\nhead = {period = 0.005}"),
               {"9:18: robots.red.1: period of camera head is 0.005 s, expected at least the control software's of "
                "0.01 s"});
}

TEST(BuilderErrors, UnknownControlSoftware) {
  expectStarts(saidOf("[robots.all]\ncontrol = \"idel\""),
               {"9:11: robots.red.1: unknown control software \"idel\"; expected one of none, idle (did you mean "
                "\"idle\"?)",
                "9:11: robots.blue.1: unknown control software \"idel\""});
  expectStarts(saidOf("[robots.blue.1.control]\nprogram = \"idle\"\nspeed = 2"),
               {"10:1: robots.blue.1: control software \"idle\" has no parameter \"speed\""});
}

TEST(BuilderErrors, UnknownObjectsAndProperties) {
  expectStarts(
      saidOf("[robots.red.1.properties]\n\"trunck.mass\" = 1\n\"trunk.mas\" = 1\n\"knee_left.mass\" = \"heavy\""),
      {"9:1: robots.red.1 has no object \"trunck\" (did you mean \"robots.red.1.trunk\"?)",
       "10:15: unknown property \"mas\" of robots.red.1.trunk: no module declares it (did you mean \"mass\"?)"});
}

TEST(BuilderErrors, PropertiesOfAnotherType) {
  expectStarts(saidOf("[robots.red.1.properties]\n\"knee_left.largest_velocity\" = [1, 2]"),
               {"9:32: property largest_velocity of robots.red.1.knee_left "});
}

TEST(BuilderErrors, MassesThatNothingCanHave) {
  expectStarts(saidOf("[robots.red.1.properties]\n\"trunk.mass\" = -1\n[robots.blue.1.properties]\n"
                      "\"skull.mass\" = \"heavy\""),
               {"9:16: mass of robots.red.1.trunk is -1 kg, expected a number from 0 to 1e6 kg",
                "11:16: mass of robots.blue.1.skull is no number, expected a number from 0 to 1e6 kg"});
}

TEST(BuilderErrors, MistakesOfAllKindsAreToldAtOnce) {
  expectStarts(saidOf("[robots.red.1.control]\nprogram = \"x\"\n[robots.red.1.cameras]\nnose = \"none\"\n"
                      "[robots.red.1.properties]\n\"nose.mass\" = 1\n\"skull.size\" = 2\n"
                      "[robots.blue.1.motion]\nblend_time = -1"),
               {"9:11: robots.red.1: unknown control software \"x\"", "11:8: robots.red.1 has no camera \"nose\"",
                "13:1: robots.red.1 has no object \"nose\"", "14:16: unknown property \"size\"",
                "16:1: parameter blend_time of module kinematic_walking is -1 s"});
}

/// A robot file beside the test's other files, made from KS21's by replacing text.
class BrokenRobots : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ifstream in(kRoot / "robots/ks21.urdf");
    std::stringstream text;
    text << in.rdbuf();
    ks21_ = text.str();
  }
  void TearDown() override { fs::remove(file_); }
  /// The scenario of two such robots.
  std::string scenario(const std::string& from, const std::string& to) {
    const std::size_t at = ks21_.find(from);
    EXPECT_NE(at, std::string::npos);
    line_ = 1 + std::count(ks21_.begin(), ks21_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    std::ofstream(file_) << std::string(ks21_).replace(at, from.size(), to);
    const std::string path = "file = \"" + file_.string() + "\"\n";
    return "[robots.red.1]\n" + path + "pose = [-1, 0, 0]\n[robots.red.2]\n" + path + "pose = [1, 0, 0]\n";
  }
  std::string ks21_;
  fs::path file_ = fs::temp_directory_path() / fmt::format("murosimf_broken_{}.urdf", ::getpid());
  long line_ = 0;
};

TEST_F(BrokenRobots, ALensThatFoldsThePictureIsNamedOnceForAllRobotsOfTheFile) {
  const std::string text = scenario("kc=\"-0.35 0.15 0 0 0\"", "kc=\"-0.9 0.15 0 0 0\"");
  const Lines said = BuiltWorld(text).complaints();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find(fmt::format("urdf:{}: camera chest: ", line_ - 1)), std::string::npos) << said[0];
}

TEST_F(BrokenRobots, ErrorsOfTheRobotFileAreShownOnce) {
  const std::string text = scenario("<link name=\"trunk\">", "<link nam=\"trunk\">");
  const Lines said = BuiltWorld(text).complaints();
  const auto count = [&](const std::string& words) {
    return std::count_if(said.begin(), said.end(), [&](const auto& line) { return line.find(words) != line.npos; });
  };
  EXPECT_EQ(count(fmt::format("urdf:{}: <link>: unknown attribute \"nam\"", line_)), 1)
      << fmt::format("{}", fmt::join(said, "\n"));
  EXPECT_GT(count("link \"trunk\" does not exist"), 0);
}

TEST_F(BrokenRobots, ASurfaceOfWhichNobodyKnowsHowItMeetsTheBall) {
  const std::string text = scenario("surface=\"sole\"", "surface=\"soel\"");
  const Lines said = BuiltWorld(text).complaints();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("surface \"soel\" of foot_right has no pair with the ball's, expected one of hoof, plastic, "
                         "post, sole, turf, or [surfaces.ball-soel] in the scenario (did you mean \"sole\"?)"),
            std::string::npos)
      << said[0];
  BuiltWorld mended(text + "[surfaces.ball-soel]\nstiffness = 3e3\nrestitution_factor = 0.5\n");
  EXPECT_NE(mended.simulation(), nullptr);
}

TEST_F(BrokenRobots, ARobotWithoutTwoSolesCannotWalk) {
  const std::string text = scenario(
      "<sole name=\"sole_left\" side=\"left\" xyz=\"0.01 0 -0.035\" size=\"0.13 0.08\"/>\n"
      "      <pressure_sensor name=\"pressure_left\" sole=\"sole_left\"/>",
      "");
  const Lines said = BuiltWorld(text).complaints();
  ASSERT_FALSE(said.empty());
  EXPECT_NE(said[0].find("1 sole"), std::string::npos) << said[0];
}

}  // namespace
}  // namespace murosimf::test
