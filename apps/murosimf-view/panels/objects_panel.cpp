#include <fmt/format.h>

#include <map>
#include <optional>

#include "murosimf-view/panels/all_panels.h"
#include "murosimf-view/property_words.h"

namespace murosimf {

namespace {

/// The tree of objects above, constants and variables of the selected one below.
class ObjectsPanel final : public Panel {
 public:
  ObjectsPanel() : Panel("Objects", {0, 0.42F, 0.24F, 0.58F}, true) {}

 private:
  void draw(Session& session, SceneViewport&) override {
    if (children_.empty()) prepare(session);
    ImGui::BeginChild("tree", {0, ImGui::GetContentRegionAvail().y * 0.4F}, true);
    for (const ObjectId child : children_[session.world().root()]) drawObject(session, child);
    ImGui::EndChild();
    if (!session.selected.valid()) return ImGui::TextDisabled("nothing selected");
    ImGui::TextUnformatted(session.world().path(session.selected).c_str());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##filter", "filter", filter_, sizeof(filter_));
    ui::remember(named("filter"));
    ImGui::BeginChild("properties");
    drawVariables(session);
    drawConstants(session);
    ImGui::EndChild();
  }

  void prepare(Session& session) {
    words_ = propertyWords(session.modules(), session.simulation().participants());
    const World& world = session.world();
    for (int i = 1; i < world.objectCount(); ++i) children_[world.parent({i})].push_back({i});
  }

  void drawObject(Session& session, ObjectId object) {
    const std::string& path = session.world().path(object);
    const std::string name = path.substr(path.rfind('.') + 1);
    const auto children = children_.find(object);
    const bool leaf = children == children_.end();
    const bool above = session.selected.valid() && session.world().path(session.selected).starts_with(path + ".");
    if (above) ImGui::SetNextItemOpen(true, ImGuiCond_Once);
    ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth;
    if (leaf) flags |= ImGuiTreeNodeFlags_Leaf;
    if (object == session.selected) flags |= ImGuiTreeNodeFlags_Selected;
    const bool unfolded = ImGui::TreeNodeEx(path.c_str(), flags, "%s", name.c_str());
    ui::remember(named(path));
    if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) session.selected = object;
    if (!unfolded) return;
    if (!leaf) {
      for (const ObjectId child : children->second) drawObject(session, child);
    }
    ImGui::TreePop();
  }

  void drawVariables(Session& session) {
    if (!ImGui::CollapsingHeader("variables: click to plot", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const LinkedWorld& linked = session.simulation().linked();
    if (!ImGui::BeginTable("variables", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) return;
    for (const ObjectVariable& v : variablesOf(session.world(), linked, session.selected)) {
      for (int c = 0; c < v.layout->components; ++c) drawNumber(session, v, c, linked);
    }
    ImGui::EndTable();
  }

  void drawNumber(Session& session, const ObjectVariable& v, int component, const LinkedWorld& linked) {
    const std::string part = componentName(v.layout->components, component);
    const std::string label = part.empty() ? v.layout->property : v.layout->property + " " + part;
    if (label.find(filter_) == std::string::npos) return;
    const std::string unit = componentUnit(v.layout->unit, v.layout->components, component);
    const NumberPlace place{v.assembly, v.layout->property, v.layout->subset, v.object, component};
    ImGui::TableNextColumn();
    ImGui::PushID(component);
    if (ui::selectable(named(label), label.c_str(), session.plots().has(place))) {
      session.plots().add(session.simulation(), place, session.world().path(session.selected) + " " + label, unit);
    }
    ImGui::PopID();
    showMeaning(v.layout->property);
    ImGui::TableNextColumn();
    ImGui::Text("%.6g", linked.numberAt(*v.place, *v.layout, v.object, component));
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", unit.c_str());
  }

  void drawConstants(Session& session) {
    if (!ImGui::CollapsingHeader("constants", ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (!ImGui::BeginTable("constants", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) return;
    for (const auto& [name, entry] : session.world().constants(session.selected)) {
      if (name.find(filter_) == std::string::npos) continue;
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(name.c_str());
      showMeaning(name);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(wordsOf(entry).c_str());
      ImGui::TableNextColumn();
      const auto word = words_.find(name);
      if (word != words_.end()) ImGui::TextDisabled("%s", word->second.unit.c_str());
    }
    ImGui::EndTable();
  }

  void showMeaning(const std::string& property) const {
    const auto word = words_.find(property);
    if (word != words_.end() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", word->second.meaning.c_str());
  }

  PropertyWords words_;
  char filter_[64] = "";
  std::map<ObjectId, std::vector<ObjectId>> children_;
};

}  // namespace

std::unique_ptr<Panel> makeObjectsPanel() { return std::make_unique<ObjectsPanel>(); }

}  // namespace murosimf
