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

// ---------------------------------------------------------------------------------------------- frame

void IslandSolver::reserve(std::size_t bodies, std::size_t pairs) {
  starts_.reserve(bodies);
  parents_.reserve(2 * bodies + pairs);
  partners_.reserve(2 * pairs);
  members_.reserve(2 * pairs), asked_.reserve(2 * pairs), places_.reserve(2 * pairs), groups_.reserve(2 * pairs);
  contacts_.reserve(pairs);
}

void IslandSolver::advance(FrameContacts& frame, std::span<KeptContact> kept, double dt) {
  frame_ = &frame;
  kept_ = kept;
  partners_.clear();
  for (ContactPartner& partner : frame.partners) {
    partner.recoil = {};
    partners_.emplace_back().path = pathOf(partner, dt);
  }
  findContacts(dt);
  findIslands();
  starts_.assign(frame.bodies.size(), {});
  auto first = contacts_.begin();
  for (int node = 0; node < static_cast<int>(parents_.size()); ++node) {
    if (rootOf(node) != node) continue;
    // contacts_ is sorted by island, and islands are visited in the same order.
    const auto last = std::find_if(first, contacts_.end(), [&](const WorkContact& c) { return c.island != node; });
    island_ = std::span<WorkContact>(first, last);
    if (node < static_cast<int>(frame.bodies.size()) || !island_.empty()) advanceIsland(node, dt);
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
    const ContactPair& pair = frame_->pairs[i];
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
  const ContactPair& pair = pairOf(c);
  if (pair.found) return pair.contact.depth - dt * dot(pair.contact.normal, relativeVelocity(c));
  const FreeBody& a = *bodyOf(pair.a);
  const Vector3 p_WC = pointAfter(a, a.X_WB * pair.p_BC, frame_->gravity, dt);
  const FreeBody* b = bodyOf(pair.b);
  if (!b) return detectSphere(pair, p_WC, poseOf(pair.b, dt)).depth;
  const Vector3 p_WD = pointAfter(*b, b->X_WB * pair.X_PS.translation, frame_->gravity, dt);
  return sphereAgainstSphere(p_WC, pair.radius, p_WD, pair.shape.half_size.x).depth;
}

/// A depth that appears between two frames was not reached by moving.
void IslandSolver::flagOverlap(const WorkContact& c) {
  KeptContact& kept = keptOf(c);
  if (pairOf(c).contact.depth > max(kept.depth, 0.0) + settings_.overlap_tolerance) kept.overlapped = 1;
}

/// What can be moved by impulses: a free body or a robot that recoils; -1 for all else.
int IslandSolver::nodeOf(const ContactSide& side) const {
  if (side.body >= 0) return side.body;
  const ContactPartner& partner = *partnerOf(side);
  const bool recoils = partner.kind == PartnerKind::kResponsive;
  return recoils ? static_cast<int>(frame_->bodies.size()) + partner.responder : -1;
}
int IslandSolver::rootOf(int node) const {
  while (parents_[index(node)] != node) node = parents_[index(node)];
  return node;
}
void IslandSolver::unite(int a, int b) {
  const auto [first, last] = std::minmax({rootOf(a), rootOf(b)});
  parents_[index(last)] = first;
}

void IslandSolver::findIslands() {
  parents_.resize(frame_->bodies.size() + frame_->responders.size());
  for (std::size_t i = 0; i < parents_.size(); ++i) parents_[i] = static_cast<int>(i);
  for (const WorkContact& c : contacts_) {
    const int a = nodeOf(pairOf(c).a), b = nodeOf(pairOf(c).b);
    if (c.touches && a >= 0 && b >= 0) unite(a, b);
  }
  for (WorkContact& c : contacts_) {
    const int a = nodeOf(pairOf(c).a), b = nodeOf(pairOf(c).b);
    c.island = rootOf(a >= 0 ? a : b);
  }
  // Two sides that do not touch advance apart, each at its own time: their pair waits for a frame in which they do.
  std::erase_if(contacts_, [&](const WorkContact& c) {
    const int b = nodeOf(pairOf(c).b);
    return b >= 0 && rootOf(b) != c.island;
  });
  const auto isBefore = [](const WorkContact& a, const WorkContact& b) {
    return a.island != b.island ? a.island < b.island : a.pair < b.pair;
  };
  // One island alone stands in order already, and a contact's work is large to move.
  if (!std::is_sorted(contacts_.begin(), contacts_.end(), isBefore))
    std::sort(contacts_.begin(), contacts_.end(), isBefore);
}

// ---------------------------------------------------------------------------------------------- island

void IslandSolver::advanceIsland(int island, double dt) {
  askResponses();
  const int substeps = substepsOf(dt);
  const double h = dt / substeps;
  for (int i = 0; i < substeps; ++i) substep(island, h * i, h);
  handOutRecoil(dt);
}

void IslandSolver::askResponses() {
  groups_.clear(), members_.clear();
  for (const WorkContact& c : island_) {
    for (const ContactSide& side : {pairOf(c).a, pairOf(c).b}) {
      const ContactPartner* partner = partnerOf(side);
      const bool recoils = partner != nullptr && partner->kind == PartnerKind::kResponsive;
      if (recoils && partners_[index(side.partner)].group < 0) askResponse(partner->responder);
    }
  }
}

/// One matrix for all bodies of a robot that take part in the island.
void IslandSolver::askResponse(int responder) {
  const Response& response = *frame_->responders[index(responder)];
  const int group = static_cast<int>(groups_.size()), first = static_cast<int>(members_.size());
  asked_.clear();
  for (const WorkContact& c : island_) {
    for (const ContactSide& side : {pairOf(c).a, pairOf(c).b}) {
      const ContactPartner* partner = partnerOf(side);
      if (partner == nullptr || partner->responder != responder) continue;
      WorkPartner& work = partners_[index(side.partner)];
      if (work.group >= 0) continue;
      work.group = group;
      members_.push_back(side.partner);
      asked_.push_back(partner->body);
    }
  }
  places_.resize(asked_.size());
  const ResponseBlocks blocks = response.respond(asked_, places_);
  for (std::size_t i = 0; i < places_.size(); ++i) partners_[index(members_[index(first) + i])].place = places_[i];
  groups_.push_back({responder, first, static_cast<int>(asked_.size()), blocks, response.reference()});
}

/// Free bodies alone ask for them: robots advance by whole frames.
int IslandSolver::substepsOf(double dt) {
  double largest = 0;
  for (WorkContact& c : island_) {
    const ContactPair& pair = pairOf(c);
    if (!c.touches || (pair.a.body < 0 && pair.b.body < 0)) continue;
    place(c, 0);  // once more: now it is known what recoils
    computeResponses(c);
    largest = max(largest, pair.surface.stiffness * pair.share * c.response_n);
  }
  const double wanted = dt * sqrt(largest) / settings_.largest_phase;
  for (int n = 1; n < settings_.most_substeps; ++n)
    if (n >= wanted) return n;
  return settings_.most_substeps;
}

void IslandSolver::handOutRecoil(double dt) {
  for (const int member : members_) {
    ContactPartner& partner = frame_->partners[index(member)];
    partner.recoil = partners_[index(member)].change - partner.drift * dt;
  }
}

}  // namespace murosimf
