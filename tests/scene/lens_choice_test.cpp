/// Lenses of cameras: of the robot file, of calibration files, and of the scenario that replaces them.

#include <unistd.h>

#include <fstream>
#include <sstream>

#include "scene/built_world.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

/// Files that a test writes, gone with it.
class LensChoice : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directory(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  static std::string camera(const std::string& choice) { return "[robots.red.1.cameras]\nhead = " + choice + "\n"; }
  static std::string lensed(const std::string& file, const std::string& more = "") {
    return kTwoRobots + camera("{lens = \"" + file + "\"" + more + "}");
  }
  /// KS21 with one piece of text replaced.
  std::string robot(const std::string& from, const std::string& to) {
    std::ifstream in(kRoot / "robots/ks21.urdf");
    std::stringstream stream;
    stream << in.rdbuf();
    std::string text = stream.str();
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    return "[robots.red.1]\nfile = \"" + write("robot.urdf", text.replace(at, from.size(), to)) +
           "\"\npose = [0, 0, 0]\n";
  }
  static client::CameraDescription head(const BuiltWorld& built) {
    for (const client::CameraDescription& each : built.builder.describe(built.scene.robots[0]).cameras) {
      if (each.name == "head") return each;
    }
    return {};
  }
  static CameraModel model(BuiltWorld& built, const char* robot = "robots.red.1") {
    const World& world = built.builder.world();
    return world.find(world.find(std::string(robot) + ".head"), kCameraModel).value_or(CameraModel{});
  }

  const fs::path folder_ = fs::temp_directory_path() / fmt::format("murosimf_lenses_{}", ::getpid());
  const std::string fisheye_ = "robots/lenses/fisheye_165.yaml";
  /// Corners at 108 deg.
  const std::string wide_ =
      "{width: 512, height: 512, distortion_model: equidistant, D: [0.003, 0.0007, -0.002, 0.0002],\n"
      " K: [191, 0, 255, 0, 191, 257, 0, 0, 1]}\n";
};

TEST_F(LensChoice, TheScenarioReplacesTheLensOfOneCameraOfOneRobot) {
  BuiltWorld built(lensed(fisheye_));
  const CameraModel lens = model(built);
  EXPECT_EQ(lens.kind, LensKind::kFisheye);
  EXPECT_EQ(lens.fx, 288);
  EXPECT_EQ(lens.width, 640);
  EXPECT_EQ(model(built, "robots.blue.1").kind, LensKind::kRational);
  EXPECT_NE(built.simulation(), nullptr);
}

TEST_F(LensChoice, ControlSoftwareIsToldTheLensThatDrawsItsPictures) {
  BuiltWorld built(lensed(fisheye_));
  const client::CameraDescription told = head(built);
  const CameraModel lens = model(built);
  EXPECT_EQ(told.lens, client::LensKind::kFisheye);
  EXPECT_EQ(told.fx, lens.fx);
  EXPECT_EQ(told.cy, lens.cy);
  for (std::size_t i = 0; i < lens.kc.size(); ++i) EXPECT_EQ(told.kc[i], lens.kc[i]);
  EXPECT_EQ(told.linear_from, lens.linear_from);
  const auto simulation = built.simulation();
  ASSERT_NE(simulation, nullptr);
  const ControlledRobot& red =
      simulation->control()->robot(simulation->control()->indexOf(simulation->world().find("robots.red.1")));
  for (std::size_t i = 0; i < red.cameras.size(); ++i) {
    if (red.port.description().cameras[i].name == "head") {
      EXPECT_EQ(red.cameras[i]->model(), lens);
    }
  }
}

TEST_F(LensChoice, ACalibrationWithoutASizeKeepsThatOfTheCamera) {
  const std::string file = write("small.yaml", "{K: [500, 0, 310, 0, 500, 230, 0, 0, 1], D: []}\n");
  BuiltWorld built(lensed(file));
  EXPECT_EQ(model(built).width, 640);
  EXPECT_EQ(model(built).height, 480);
  EXPECT_EQ(model(built).cx, 310);
}

TEST_F(LensChoice, ALensThatDoesNotSeeItsPictureIsRefusedWhereItWasChosenWithItsAngle) {
  const auto said = BuiltWorld(lensed(write("wide.yaml", wide_))).complaints();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(startsWith(said[0], "9:16: camera head: pixel (0, 0) lies beyond what the lens can see")) << said[0];
  EXPECT_NE(said[0].find("at 89 deg from its axis"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("(extrapolate = true)"), std::string::npos) << said[0];
}

TEST_F(LensChoice, ItIsContinuedOnRequestWithAWarning) {
  BuiltWorld built(lensed(write("wide.yaml", wide_), ", extrapolate = true"));
  EXPECT_NE(built.builder.link(allModules(), idlePrograms()), nullptr);
  EXPECT_NE(built.diagnostics.text().find("warning: camera head: the lens does not see its whole picture and is "
                                          "continued linearly from 80 deg off its axis on"),
            std::string::npos)
      << built.diagnostics.text();
  EXPECT_NEAR(model(built).linear_from, std::tan(80 * kPi / 180), 1e-12);
  EXPECT_EQ(head(built).linear_from, model(built).linear_from);
}

TEST_F(LensChoice, ALensThatSeesItsPictureIsNotChangedByExtrapolation) {
  BuiltWorld built(lensed(fisheye_, ", extrapolate = true"));
  EXPECT_TRUE(std::isinf(model(built).linear_from));
  EXPECT_NE(built.simulation(), nullptr);
}

TEST_F(LensChoice, WrongChoicesAreNamed) {
  const auto says = [](const std::string& choice, const std::string& words) {
    const auto said = BuiltWorld(kTwoRobots + camera(choice)).complaints();
    ASSERT_EQ(said.size(), 1U) << fmt::format("{}", fmt::join(said, "\n"));
    EXPECT_NE(said[0].find(words), std::string::npos) << said[0];
  };
  says("{lens = 3}", "9:16: lens is no text, expected the name of a calibration file");
  says("{lens = \"robots/lenses/fisheye_156.yaml\"}",
       "9:16: there is no calibration \"robots/lenses/fisheye_156.yaml\"");
  says("{extrapolate = 1}", "9:23: extrapolate is neither true nor false");
  says("{lense = \"a\"}", "it knows noise, gain, antialias, shadows, lens, extrapolate, chain");
  const std::string broken = write("broken.yaml", "K: [500, 0, 310, 0, 500, 230, 0, 0, 1]\nD: [1, 2, 3]\n");
  says("{lens = \"" + broken + "\"}", "2:4: D has 3 numbers, expected 4, 5, 8 or 12");
}

TEST_F(LensChoice, TheRobotFileNamesACalibrationBesideIt) {
  write("head.yaml", wide_);
  const std::string inline_lens = R"(width="640" height="480" hfov="1.0471975512"
              kc="-0.3 0.11 0.0006 -0.0004 -0.015" period)";
  BuiltWorld built(robot(inline_lens, "lens=\"head.yaml\" extrapolate=\"true\" period"));
  EXPECT_EQ(model(built).kind, LensKind::kFisheye);
  EXPECT_EQ(model(built).width, 512);
  EXPECT_NEAR(model(built).linear_from, std::tan(80 * kPi / 180), 1e-12);
  const auto refused = [&](const std::string& attributes, const std::string& words) {
    const auto said = BuiltWorld(robot(inline_lens, attributes + " period")).complaints();
    ASSERT_FALSE(said.empty());
    EXPECT_NE(said[0].find(words), std::string::npos) << said[0];
  };
  refused("lens=\"head.yaml\"", "camera head: pixel (0, 0) lies beyond");
  refused("lens=\"head.yaml\" width=\"640\"", "attribute \"width\" is 640, expected 512 as in the calibration");
  refused("lens=\"head.yaml\" kc=\"1 2 3 4\"", "attribute \"kc\" stands beside \"lens\", expected one of them");
  refused("lens=\"hat.yaml\"", "attribute \"lens\" is \"hat.yaml\", a file that does not exist");
}

TEST_F(LensChoice, TheRobotFileHasModelsOfItsOwn) {
  const std::string from = "hfov=\"1.0471975512\"\n              kc=\"-0.3 0.11 0.0006 -0.0004 -0.015\"";
  BuiltWorld fisheye(robot(from, "hfov=\"2\" model=\"fisheye\" kc=\"0.01 0 0 0\""));
  EXPECT_EQ(model(fisheye).kind, LensKind::kFisheye);
  EXPECT_EQ(model(fisheye).fx, 320);  // width over angle: equidistant
  EXPECT_EQ(model(fisheye).kc[0], 0.01);
  BuiltWorld rational(robot(from, "fx=\"500\" model=\"rational\" kc=\"0.1 0 0 0 0 0.2 0 0\""));
  EXPECT_EQ(model(rational).kc[5], 0.2);
  BuiltWorld four(robot(from, "fx=\"500\" kc=\"-0.1 0.02 0.001 0.002\""));
  EXPECT_EQ(model(four).kc[3], 0.002);
  const auto refused = [&](const std::string& attributes, const std::string& words) {
    const auto said = BuiltWorld(robot(from, attributes)).complaints();
    ASSERT_FALSE(said.empty());
    EXPECT_NE(said[0].find(words), std::string::npos) << said[0];
  };
  refused("fx=\"500\" kc=\"1 2 3\"", "attribute \"kc\" has 3 numbers, expected 4, 5, 8 or 12");
  refused("fx=\"500\" model=\"fisheye\" kc=\"0 0 0 0 0\"", "attribute \"kc\" has 5 numbers, expected 4: k1 k2 k3 k4");
  refused("fx=\"500\" model=\"fish\"", "attribute \"model\" is \"fish\", expected plumb_bob, rational or fisheye");
}

}  // namespace
}  // namespace murosimf::test
