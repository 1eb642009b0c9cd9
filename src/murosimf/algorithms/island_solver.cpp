#include "murosimf/algorithms/island_solver.h"

#include <algorithm>

namespace murosimf {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Where a point of a body would be after dt with the body's velocities and gravity alone.
Vector3 pointAfter(const FreeBody& b, const Vector3& p_W, const Vector3& gravity, double dt) {
  return p_W + pointVelocity(b, p_W - b.X_WB.translation) * dt + gravity * (0.5 * dt * dt);
}

}  // namespace

PartnerPath pathOf(const ContactPartner& partner, double dt) {
  if (partner.kind == PartnerKind::kStatic || partner.X_start == partner.X_end) return {};
  const Rotation3 turn = partner.X_end.rotation * transposed(partner.X_start.rotation);
  return {(partner.X_end.translation - partner.X_start.translation) * (1 / dt), rotationLog(turn) * (1 / dt)};
}

Pose PartnerPath::at(const ContactPartner& partner, double t) const {
  if (partner.kind == PartnerKind::kStatic || t == 0) return partner.X_start;
  const bool turns = !(angular_velocity == Vector3{});
  const Rotation3& R = partner.X_start.rotation;
  return {turns ? rotationExp(angular_velocity * t) * R : R, partner.X_start.translation + velocity * t};
}

// ---------------------------------------------------------------------------------------------- frame

void IslandSolver::reserve(std::size_t bodies, std::size_t pairs) {
  starts_.reserve(bodies);
  parents_.reserve(2 * bodies + pairs);
  paths_.reserve(pairs);
  contacts_.reserve(pairs);
  points_.reserve(pairs);
  responses_.reserve(9 * pairs * std::min<std::size_t>(pairs, 32));
}

void IslandSolver::advance(FrameContacts& frame, std::span<KeptContact> kept, double dt) {
  frame_ = &frame;
  kept_ = kept;
  paths_.clear();
  for (const ContactPartner& partner : frame.partners) paths_.push_back(pathOf(partner, dt));
  findContacts(dt);
  findIslands();
  starts_.assign(frame.bodies.size(), {});
  auto first = contacts_.begin();
  for (std::size_t body = 0; body < frame.bodies.size(); ++body) {
    const int island = static_cast<int>(body);
    if (rootOf(island) != island) continue;
    // contacts_ is sorted by island, and islands are visited in the same order.
    const auto last = std::find_if(first, contacts_.end(), [&](const WorkContact& c) { return c.island != island; });
    island_ = std::span<WorkContact>(first, last);
    advanceIsland(island, dt);
    first = last;
  }
}

/// Collects the pairs near enough for this frame. Touches: overlaps at the frame's start, or would at its end if
/// nothing acted.
void IslandSolver::findContacts(double dt) {
  constexpr double kMargin = 5e-3;  // [m]: more than another contact's push moves a body in one frame
  contacts_.clear();
  for (std::size_t i = 0; i < frame_->pairs.size(); ++i) {
    WorkContact c;
    c.pair = static_cast<int>(i);
    const SpherePair& pair = frame_->pairs[i];
    place(c, 0);
    flagOverlap(c);
    const double depth = pair.contact.depth;
    if (depth + 2 * dt * norm(relativeVelocity(c)) + kMargin <= 0) {
      keptOf(c) = freshContact(pair.key);
      continue;
    }
    c.touches = depth > 0 || depthAfter(c, dt) > 0;
    contacts_.push_back(c);
  }
}

/// Depth at the frame's end if no contact acted.
double IslandSolver::depthAfter(const WorkContact& c, double dt) const {
  const SpherePair& pair = pairOf(c);
  const FreeBody& a = bodyA(c);
  const Vector3 p_WC = pointAfter(a, a.X_WB * pair.p_BC, frame_->gravity, dt);
  const FreeBody* b = bodyB(c);
  if (!b) return detectSphere(pair, p_WC, paths_[index(pair.partner)].at(*partnerOf(c), dt)).depth;
  const Vector3 p_WD = pointAfter(*b, b->X_WB * pair.X_PS.translation, frame_->gravity, dt);
  return sphereAgainstSphere(p_WC, pair.radius, p_WD, pair.shape.half_size.x).depth;
}

/// A depth that appears between two frames was not reached by moving.
void IslandSolver::flagOverlap(const WorkContact& c) {
  KeptContact& kept = keptOf(c);
  if (pairOf(c).contact.depth > max(kept.depth, 0.0) + settings_.overlap_tolerance) kept.overlapped = 1;
}

int IslandSolver::rootOf(int node) {
  while (parents_[index(node)] != node) node = parents_[index(node)];
  return node;
}
void IslandSolver::unite(int a, int b) {
  const auto [first, last] = std::minmax({rootOf(a), rootOf(b)});
  parents_[index(last)] = first;  // a body is the root, never a responder
}

void IslandSolver::findIslands() {
  const int bodies = static_cast<int>(frame_->bodies.size());
  parents_.resize(frame_->bodies.size() + frame_->responders.size());
  for (std::size_t i = 0; i < parents_.size(); ++i) parents_[i] = static_cast<int>(i);
  for (const WorkContact& c : contacts_) {
    if (!c.touches) continue;
    const ContactPartner* partner = partnerOf(c);
    if (!partner) unite(pairOf(c).body, pairOf(c).other_body);
    if (partner && partner->kind == PartnerKind::kResponsive) unite(pairOf(c).body, bodies + partner->responder);
  }
  for (WorkContact& c : contacts_) c.island = rootOf(pairOf(c).body);
  // Two free bodies that do not touch advance apart, each at its own time: their pair waits for a frame in which they
  // do.
  std::erase_if(contacts_, [&](const WorkContact& c) {
    const SpherePair& pair = pairOf(c);
    return pair.partner < 0 && rootOf(pair.other_body) != c.island;
  });
  std::sort(contacts_.begin(), contacts_.end(), [](const WorkContact& a, const WorkContact& b) {
    return a.island != b.island ? a.island < b.island : a.pair < b.pair;
  });
}

// ---------------------------------------------------------------------------------------------- island

void IslandSolver::advanceIsland(int island, double dt) {
  askResponses();
  const int substeps = substepsOf(dt);
  const double h = dt / substeps;
  for (int i = 0; i < substeps; ++i) substep(island, h * i, h);
}

void IslandSolver::askResponses() {
  responses_.clear();
  for (std::size_t i = 0; i < island_.size(); ++i) {
    const ContactPartner* partner = partnerOf(island_[i]);
    if (partner && partner->kind == PartnerKind::kResponsive && island_[i].rows == 0) askResponse(static_cast<int>(i));
  }
}

/// One matrix for all contacts of the island with the robot of its contact `first`.
void IslandSolver::askResponse(int first) {
  const int responder = partnerOf(island_[index(first)])->responder;
  const auto belongs = [&](const WorkContact& c) {
    const ContactPartner* partner = partnerOf(c);
    return partner && partner->kind == PartnerKind::kResponsive && partner->responder == responder;
  };
  const int matrix = static_cast<int>(responses_.size());
  points_.clear();
  for (WorkContact& c : island_) {
    if (!belongs(c)) continue;
    c.matrix = matrix;
    c.row = static_cast<int>(points_.size());
    points_.push_back({partnerOf(c)->body, pairOf(c).contact.point});
  }
  for (WorkContact& c : island_)
    if (belongs(c)) c.rows = static_cast<int>(points_.size());
  responses_.resize(responses_.size() + 9 * points_.size() * points_.size());
  frame_->responders[index(responder)]->respond(points_, std::span(responses_).subspan(index(matrix)));
}

int IslandSolver::substepsOf(double dt) const {
  double largest = 0;
  for (WorkContact& c : island_) {
    if (!c.touches) continue;
    computeResponses(c);
    largest = max(largest, pairOf(c).surface.stiffness * c.response_n);
  }
  const double wanted = dt * sqrt(largest) / settings_.largest_phase;
  for (int n = 1; n < settings_.most_substeps; ++n)
    if (n >= wanted) return n;
  return settings_.most_substeps;
}

}  // namespace murosimf
