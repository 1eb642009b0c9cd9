#include <fmt/format.h>

#include <deque>

#include "murosimf-view/panels/all_panels.h"
#include "murosimf-view/shown_picture.h"
#include "murosimf/simulation/percept_overlay.h"

namespace murosimf {

namespace {

/// Pictures of robots' cameras with what their control software found in them: of the selected robot, or of all. A
/// camera that tells what it sees in the place of a picture has a plain one.
class CamerasPanel final : public Panel {
 public:
  CamerasPanel() : Panel("Cameras", {0.24F, 0.6F, 0.54F, 0.4F}, false) {}

 private:
  struct Inset {
    int robot = 0;
    std::size_t camera = 0;
    ShownPicture shown;
    double time = -1;  // of the picture that is shown [s]
    long frame = -1;   // in which that was looked for
    std::string caption;
  };

  void draw(Session& session, SceneViewport&) override {
    if (!listed_) list(session);
    ui::checkbox(named("percepts"), "percepts", &percepts_);
    ImGui::SameLine();
    ui::checkbox(named("selected only"), "of the selected robot only", &selected_only_);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(120);
    ImGui::SliderFloat("width", &width_, 120, 640, "%.0f px");
    if (insets_.empty()) ImGui::TextDisabled("no robot has a camera that is on");
    update(session);
    for (Inset& inset : insets_) {
      if (isWanted(session, inset)) drawInset(inset);
    }
  }

  void list(Session& session) {
    listed_ = true;
    const ControlLoop& control = *session.simulation().control();
    for (int i = 0; i < control.robotCount(); ++i) {
      for (std::size_t k = 0; k < control.robot(i).cameraCount(); ++k) {
        if (control.robot(i).camera(k) == nullptr) continue;
        Inset& inset = insets_.emplace_back();
        inset.robot = i, inset.camera = k;
      }
    }
  }

  bool isWanted(Session& session, const Inset& inset) const {
    if (!selected_only_ || !session.selected.valid()) return true;
    const std::string& path =
        session.world().path(session.simulation().participants().robots[static_cast<std::size_t>(inset.robot)]);
    return session.world().path(session.selected).starts_with(path);
  }

  /// Waits for the programs once, where a picture may be new.
  void update(Session& session) {
    Simulation& simulation = session.simulation();
    if (updated_ == simulation.frame() && drawn_percepts_ == percepts_) return;
    const bool all = drawn_percepts_ != percepts_;
    updated_ = simulation.frame(), drawn_percepts_ = percepts_;
    simulation.control()->finish();
    for (Inset& inset : insets_) {
      const KeptPercepts& kept = session.game().keeper().of(inset.robot, inset.camera);
      if (kept.time < 0 || (kept.time == inset.time && !all)) continue;
      inset.time = kept.time;
      const ControlledRobot& robot = simulation.control()->robot(inset.robot);
      const std::span<const client::Percept> percepts(kept.percepts);
      inset.shown.set(cameraPicture(robot, inset.camera, percepts_ ? percepts : percepts.first(0)));
      inset.caption = fmt::format("{}  T {:.2f}  {}", robot.camera(inset.camera)->path(), kept.time, kept.activity);
    }
  }

  void drawInset(const Inset& inset) const {
    if (inset.shown.empty()) return;
    ImGui::BeginGroup();
    inset.shown.draw(width_);
    ImGui::TextUnformatted(inset.caption.c_str());
    ImGui::EndGroup();
    // The next one beside it, where there is room.
    const float end = ImGui::GetItemRectMax().x + width_ - ImGui::GetWindowPos().x;
    if (end < ImGui::GetWindowContentRegionMax().x) ImGui::SameLine();
  }

  std::deque<Inset> insets_;
  bool listed_ = false, percepts_ = true, drawn_percepts_ = true, selected_only_ = true;
  float width_ = 300;
  long updated_ = -1;
};

}  // namespace

std::unique_ptr<Panel> makeCamerasPanel() { return std::make_unique<CamerasPanel>(); }

}  // namespace murosimf
