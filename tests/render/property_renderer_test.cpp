// Renderers are matched to objects by the property that they draw.

#include "murosimf/world/vocabulary.h"
#include "render/drawn_game.h"

namespace murosimf {
namespace {

using test::DrawnGame;

/// Draws one ball for every object; throws when told to.
class Marker final : public PropertyRenderer {
 public:
  explicit Marker(const RenderedObject&) {}
  void draw(const RenderMoment& now, DrawList& list) override {
    if (now.time > 0.0015) throw std::runtime_error("cannot draw that");
    list.sphere({}, 1, {});
  }
};

RendererRegistry withMarker(const std::string& property, std::string_view subset_name = subset::kSelf) {
  RendererRegistry all = allRenderers();
  all.add<Marker>({"marker", property, std::string(subset_name), "", true, {}});
  return all;
}

std::size_t markersIn(DrawnGame& game) {
  for (Rendering& r : game.renderings->all()) r.shown = game.renderings->entryOf(r).name == "marker" && r.fault.empty();
  const auto& solid = game.draw().solid();
  return solid.size() <= MeshLibrary::kSphere ? 0 : solid[MeshLibrary::kSphere].size();
}

TEST(PropertyRenderer, showsEveryObjectThatHasItsProperty) {
  DrawnGame robots(withMarker(std::string(kTree.name))), ball(withMarker(std::string(kBodyVelocity.name)));
  DrawnGame joints(withMarker(std::string(kUpperLimit.name), subset::kJoints)), nobody(withMarker("charm"));
  EXPECT_EQ(markersIn(robots), 6U);  // a constant
  EXPECT_EQ(markersIn(ball), 1U);    // a variable
  EXPECT_EQ(markersIn(joints), 6U);  // of a part
  EXPECT_EQ(markersIn(nobody), 0U);
}

TEST(PropertyRenderer, isSwitchedOffWhenItThrowsAndTheOthersDrawOn) {
  DrawnGame game(withMarker(std::string(kTree.name)));
  game.draw();
  const std::size_t boxes = game.list.solid()[MeshLibrary::kBox].size();
  game.simulation->step();  // 2 ms: the marker's end
  game.draw();
  EXPECT_EQ(game.list.solid()[MeshLibrary::kBox].size(), boxes);
  for (const Rendering& r : game.renderings->all()) {
    const bool marker = game.renderings->entryOf(r).name == "marker";
    EXPECT_EQ(r.fault, marker ? "cannot draw that" : "");
    EXPECT_FALSE(marker && r.shown);
  }
  game.renderings->show("marker", true);
  for (const Rendering& r : game.renderings->all()) EXPECT_TRUE(r.fault.empty() || !r.shown);
}

TEST(PropertyRenderer, isSwitchedForOneObjectOrForAll) {
  DrawnGame game;
  const ObjectId robot = game.simulation->participants().robots.front();
  const auto shown = [&] {
    int count = 0;
    for (const Rendering& r : game.renderings->all()) {
      count += r.shown && game.renderings->entryOf(r).name == "collision shape" ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(shown(), 0);
  game.renderings->show("collision shape", true, robot);
  EXPECT_EQ(shown(), 1);
  game.renderings->show("collision shape", true);
  EXPECT_GT(shown(), 6);
  EXPECT_FALSE(game.draw().clearTinted().empty());
}

}  // namespace
}  // namespace murosimf
