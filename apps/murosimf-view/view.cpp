#include "murosimf-view/view.h"

#include <epoxy/gl.h>
#include <imgui.h>

#include <cmath>

#include "murosimf/render/body_places.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr double kTurnAPicture = 4;  // [rad] that the mouse turns over the picture's width
constexpr double kZoomAStep = 0.88;  // of the wheel
constexpr std::uint32_t kNobody = 0xffffffff;

ImU32 colourOf(const Tint& tint) { return ImGui::GetColorU32({tint.red, tint.green, tint.blue, tint.cover}); }

}  // namespace

void SceneViewport::follow(Session& session) {
  if (!follows || !session.selected.valid()) return;
  const auto pose = session.simulation().linked().handle(session.selected, kBasePose);
  if (pose.valid()) camera.target_W = pose.get().translation;
}

void SceneViewport::draw(Session& session, int width, int height) {
  follow(session);
  session.draw(list_);
  if (see_through) list_.seeThrough(0.4F);
  drawSelection(session);
  drawPull(session);
  view_ = {camera.model(width, height), camera.pose()};
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  GlLight light;
  light.shadows = shadows;
  light.shadow_centre_W = {camera.target_W.x, camera.target_W.y, 0};
  light.shadow_reach = std::clamp(camera.distance, 1.5, 6.0);
  renderer_.drawColours(list_, view_, light);
  drawTexts();
  drawRefusal(session);
}

/// In the middle below, where no panel stands at first.
void SceneViewport::drawRefusal(const Session& session) const {
  if (session.pull_refused.empty()) return;
  const ImVec2 size = ImGui::CalcTextSize(session.pull_refused.c_str());
  const ImVec2 from{0.5F * (static_cast<float>(view_.camera.width) - size.x),
                    static_cast<float>(view_.camera.height) - 3 * size.y};
  ImDrawList* canvas = ImGui::GetBackgroundDrawList();
  canvas->AddRectFilled({from.x - 8, from.y - 6}, {from.x + size.x + 8, from.y + size.y + 6}, IM_COL32(90, 30, 20, 220),
                        4);
  canvas->AddText(from, IM_COL32(255, 225, 200, 255), session.pull_refused.c_str());
}

void SceneViewport::drawTexts() const {
  ImDrawList* canvas = ImGui::GetBackgroundDrawList();
  for (const TextMark& mark : list_.texts()) {
    const auto place = placeOf(mark.p_W);
    if (!place) continue;
    const ImVec2 size = ImGui::CalcTextSize(mark.text.c_str());
    const ImVec2 from{static_cast<float>(place->u) - 0.5F * size.x, static_cast<float>(place->v) - size.y};
    canvas->AddRectFilled({from.x - 3, from.y - 1}, {from.x + size.x + 3, from.y + size.y + 1}, IM_COL32(0, 0, 0, 130),
                          3);
    canvas->AddText(from, colourOf(mark.tint), mark.text.c_str());
  }
}

std::optional<ImagePoint> SceneViewport::placeOf(const Vector3& p_W) const {
  return projectPoint(view_.camera, applyInverse(view_.X_WC, p_W));
}

SceneViewport::Pick SceneViewport::pick(int u, int v) {
  const int width = view_.camera.width, height = view_.camera.height;
  if (u < 0 || v < 0 || u >= width || v >= height) return {};
  if (labels_ == nullptr || labels_->width() != width || labels_->height() != height) {
    labels_ = std::make_unique<GlLabelTarget>(width, height);
  }
  renderer_.drawLabels(list_, view_, *labels_, kNobody);
  const GlLabelTarget::Seen seen = labels_->at(u, v);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (seen.label == kNobody) return {};
  // Depth back to metres: clipFromWorld()'s third row.
  const double n = view_.near, f = view_.far, clip = 2.0 * static_cast<double>(seen.depth) - 1;
  const double z = 2 * f * n / (f + n - clip * (f - n));
  const Vector3 ray = rayOf(view_.camera, view_.X_WC, {static_cast<double>(u), static_cast<double>(v)});
  return {seen.label, view_.X_WC.translation + ray * z};
}

/// A ring on the ground about what is selected, or about what that is a part of.
void SceneViewport::drawSelection(Session& session) {
  ObjectId object = session.selected;
  while (object.valid() && !session.simulation().linked().handle(object, kBasePose).valid()) {
    object = session.world().parent(object);
  }
  if (!object.valid()) return;
  const Vector3 p_W = session.simulation().linked().handle(object, kBasePose).get().translation;
  constexpr int kSteps = 32;
  constexpr double kRadius = 0.17, kHeight = 0.004;  // [m]
  const auto rim = [&](int step) {
    const SinCos<double> a = sincos(2 * kPi * step / kSteps);
    return Vector3{p_W.x + kRadius * a.cos, p_W.y + kRadius * a.sin, kHeight};
  };
  for (int i = 0; i < kSteps; ++i) list_.rod(rim(i), rim(i + 1), 0.004, {1.0F, 0.85F, 0.1F});
}

void SceneViewport::drawPull(Session& session) {
  if (!session.pull) return;
  const Tint tint{1.0F, 0.5F, 0.1F};
  const Vector3 p_W = session.pull->place(session.simulation());
  list_.sphere(p_W, 0.012, tint);
  list_.arrow(p_W, session.pull->target_W, 0.005, tint);
}

void SceneViewport::beginPull(Session& session) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Pick hit = pick(static_cast<int>(mouse.x), static_cast<int>(mouse.y));
  const ObjectId object = session.renderings().objectOf(labelOfPart(hit.id));
  if (!object.valid()) return;
  session.selected = object;
  session.selected_row = rowOfPart(hit.id);
  session.pull_refused = session.recording() != nullptr ? "a recording feels no pull: go back to the simulation"
                                                        : Pull::refusal(session.simulation(), object);
  if (!session.pull_refused.empty()) return;
  session.pull.emplace(session.simulation(), object, rowOfPart(hit.id), hit.p_W);
}

/// The target stays as far from the camera as it is.
void SceneViewport::movePull(Session& session) const {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const double z = applyInverse(view_.X_WC, session.pull->target_W).z;
  const Vector3 ray = rayOf(view_.camera, view_.X_WC, {static_cast<double>(mouse.x), static_cast<double>(mouse.y)});
  session.pull->target_W = view_.X_WC.translation + ray * z;
}

void SceneViewport::handleMouse(Session& session) {
  const ImGuiIO& io = ImGui::GetIO();
  if (session.pull && !ImGui::IsMouseDown(0)) session.pull.reset();
  if (session.pull) return movePull(session);
  if (ImGui::IsMouseClicked(0)) session.pull_refused.clear();
  if (io.WantCaptureMouse) return;
  if (io.MouseWheel != 0) camera.zoom(std::pow(kZoomAStep, static_cast<double>(io.MouseWheel)));
  const double width = std::max(1, view_.camera.width);
  const double right = static_cast<double>(io.MouseDelta.x) / width,
               down = static_cast<double>(io.MouseDelta.y) / width;
  if (io.KeyCtrl && ImGui::IsMouseClicked(0)) {
    beginPull(session);
  } else if (ImGui::IsMouseDoubleClicked(0)) {
    const Pick hit = pick(static_cast<int>(io.MousePos.x), static_cast<int>(io.MousePos.y));
    session.selected = session.renderings().objectOf(labelOfPart(hit.id));
    session.selected_row = rowOfPart(hit.id);
  } else if (ImGui::IsMouseDown(1) || (ImGui::IsMouseDown(0) && io.KeyShift)) {
    follows = false;
    camera.pan(right, down);
  } else if (ImGui::IsMouseDown(0) && !io.KeyCtrl) {
    camera.turn(-right * kTurnAPicture, down * kTurnAPicture);
  }
}

}  // namespace murosimf
