#include "algorithms/collision/pair_checks.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace murosimf::collision_test {
namespace {

constexpr double kExact = 1e-9;        // [m], closed forms
constexpr double kIterative = 2.2e-6;  // [m]: 2e-7 + 2e-4 depth at most, see least_depth.h
constexpr double kPlaced = 2e-5, kPlacedIterative = 1e-4, kPerDepth = 0.03;  // [m], [m], of the depth

ContactManifold detect(const Pair& pair) {
  ContactManifold out;
  detectContact(pair.a, pair.X_WA, pair.b, pair.X_WB, out);
  return out;
}

bool sameButTurned(const ContactManifold& l, const ContactManifold& r) {
  if (l.count != r.count) return false;
  if (l.count > 0 && !(l.normal == -r.normal)) return false;
  for (int i = 0; i < l.count; ++i)
    if (!(l.points[i].position == r.points[i].position) || l.points[i].depth != r.points[i].depth ||
        l.points[i].feature != r.points[i].feature)
      return false;
  return true;
}

class PairCheck {
 public:
  PairCheck(CollisionKind a, CollisionKind b)
      : dice_(1 + static_cast<std::uint64_t>(a) * 8 + static_cast<std::uint64_t>(b)), a_(a), b_(b) {}

  void run(PairReport& r, bool with_sweep) {
    report_ = &r;
    pair_ = randomPair(a_, b_, dice_);
    ++r.poses;
    const ContactManifold found = detect(pair_);
    countIf(sameButTurned(detect({pair_.b, pair_.a, pair_.X_WB, pair_.X_WA}), found), r.unequal);
    if (with_sweep) compareWithSweep(found);
    if (found.count == 0) return;
    ++r.touching;
    const double depth = deepest(found).depth;
    countIf(abs(overlapAlong(pair_, found.normal) - depth) <= kExact, r.inexact);
    checkMoved(found, depth);
  }

 private:
  double tolerance() const { return isClosedForm(a_, b_) ? kExact : kIterative; }
  void countIf(bool holds, int& count) {
    if (holds) return;
    ++count;
    if (report_->first.size() < 60) report_->first += " " + std::to_string(report_->poses - 1);
  }
  void compareWithSweep(const ContactManifold& found) {
    const Sweep sweep = sweepDirections(pair_, dice_);
    if (found.count == 0) return countIf(sweep.depth < 1e-6, report_->unseen);
    ++report_->swept;
    checkPoints(found);
    const double depth = deepest(found).depth;
    countIf(sweep.depth > -kExact, report_->phantom);
    report_->worst = max(report_->worst, depth - sweep.depth);
    countIf(depth <= sweep.depth + max(1e-5, 0.01 * sweep.depth), report_->too_deep);
    if (!sweep.unique) return;
    ++report_->unique;
    countIf(dot(found.normal, sweep.normal) >= 0.99985, report_->other_normal);  // cosine of 1 degree
  }
  /// Half the depth ahead of a point along the normal B ends, half of it behind A does.
  void checkPoints(const ContactManifold& found) {
    const double placed = isClosedForm(a_, b_) ? kPlaced : kPlacedIterative + kPerDepth * deepest(found).depth;
    bool on_both = true;
    for (int i = 0; i < found.count; ++i) {
      const Vector3 half = found.normal * (0.5 * found.points[i].depth), &p = found.points[i].position;
      on_both = on_both && distanceOutside(pair_.a, pair_.X_WA, p - half) < placed;
      on_both = on_both && distanceOutside(pair_.b, pair_.X_WB, p + half) < placed;
    }
    countIf(on_both, report_->astray);
  }
  void checkMoved(const ContactManifold& found, double depth) {
    Pair apart = pair_;
    apart.X_WA.translation += found.normal * (depth * (1 + 1e-6) + kExact);
    const ContactManifold after = detect(apart);
    countIf(after.count == 0 || deepest(after).depth < tolerance(), report_->inside);
    const Pose X = dice_.pose();
    const Pair moved{pair_.a, pair_.b, X * pair_.X_WA, X * pair_.X_WB};
    const ContactManifold there = detect(moved);
    const double depth_there = there.count > 0 ? deepest(there).depth : 0.0;
    countIf(abs(depth_there - depth) <= tolerance(), report_->moving);
    // Where several normals and points are equally good, rounding may choose another.
    if (there.count == 0 || pair_.aligned || !isClosedForm(a_, b_)) return;
    const bool same_normal = norm(X.rotation * found.normal - there.normal) < kExact;
    bool same_points = found.count == there.count;
    for (int i = 0; same_points && i < found.count; ++i)
      same_points = norm(X * found.points[i].position - there.points[i].position) < kExact;
    countIf(same_normal && same_points, report_->moving);
  }

  Dice dice_;
  CollisionKind a_, b_;
  Pair pair_;
  PairReport* report_ = nullptr;
};

double percent(int part, int whole) { return whole > 0 ? 100.0 * part / whole : 0.0; }

}  // namespace

PairReport checkPair(CollisionKind a, CollisionKind b, int poses, int sweep_every) {
  PairReport report;
  PairCheck check(a, b);
  for (int i = 0; i < poses; ++i) check.run(report, i % sweep_every == 0);
  return report;
}

std::string describe(CollisionKind a, CollisionKind b, const PairReport& r) {
  char text[600];
  std::snprintf(
      text, sizeof(text),
      "%-9s %-9s: %d poses, %d touch; unseen %d, phantom %d, unequal %d, moving %d, inside %d, inexact %d, astray %d; "
      "too deep %d (%.3f %%), worst %.1e m; other normal %d of %d (%.3f %%)%s",
      nameOf(a).c_str(), nameOf(b).c_str(), r.poses, r.touching, r.unseen, r.phantom, r.unequal, r.moving, r.inside,
      r.inexact, r.astray, r.too_deep, percent(r.too_deep, r.swept), r.worst, r.other_normal, r.unique,
      percent(r.other_normal, r.unique), r.first.empty() ? "" : ("; first:" + r.first).c_str());
  return text;
}

void expectPairToHold(CollisionKind a, CollisionKind b, int poses, int sweep_every) {
  const PairReport r = checkPair(a, b, poses, sweep_every);
  const std::string text = describe(a, b, r);
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
  EXPECT_GT(r.touching, poses / 2) << text;
  for (const int count : {r.unseen, r.phantom, r.unequal, r.moving, r.inside, r.inexact}) EXPECT_EQ(count, 0) << text;
  const auto few = [](int poses_swept) { return max(1.0, 1e-3 * poses_swept); };
  EXPECT_LE(r.astray, few(r.swept)) << text;
  EXPECT_LE(r.too_deep, few(r.swept)) << text;
  EXPECT_LE(r.other_normal, few(r.unique)) << text;
}

}  // namespace murosimf::collision_test
