// murosimf render: pictures of robots' cameras, one or a whole set for training.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "game/game.h"
#include "game/game_observers.h"
#include "game/picture_drawers.h"
#include "murosimf/commands.h"
#include "murosimf/photographer.h"
#include "murosimf/scene/scenario_reader.h"
#include "murosimf/simulation/canvas.h"
#include "murosimf/simulation/png_writer.h"

namespace murosimf {

namespace {

/// Millimetres, as depth cameras deliver them; 0 for the sky and what is too far.
std::vector<std::uint16_t> millimetres(const std::vector<float>& depth) {
  std::vector<std::uint16_t> numbers;
  numbers.reserve(depth.size());
  for (const float z : depth) {
    const float rounded = 1000.0F * z + 0.5F;
    numbers.push_back(rounded < 65535.0F ? static_cast<std::uint16_t>(rounded) : std::uint16_t{0});
  }
  return numbers;
}

Picture withBoxes(const Picture& picture, const std::vector<LabelledObject>& objects) {
  Picture drawn = picture;
  Canvas canvas(drawn);
  for (const auto& labelled : visibleMasks(picture)) {
    const auto label = labelled.first;
    const VisibleMask& mask = labelled.second;
    const auto object = std::find_if(objects.begin(), objects.end(), [&](const auto& o) { return o.label == label; });
    if (object == objects.end()) continue;
    const Rgb colour = object->category == "ball" ? Rgb{255, 120, 0} : Rgb{255, 255, 0};
    canvas.rectangle({mask.left - 1.0, mask.top - 1.0}, {mask.right + 1.0, mask.bottom + 1.0}, colour);
    canvas.label({static_cast<double>(mask.left), mask.top - 10.0}, object->name, colour);
  }
  return drawn;
}

void writeAs(const std::string& what, const std::string& file, const Picture& picture,
             const std::vector<LabelledObject>& objects) {
  if (what == "depth") return writePng16(file, picture.width, picture.height, millimetres(picture.depth));
  if (what == "labels") {
    writePng16(file, picture.width, picture.height, picture.label);
    for (const LabelledObject& object : objects) fmt::print("{:5} {}\n", object.label, object.name);
    fmt::print("{:5} ground\n{:5} sky\n", kGroundLabel, kSkyLabel);
    return;
  }
  writePng(file, what == "boxes" ? withBoxes(picture, objects) : picture);
}

/// A game that is played as far as pictures are wanted.
class Shooting {
 public:
  Shooting(const RenderArguments& arguments, const Scene& scene, Diagnostics& diagnostics)
      : arguments_(arguments), simulation_(buildGame(scene, diagnostics)) {
    if (simulation_ == nullptr) return;
    fmt::print(stderr, "{}", drawerText(*simulation_));
    observers_ = std::make_unique<GameObservers>(scene, *simulation_);
    photographer_ = std::make_unique<Photographer>(scene, *simulation_, arguments.cameras, diagnostics);
  }
  /// Observers must not be gone while a program still runs, as after a picture that could not be written.
  ~Shooting() {
    if (simulation_ == nullptr) return;
    try {
      simulation_->control()->finish();
    } catch (...) {  // NOLINT: it has been thrown before, or nobody is left to tell
    }
  }
  Shooting(const Shooting&) = delete;
  Shooting& operator=(const Shooting&) = delete;

  void takeOne() {
    playTo(arguments_.at);
    writeAs(arguments_.as, arguments_.out, photographer_->take(0), photographer_->objects());
    simulation_->control()->finish();
    fmt::print("{}: {} of {} at {:.3f} s\n", arguments_.out, arguments_.as, photographer_->name(0),
               simulation_->time());
  }
  void takeMany(double duration) {
    CocoDataset dataset(arguments_.dataset, photographer_->objects());
    for (long k = 0; arguments_.at + static_cast<double>(k) * arguments_.every <= duration + 1e-9; ++k) {
      playTo(arguments_.at + static_cast<double>(k) * arguments_.every);
      for (std::size_t i = 0; i < photographer_->cameras(); ++i)
        dataset.add(photographer_->take(i), photographer_->name(i), simulation_->frame(), simulation_->time());
    }
    simulation_->control()->finish();
    dataset.finish();
    fmt::print("{}: {} pictures, {} objects seen in them\n", arguments_.dataset, dataset.pictures(),
               dataset.annotations());
  }

 private:
  /// At least one frame: before the first one nothing has a place.
  void playTo(double time) {
    const long frames = std::max(1L, std::lround(time / simulation_->frameLength()));
    while (simulation_->frame() < frames) simulation_->step();
  }

  const RenderArguments& arguments_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<GameObservers> observers_;
  std::unique_ptr<Photographer> photographer_;
};

}  // namespace

int renderPictures(const RenderArguments& arguments) {
  Diagnostics diagnostics;
  const std::optional<Scene> scene = readScenario(arguments.scenario, arguments.overrides, diagnostics);
  if (scene) {
    Shooting shooting(arguments, *scene, diagnostics);
    fmt::print(stderr, "{}", diagnostics.text());
    if (diagnostics.hasErrors()) return kWrongInput;
    if (arguments.dataset.empty())
      shooting.takeOne();
    else
      shooting.takeMany(*scene->simulation.duration);
    return 0;
  }
  fmt::print(stderr, "{}", diagnostics.text());
  return kWrongInput;
}

}  // namespace murosimf
