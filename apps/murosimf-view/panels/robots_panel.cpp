#include <fmt/format.h>

#include "murosimf-view/panels/all_panels.h"

namespace murosimf {

namespace {

/// A line a robot: what it is at, its level of detail as a menu, what its control software does.
class RobotsPanel final : public Panel {
 public:
  RobotsPanel() : Panel("Robots", {0.78F, 0.5F, 0.22F, 0.28F}, true) {}

 private:
  void draw(Session& session, SceneViewport&) override {
    if (!ImGui::BeginTable("robots", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("robot");
    ImGui::TableSetupColumn("level of detail");
    ImGui::TableSetupColumn("is at");
    ImGui::TableHeadersRow();
    const std::vector<ObjectId>& robots = session.simulation().participants().robots;
    const int count = session.simulation().control()->robotCount();
    for (int i = 0; i < count; ++i) drawRobot(session, robots[static_cast<std::size_t>(i)], i);
    ImGui::EndTable();
  }

  void drawRobot(Session& session, ObjectId robot, int number) {
    const std::string& path = session.world().path(robot);
    ImGui::TableNextColumn();
    const std::string name = path.substr(path.find('.') + 1);  // "red.1"
    if (ui::selectable(named(path), name.c_str(), session.selected == robot)) session.selected = robot;
    ImGui::TableNextColumn();
    drawLevels(session, robot, path);
    ImGui::TableNextColumn();
    if (session.recording() == nullptr) ImGui::TextUnformatted(session.game().tagOf(number).c_str());
  }

  /// Only levels with which it was linked can be chosen.
  void drawLevels(Session& session, ObjectId robot, const std::string& path) {
    if (session.recording() != nullptr) return ImGui::TextDisabled("not recorded");
    const LinkedWorld& linked = session.simulation().linked();
    const int count = linked.levelCount(robot), now = linked.levelOf(robot);
    const std::string shown = nameOfLevel(session, robot, now);
    if (count == 1) return ImGui::TextDisabled("%s", shown.c_str());
    ImGui::SetNextItemWidth(-1);
    const bool unfolded = ImGui::BeginCombo(("##" + path).c_str(), shown.c_str());
    ui::remember(named("level of " + path));
    if (!unfolded) return;
    for (int level = 0; level < count; ++level) {
      const std::string name = nameOfLevel(session, robot, level);
      if (!ui::selectable(named(path + " " + name), name.c_str(), level == now)) continue;
      Intervention exchange;
      exchange.kind = Intervention::Kind::kExchangeLevel;
      exchange.object = robot;
      exchange.level = level;
      session.history().request(exchange);
    }
    ImGui::EndCombo();
  }

  /// A level has no name once it is linked: its module of motion tells it.
  static std::string nameOfLevel(Session& session, ObjectId robot, int level) {
    const std::string& path = session.world().path(robot);
    for (const PassReport& pass : session.simulation().linked().passes()) {
      if (pass.assembly != path || pass.level != level) continue;
      for (const char* motion : {"walking", "dynamics"}) {
        if (pass.module.find(motion) != std::string::npos) return pass.module;
      }
    }
    return fmt::format("level {}", level);
  }
};

}  // namespace

std::unique_ptr<Panel> makeRobotsPanel() { return std::make_unique<RobotsPanel>(); }

}  // namespace murosimf
