// Robot files with meshes and capsules in scenarios: ground, ball, other robots and cameras take them.

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "scene/built_world.h"

namespace murosimf::test {
namespace {

const std::string kAlone = "[referee]\nenabled = false\n[ball]\npresent = false\n";

struct Tumblers {
  explicit Tumblers(const std::string& head, const std::string& robots) : built(head + robots) {
    simulation = built.builder.link(allModules(), idlePrograms());
    if (simulation == nullptr) throw std::runtime_error(built.diagnostics.text());
  }
  void run(double seconds) {
    for (long i = std::lround(seconds / simulation->frameLength()); i > 0; --i) simulation->step();
  }
  ObjectId robot(int number) const { return simulation->world().find(fmt::format("robots.red.{}", number)); }
  Pose base(int number) const { return simulation->linked().handle(robot(number), kBasePose).get(); }

  BuiltWorld built;
  std::unique_ptr<Simulation> simulation;
};

std::string tumbler(int number, const std::string& level, const std::string& pose = "[0, 0, 0]") {
  return fmt::format(
      "[robots.red.{}]\nfile = \"tests/data/tumbler.urdf\"\npose = {}\nlevel = \"{}\"\ncontrol = \"none\"\n", number,
      pose, level);
}

class MeshRobot : public testing::TestWithParam<const char*> {};

TEST_P(MeshRobot, StandsOnTheGroundWhereItIsPut) {
  Tumblers one(kAlone, tumbler(1, GetParam(), "[0.5, 0.2, 1.0]"));
  one.run(2);
  EXPECT_EQ(one.built.diagnostics.errorCount(), 0);
  EXPECT_NEAR(norm(one.base(1).translation - Vector3{0.5, 0.2, 0.05}), 0, 2e-3);
  EXPECT_NEAR(one.base(1).rotation.z.z, 1, 1e-6);
}

TEST_P(MeshRobot, ThrowsTheBallBack) {
  Tumblers one("[referee]\nenabled = false\n[ball]\nposition = [-0.4, 0, 0]\n", tumbler(1, GetParam()));
  one.run(0.5);
  const ObjectId ball = one.simulation->world().find("ball");
  const double radius = *one.simulation->world().find(ball, kBallRadius);
  one.simulation->interventions().placeBody(one.simulation->frame(), ball, {-0.3, 0, radius}, {2, 0, 0});
  one.run(0.3);
  EXPECT_LT(one.simulation->linked().handle(ball, kBodyVelocity).get().x, -0.1);
  EXPECT_GT(one.base(1).translation.x, 1e-4) << "it was to recoil";
}

INSTANTIATE_TEST_SUITE_P(Levels, MeshRobot, testing::Values("full", "fast"),
                         [](const auto& test) { return std::string(test.param); });

TEST(MeshRobots, OfOneFileShareTheirHulls) {
  const Tumblers two(kAlone, tumbler(1, "full") + tumbler(2, "full", "[1, 0, 0]"));
  const auto hullOf = [&](int number) {
    return two.simulation->world().findShared(two.robot(number), kShapes)->front().hull;
  };
  ASSERT_NE(hullOf(1), nullptr);
  EXPECT_EQ(hullOf(1), hullOf(2));
}

TEST(MeshRobots, AreDrawnAsTheirTrianglesWhichRobotsOfOneFileShare) {
  const Tumblers two(kAlone, tumbler(1, "full") + tumbler(2, "full", "[1, 0, 0]"));
  RayScene scene = two.simulation->view().initialScene();
  two.simulation->step();
  two.simulation->view().snapshot(0, scene);
  std::vector<Drawable> drawn;
  for (const Drawable& d : scene.drawables) {
    const bool of_robots = d.label == two.simulation->view().labelOf(two.robot(1)) ||
                           d.label == two.simulation->view().labelOf(two.robot(2));
    if (of_robots) drawn.push_back(d);
  }
  ASSERT_EQ(drawn.size(), 4U);
  ASSERT_NE(drawn[0].mesh, nullptr);
  EXPECT_EQ(drawn[0].mesh, drawn[2].mesh);
  EXPECT_EQ(drawn[0].mesh->triangleCount(), 12);
  EXPECT_NEAR(norm(drawn[0].mesh->halfSize() - Vector3{0.05, 0.05, 0.05}), 0, 1e-8);
  EXPECT_EQ(drawn[1].shape.kind, ShapeKind::kCapsule);
  EXPECT_EQ(drawn[1].mesh, nullptr);
}

TEST(SceneView, SaysWhatALabelStandsFor) {
  const Tumblers one("[referee]\nenabled = false\n", tumbler(1, "full"));
  const SceneView& view = one.simulation->view();
  const SeenClass& robot = view.classOf(view.labelOf(one.robot(1)));
  EXPECT_EQ(robot.kind, SeenKind::kRobot);
  EXPECT_EQ(robot.path, "robots.red.1");
  const SeenClass& ball = view.classOf(view.labelOf(one.simulation->world().find("ball")));
  EXPECT_EQ(ball.kind, SeenKind::kFreeBody);
  EXPECT_EQ(ball.path, "ball");
  EXPECT_EQ(view.classOf(kGroundLabel).kind, SeenKind::kTurf);
  EXPECT_EQ(view.classOf(kLineLabel).kind, SeenKind::kLine);
  EXPECT_EQ(view.classOf(kSkyLabel).kind, SeenKind::kSky);
  EXPECT_THROW(view.classOf(1000), std::out_of_range);
}

/// A cube of 0.1 m and 1 kg, as a file.
struct BlockFile {
  std::string path;
  explicit BlockFile(const std::string& shape)
      : path((std::filesystem::temp_directory_path() /
              fmt::format("murosimf_block_{}_{}.urdf", ::getpid(), shape.substr(1, 3)))
                 .string()) {
    const std::string inertia = "ixx='0.0016666667' iyy='0.0016666667' izz='0.0016666667'";
    std::ofstream(path)
        << "<robot name='block'><murosimf surface='plastic'/><link name='block'><inertial><mass value='1'/>"
        << "<inertia " << inertia << "/></inertial><collision><geometry>" << shape
        << "</geometry></collision><murosimf><imu name='imu'/></murosimf></link></robot>\n";
  }
  ~BlockFile() { std::filesystem::remove(path); }
};

struct Flight {
  SpatialMotion<double> first, second;
  double momentum = 0;
};

/// How two cubes fly on of which the first hits the second beside its middle.
Flight collide(const std::string& first, const std::string& second) {
  const auto robot = [](int number, const std::string& file) {
    return fmt::format("[robots.red.{}]\nfile = \"{}\"\npose = [{}, 0, 0]\nlevel = \"full\"\ncontrol = \"none\"\n",
                       number, file, number);
  };
  Tumblers two(kAlone, robot(1, first) + robot(2, second));
  two.simulation->step();
  const auto put = [&](int number, const Pose& X_WB, const Vector3& v) {
    two.simulation->linked().handle(two.robot(number), kBasePose).set(X_WB);
    two.simulation->linked().handle(two.robot(number), kBaseVelocity).set({{}, v});
  };
  put(1, {{}, {0, 0, 3}}, {1, 0, 0}), put(2, {{}, {0.15, 0.03, 3}}, {});
  two.run(0.2);
  Flight flight;
  const auto velocity = [&](int number) {
    return two.simulation->linked().handle(two.robot(number), kBaseVelocity).get();
  };
  flight.first = velocity(1), flight.second = velocity(2);
  flight.momentum = (two.base(1).rotation * flight.first.v + two.base(2).rotation * flight.second.v).x;
  return flight;
}

TEST(MeshRobots, CollideWithOthersAsABoxOfTheirSizeDoes) {
  const BlockFile box("<box size='0.1 0.1 0.1'/>");
  const BlockFile mesh("<mesh filename='" + (kRoot / "tests/data/meshes/cube.stl").string() + "'/>");
  const Flight expected = collide(box.path, box.path);
  EXPECT_GT(expected.second.v.x, 0.3) << "it was to be hit";
  EXPECT_GT(std::fabs(expected.second.w.z), 0.5) << "beside its middle";
  for (const auto& [first, second] : {std::pair{mesh.path, box.path}, {box.path, mesh.path}, {mesh.path, mesh.path}}) {
    const Flight flight = collide(first, second);
    EXPECT_NEAR(flight.momentum, 1, 1e-3);
    EXPECT_LT(norm(flight.first.v - expected.first.v), 0.01) << first << " " << second;
    EXPECT_LT(norm(flight.second.v - expected.second.v), 0.01) << first << " " << second;
    EXPECT_LT(norm(flight.second.w - expected.second.w), 0.1) << first << " " << second;
  }
}

}  // namespace
}  // namespace murosimf::test
