// Makers of pictures as scenarios name them: what is refused of those that can do less, and that a maker which works
// elsewhere and hands its pictures over late changes nothing.

#include "murosimf/modules/camera/picture_maker.h"

#include <compare>
#include <deque>

#include "murosimf/simulation/frame_history.h"
#include "scene/built_world.h"

namespace murosimf::test {
namespace {

/// Casts rays, but on request only, out of snapshots of its own: a maker that is not prompt.
class SlowCaster final : public PictureMaker {
 public:
  SlowCaster(const PictureWish& wish, const PaintedGround& ground)
      : wish_(wish), caster_(rayCasterKind()->make(wish, ground)) {}
  void order(const PictureOrder& order) override {
    EXPECT_LT(orders_.size(), wish_.most);
    orders_.emplace_back(*order.scene, order);
  }
  void fetch(Picture& picture, LightPicture& light) override {
    auto& [scene, order] = orders_.front();
    order.scene = &scene;
    caster_->order(order);
    caster_->fetch(picture, light);
    orders_.pop_front();
  }
  bool isPrompt() const override { return false; }
  PictureDrawer drawer() const override { return {}; }

 private:
  PictureWish wish_;
  std::unique_ptr<PictureMaker> caster_;
  std::deque<std::pair<RayScene, PictureOrder>> orders_;
};

std::shared_ptr<PictureMakerKind> slowKind() {
  auto kind = std::make_shared<PictureMakerKind>();
  kind->name = "slow";
  kind->can = {true, true, true, true, true};
  kind->make = [](const PictureWish& wish, const PaintedGround& ground) -> std::unique_ptr<PictureMaker> {
    return std::make_unique<SlowCaster>(wish, ground);
  };
  return kind;
}

PictureMakers withOthers() {
  PictureMakers makers = rayCasterAlone();
  makers.emplace("slow", slowKind());
  auto plain = slowKind();
  plain->name = "plain", plain->can = {};
  makers.emplace("plain", plain);
  auto absent = slowKind();
  absent->name = "absent", absent->missing = "nobody has built it";
  makers.emplace("absent", absent);
  auto broken = slowKind();
  broken->name = "broken";
  broken->make = [](const PictureWish&, const PaintedGround&) -> std::unique_ptr<PictureMaker> {
    throw std::runtime_error("no driver");
  };
  makers.emplace("broken", broken);
  return makers;
}

/// Of one robot's head camera; what is wrong stands in line 9.
std::vector<std::string> saidOf(const std::string& camera) {
  BuiltWorld built("[robots.all]\ncontrol = \"idle\"\n" + kTwoRobots + "[robots.red.1.cameras.head]\n" + camera);
  EXPECT_EQ(built.builder.link(allModules(), idlePrograms(), withOthers()), nullptr);
  std::vector<std::string> said;
  for (const Diagnostic& d : built.diagnostics.all())
    said.push_back(fmt::format("{}:{}: {}", d.where.line, d.where.column, d.message));
  return said;
}

void expectSaid(const std::string& camera, const std::string& words) {
  EXPECT_EQ(saidOf(camera), std::vector<std::string>{words});
}

TEST(PictureMaker, WhatItCannotDoIsRefusedWithItsPlace) {
  expectSaid("module = \"plain\"\nshadows = true",
             "12:11: camera module plain has no shadows, expected a camera without it, or module = \"ray_caster\"");
  expectSaid("module = \"plain\"\nantialias = true",
             "12:13: camera module plain has no antialias, expected a camera without it, or module = \"ray_caster\"");
  expectSaid("module = \"plain\"\nchain = [\"rolling_shutter\"]",
             "12:9: camera module plain has no rolling_shutter, expected a camera without it, or module = "
             "\"ray_caster\"");
  expectSaid("module = \"plain\"\nchain = [\"motion_blur\", \"noise\"]",
             "12:9: camera module plain has no motion_blur, expected a camera without it, or module = \"ray_caster\"");
  expectSaid("module = \"absent\"", "11:10: camera module absent: nobody has built it");
  expectSaid("module = \"broken\"", "11:10: camera robots.red.1.head: no driver");
  expectSaid("module = \"slo\"",
             "11:10: robots.red.1: unknown camera module \"slo\"; expected one of none, absent, broken, plain, "
             "ray_caster, slow, oracle (did you mean \"slow\"?)");
}

TEST(PictureMaker, WhatItNeedNotDoMayBeSaid) {
  BuiltWorld built(kTwoRobots +
                   "[robots.red.1.cameras.head]\nmodule = \"plain\"\nshadows = false\nantialias = false\n"
                   "chain = [\"defocus\", \"noise\", \"latency\"]\n");
  EXPECT_NE(built.builder.link(allModules(), idlePrograms(), withOthers()), nullptr) << built.diagnostics.text();
}

/// Keeps a sum of the bytes of each picture of red's robot, with the moments of its exposure and arrival.
class Summer final : public client::ControlSoftware {
 public:
  struct Seen {
    double arrived = 0, taken = 0;
    std::uint64_t sum = 0;
    auto operator<=>(const Seen&) const = default;
  };
  explicit Summer(std::vector<Seen>& seen) : seen_(seen) {}
  void start(const client::RobotDescription& robot) override { watches_ = robot.team == "red"; }
  void step(const client::SensorFrame& sensors, client::CommandFrame&) override {
    for (const client::CameraPicture& picture : sensors.pictures) {
      std::uint64_t sum = 0;
      for (const std::uint8_t byte : picture.bytes) sum = 31 * sum + byte;
      if (watches_) seen_.push_back({sensors.time, picture.time, sum});
    }
  }
  const client::ControlReport& report() const override { return report_; }
  void archive(StateArchive&) override {}

 private:
  std::vector<Seen>& seen_;
  bool watches_ = false;
  client::ControlReport report_;
};

/// @param back  the frames after this one are run twice, and counted the second time
std::vector<Summer::Seen> seenWith(const std::string& camera, long back = -1) {
  constexpr long kFrames = 500;
  std::vector<Summer::Seen> seen;
  BuiltWorld built("[robots.all]\ncontrol = \"idle\"\n" + kTwoRobots + "[robots.red.1.cameras.head]\n" + camera);
  const auto simulation =
      built.builder.link(allModules(), {{"idle", [&] { return std::make_unique<Summer>(seen); }}}, withOthers());
  EXPECT_EQ(built.diagnostics.text(), "");
  FrameHistory history(*simulation);
  if (back > 0) {
    history.goTo(kFrames);
    history.goTo(back);
    simulation->control()->finish();
    std::erase_if(seen, [&](const Summer::Seen& s) { return s.arrived > simulation->time() + 1e-9; });
  }
  history.goTo(kFrames);
  simulation->control()->finish();
  std::sort(seen.begin(), seen.end());  // what was run twice stands there twice
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  return seen;
}

TEST(PictureMaker, ThatHandsOverLateChangesNoPictureAndNoMoment) {
  for (const std::string chain : {"noise = 0.02", "chain = [\"exposure\", \"noise\"]\nexposure_target = 0.5",
                                  "chain = [\"exposure\", \"noise\", \"latency\"]\nexposure_target = 0.5\n"
                                  "latency_delay = 0.13"}) {
    const auto prompt = seenWith(chain), slow = seenWith("module = \"slow\"\n" + chain);
    EXPECT_GT(prompt.size(), 5U);
    EXPECT_EQ(prompt, slow) << chain;
  }
}

TEST(PictureMaker, PicturesOnTheirWayGoAlongWhereTimeGoesBack) {
  const std::string chain =
      "chain = [\"exposure\", \"noise\", \"latency\"]\nexposure_target = 0.5\nlatency_delay = 0.13";
  EXPECT_EQ(seenWith("module = \"slow\"\n" + chain, 245), seenWith(chain));
}

}  // namespace
}  // namespace murosimf::test
