#include <algorithm>
#include <set>

#include "murosimf-view/panels/all_panels.h"

namespace murosimf {

namespace {

/// A line a renderer: its switch for all objects that have the property, and for the selected one.
class RenderersPanel final : public Panel {
 public:
  RenderersPanel() : Panel("Show", {0.78F, 0, 0.22F, 0.5F}, true) {}

 private:
  void draw(Session& session, SceneViewport& view) override {
    ui::checkbox(named("shadows"), "shadows", &view.shadows);
    ImGui::SameLine();
    ui::checkbox(named("see through"), "see through", &view.see_through);
    ui::checkbox(named("follow"), "follow selected", &view.follows);
    ImGui::Separator();
    if (!ImGui::BeginTable("renderers", 3, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("property");
    ImGui::TableSetupColumn("all", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("selected", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableHeadersRow();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2, 0});  // all lines at once, where the window is not small
    std::set<std::string> seen;
    for (const RendererEntry& entry : session.renderings().entries()) {
      if (seen.insert(entry.name).second) drawEntry(session, entry);
    }
    ImGui::PopStyleVar();
    ImGui::EndTable();
  }

  void drawEntry(Session& session, const RendererEntry& entry) {
    Renderings& renderings = session.renderings();
    int count = 0, shown = 0, selected = 0, selected_shown = 0;
    for (const Rendering& r : renderings.all()) {
      if (renderings.entryOf(r).name != entry.name) continue;
      ++count, shown += r.shown ? 1 : 0;
      if (r.object == session.selected) ++selected, selected_shown += r.shown ? 1 : 0;
    }
    ImGui::TableNextColumn();
    count == 0 ? ImGui::TextDisabled("%s", entry.name.c_str()) : ImGui::TextUnformatted(entry.name.c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s (property %s)", entry.meaning.c_str(), entry.property.c_str());
    ImGui::PushID(entry.name.c_str());
    ImGui::TableNextColumn();
    bool all = count > 0 && shown == count;
    if (count > 0 && ui::checkbox(named(entry.name), "##all", &all)) renderings.show(entry.name, all);
    ImGui::TableNextColumn();
    bool one = selected_shown > 0;
    if (selected > 0 && ui::checkbox(named(entry.name + " of selected"), "##one", &one)) {
      renderings.show(entry.name, one, session.selected);
    }
    ImGui::PopID();
  }
};

}  // namespace

std::unique_ptr<Panel> makeRenderersPanel() { return std::make_unique<RenderersPanel>(); }

}  // namespace murosimf
