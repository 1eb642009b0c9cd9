#include <fmt/format.h>

#include <cmath>

#include "murosimf-view/panels/all_panels.h"
#include "murosimf/soccer/match.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

/// A place on the ground, seen from a robot: x forward, y to its left [m].
struct Near {
  double x = 0, y = 0;
};

Near seenFrom(const PlanarPose& robot, double x, double y) {
  const SinCos<double> a = sincos(robot.heading);
  const double dx = x - robot.x, dy = y - robot.y;
  return {a.cos * dx + a.sin * dy, -a.sin * dx + a.cos * dy};
}

constexpr ImU32 kTruth = IM_COL32(120, 230, 120, 255), kBelief = IM_COL32(255, 170, 60, 255);

/// The marks of what was found: balls and robots as rings, posts and poles as squares, points of lines as dots.
constexpr ImU32 kFound = IM_COL32(205, 150, 255, 255);

/// What the control software of the selected robot believes, in the robot's coordinates, against what is: lines of the
/// field from where it believes to stand, what it found in its last pictures, its ball and the truth.
class MapPanel final : public Panel {
 public:
  MapPanel() : Panel("Map", {0.78F, 0.5F, 0.22F, 0.5F}, false) {}

 private:
  void draw(Session& session, SceneViewport&) override {
    const int robot = robotOf(session);
    Simulation& simulation = session.simulation();
    if (robot < 0) return ImGui::TextDisabled("no robot");
    simulation.control()->finish();
    const client::ControlReport* report = simulation.control()->report(robot);
    const ObjectId object = simulation.participants().robots[static_cast<std::size_t>(robot)];
    ImGui::TextUnformatted(session.world().path(object).c_str());
    ImGui::SameLine();
    ImGui::TextColored({0.47F, 0.9F, 0.47F, 1}, "truth");
    ImGui::SameLine();
    ImGui::TextColored({1, 0.67F, 0.24F, 1}, "belief");
    ImGui::SameLine();
    ImGui::TextColored({0.8F, 0.59F, 1, 1}, "found");
    const Pose X_WB = simulation.linked().handle(object, kBasePose).get();
    const PlanarPose truth{X_WB.translation.x, X_WB.translation.y, toRollPitchYaw(X_WB.rotation).z};
    begin();
    drawField(session, truth, kTruth);
    if (report != nullptr) drawBelief(session, *report, object, truth);
    for (std::size_t k = 0; k < simulation.control()->robot(robot).cameraCount(); ++k) {
      for (const client::Percept& percept : session.game().keeper().of(robot, k).percepts) drawFound(percept);
    }
    drawBall(session, truth);
    drawRobot();
  }

  /// The selected robot, or the one that has the selected part; else the first one.
  static int robotOf(Session& session) {
    const auto& robots = session.simulation().participants().robots;
    const int count = session.simulation().control()->robotCount();
    for (int i = 0; i < count && session.selected.valid(); ++i) {
      if (session.world().path(session.selected).starts_with(session.world().path(robots[static_cast<std::size_t>(i)])))
        return i;
    }
    return count == 0 ? -1 : 0;
  }

  /// Robot in the middle, its x upwards.
  void begin() {
    ImGui::SetNextItemWidth(140);
    ImGui::SliderFloat("metres shown", &reach_, 0.5F, 8, "%.1f");
    origin_ = ImGui::GetCursorScreenPos();
    size_ = ImGui::GetContentRegionAvail();
    size_.y = std::max(60.0F, size_.y - 34);
    scale_ = 0.5F * std::min(size_.x, size_.y) / reach_;
    canvas_ = ImGui::GetWindowDrawList();
    canvas_->PushClipRect(origin_, {origin_.x + size_.x, origin_.y + size_.y}, true);
    canvas_->AddRectFilled(origin_, {origin_.x + size_.x, origin_.y + size_.y}, IM_COL32(22, 45, 26, 255));
  }
  ImVec2 place(const Near& p) const {
    return {origin_.x + 0.5F * size_.x - scale_ * static_cast<float>(p.y),
            origin_.y + 0.5F * size_.y - scale_ * static_cast<float>(p.x)};
  }

  void drawField(Session& session, const PlanarPose& from, ImU32 colour) {
    const World& world = session.world();
    const PaintedGround* ground = world.findShared(world.root(), kGround);
    if (ground == nullptr) return;
    for (const PaintedLine& line : ground->lines) {
      canvas_->AddLine(place(seenFrom(from, line.a_x, line.a_y)), place(seenFrom(from, line.b_x, line.b_y)), colour,
                       1.5F);
    }
    for (const PaintedCircle& circle : ground->circles) {
      canvas_->AddCircle(place(seenFrom(from, circle.x, circle.y)), scale_ * static_cast<float>(circle.radius), colour,
                         48, 1.5F);
    }
  }

  void drawBelief(Session& session, const client::ControlReport& report, ObjectId robot, const PlanarPose& truth) {
    if (report.pose_valid) {
      const bool red = session.world().path(robot).find(".red.") != std::string::npos;
      PlanarPose pose = report.pose;  // in the team's own frame: turned by pi for the team that attacks -x
      const TeamSettings& team = red ? session.scene().red : session.scene().blue;
      if (!*team.attacks_positive_x) pose = {-pose.x, -pose.y, pose.heading + kPi};
      drawField(session, pose, kBelief);
      words_ = fmt::format("pose off by {:.2f} m, {:.1f} deg", std::hypot(pose.x - truth.x, pose.y - truth.y),
                           std::abs(std::remainder(pose.heading - truth.heading, 2 * kPi)) * 180 / kPi);
    } else {
      words_ = "does not know where it is";
    }
    if (!report.ball_known) return;
    const ImVec2 ball = place({report.ball_x, report.ball_y});
    canvas_->AddCircleFilled(ball, 5, kBelief);
  }

  void drawFound(const client::Percept& percept) {
    const SinCos<double> a = sincos(percept.bearing);
    const ImVec2 p = place({percept.distance * a.cos, percept.distance * a.sin});
    switch (percept.kind) {
      case client::Percept::Kind::kLinePoint:
        return canvas_->AddCircleFilled(p, 2, kFound);
      case client::Percept::Kind::kPost:
      case client::Percept::Kind::kPole:
      case client::Percept::Kind::kObstacle:
        return canvas_->AddRect({p.x - 4, p.y - 4}, {p.x + 4, p.y + 4}, kFound, 0, 0, 1.5F);
      case client::Percept::Kind::kRobot:
        return canvas_->AddCircle(p, 8, kFound, 16, 1.5F);
      case client::Percept::Kind::kBall:
        return canvas_->AddCircle(p, 4, kFound, 12, 1.5F);
    }
  }

  void drawBall(Session& session, const PlanarPose& truth) {
    for (const ObjectId body : session.simulation().participants().free_bodies) {
      const Vector3 p_W = session.simulation().linked().handle(body, kBasePose).get().translation;
      canvas_->AddCircle(place(seenFrom(truth, p_W.x, p_W.y)), 6, kTruth, 16, 2);
    }
  }

  void drawRobot() {
    const ImVec2 c = place({0, 0});
    canvas_->AddTriangleFilled({c.x, c.y - 10}, {c.x + 6, c.y + 6}, {c.x - 6, c.y + 6}, IM_COL32(240, 240, 240, 255));
    canvas_->PopClipRect();
    ImGui::Dummy(size_);
    ImGui::TextUnformatted(words_.c_str());
    words_.clear();
  }

  ImVec2 origin_{}, size_{};
  float scale_ = 1, reach_ = 3;
  ImDrawList* canvas_ = nullptr;
  std::string words_;
};

}  // namespace

std::unique_ptr<Panel> makeMapPanel() { return std::make_unique<MapPanel>(); }

}  // namespace murosimf
