// Chains of picture modules as scenarios name them: what is accepted, what is refused, what arrives.

#include "murosimf/scene/picture_chain.h"

#include "scene/built_world.h"

namespace murosimf::test {
namespace {

/// One robot whose head camera is set as told; what is wrong stands in line 9.
std::vector<std::string> saidOf(const std::string& camera) {
  return BuiltWorld(kTwoRobots + "[robots.red.1.cameras.head]\n" + camera).complaints();
}

void expectSaid(const std::string& camera, const std::string& start) {
  const std::vector<std::string> said = saidOf(camera);
  ASSERT_EQ(said.size(), 1U) << fmt::format("{}", fmt::join(said, "\n"));
  EXPECT_TRUE(startsWith(said[0], start)) << said[0];
}

TEST(PictureChain, MistakesAreToldWithTheirPlace) {
  expectSaid("chain = [\"defocuss\"]",
             "9:9: unknown picture module \"defocuss\"; expected one of rolling_shutter, "
             "motion_blur, latency, exposure, white_balance, vignetting, defocus, noise (did "
             "you mean \"defocus\"?)");
  expectSaid("chain = 3", "9:9: chain is no list of names, expected some of ");
  expectSaid("chain = [\"noise\", \"noise\"]", "9:9: \"noise\" stands twice in the chain");
  expectSaid("chain = [\"noise\", \"motion_blur\"]", "9:9: \"motion_blur\" stands behind \"noise\", expected first: ");
  expectSaid("chain = [\"latency\", \"noise\"]", "9:9: \"noise\" stands behind \"latency\", expected before it");
  expectSaid("chain = [\"noise\"]\nnoise_read = 2", "10:14: noise_read is 2, expected a number from 0 to 0.5");
  expectSaid("chain = [\"noise\"]\ndefocus_deviation = 2",
             "10:1: defocus_deviation belongs to the picture module defocus, which is not in the camera's chain");
  expectSaid("format = \"yuv\"", "9:10: format is \"yuv\", expected one of rgb, bgr, yuyv (did you mean \"yuyv\"?)");
}

/// Keeps what arrives.
class Viewer final : public client::ControlSoftware {
 public:
  struct Seen {
    double arrived = 0, taken = 0;
    client::PixelFormat format = client::PixelFormat::kRgb;
    std::vector<std::uint8_t> bytes;
  };
  explicit Viewer(std::vector<Seen>& seen) : seen_(seen) {}
  void start(const client::RobotDescription& robot) override {
    number_ = robot.team == "red" ? robot.number : 0;
    for (std::size_t i = 0; i < robot.cameras.size(); ++i) {
      if (robot.cameras[i].name == "head") camera_ = static_cast<int>(i);
    }
  }
  void step(const client::SensorFrame& sensors, client::CommandFrame&) override {
    for (const client::CameraPicture& picture : sensors.pictures) {
      if (number_ == 1 && picture.camera == camera_)
        seen_.push_back({sensors.time, picture.time, picture.format, {picture.bytes.begin(), picture.bytes.end()}});
    }
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(StateArchive&) override {}

 private:
  std::vector<Seen>& seen_;
  int number_ = 0, camera_ = 0;
  client::ControlReport report_;
};

std::vector<Viewer::Seen> seenWith(const std::string& camera) {
  std::vector<Viewer::Seen> seen;
  const BuiltWorld built("[robots.all]\ncontrol = \"idle\"\n" + kTwoRobots + "[robots.red.1.cameras.head]\n" + camera);
  Diagnostics diagnostics;
  WorldBuilder builder(built.scene, diagnostics);
  const auto simulation = builder.link(allModules(), {{"idle", [&] { return std::make_unique<Viewer>(seen); }}});
  EXPECT_EQ(diagnostics.text(), "");
  for (int i = 0; i < 400; ++i) simulation->step();
  simulation->control()->finish();
  return seen;
}

TEST(PictureChain, LatencyDelaysPicturesAndChangesNothingElse) {
  const auto prompt = seenWith("chain = [\"noise\"]"),
             late = seenWith("chain = [\"noise\", \"latency\"]\nlatency_delay = 0.12");
  ASSERT_GT(late.size(), 3U);
  ASSERT_GT(prompt.size(), late.size());
  for (std::size_t i = 0; i < late.size(); ++i) {
    EXPECT_EQ(late[i].taken, prompt[i].taken);
    EXPECT_NEAR(late[i].arrived - late[i].taken, 0.12, 0.01 + 1e-9) << "the next step of the control software";
    EXPECT_GE(late[i].arrived - late[i].taken, 0.12 - 1e-9);
    EXPECT_EQ(late[i].bytes, prompt[i].bytes);
  }
}

TEST(PictureChain, TheOrderOfModulesCounts) {
  const auto first = seenWith("chain = [\"noise\", \"defocus\"]"),
             second = seenWith("chain = [\"defocus\", \"noise\"]");
  ASSERT_FALSE(first.empty());
  EXPECT_NE(first[0].bytes, second[0].bytes) << "defocus smoothes noise that is there already";
}

TEST(PictureChain, TimeIsTheMiddleOfTheExposure) {
  const auto prompt = seenWith("noise = 0");
  const auto blurred = seenWith(
      "chain = [\"rolling_shutter\", \"motion_blur\"]\nrolling_shutter_readout = 0.02\n"
      "motion_blur_exposure = 0.01\nmotion_blur_samples = 2");
  ASSERT_EQ(blurred.size(), prompt.size());
  EXPECT_NEAR(prompt[0].taken - blurred[0].taken, 0.015, 1e-12);
}

TEST(PictureChain, FormatsArriveAsTheySay) {
  const auto rgb = seenWith("noise = 0"), bgr = seenWith("noise = 0\nformat = \"bgr\""),
             yuyv = seenWith("noise = 0\nformat = \"yuyv\"");
  ASSERT_FALSE(rgb.empty());
  EXPECT_EQ(bgr[0].format, client::PixelFormat::kBgr);
  EXPECT_EQ(yuyv[0].format, client::PixelFormat::kYuyv);
  EXPECT_EQ(3 * yuyv[0].bytes.size(), 2 * rgb[0].bytes.size());
  for (std::size_t i = 0; i + 2 < rgb[0].bytes.size(); i += 3) {
    ASSERT_EQ(rgb[0].bytes[i], bgr[0].bytes[i + 2]);
    ASSERT_EQ(rgb[0].bytes[i + 2], bgr[0].bytes[i]);
  }
}

}  // namespace
}  // namespace murosimf::test
