#include "murosimf/algorithms/tree_response.h"

#include <algorithm>
#include <cmath>

namespace murosimf {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

/// A rigid body's inertia, turned into world axes and referred to the point from which its origin lies at p.
TreeResponse::SixColumns TreeResponse::inertiaAbout(const RigidInertia<double>& body, const Rotation3& R,
                                                    const Vector3& p) {
  const RigidInertia<double> about = shifted(RigidInertia<double>{body.m, R * body.mc, turned(R, body.I)}, p);
  const double m = about.m;
  const Vector3& c = about.mc;
  const Symmetric3<double>& I = about.I;
  return {{{{I.xx, I.xy, I.xz, 0, -c.z, c.y}},
           {{I.xy, I.yy, I.yz, c.z, 0, -c.x}},
           {{I.xz, I.yz, I.zz, -c.y, c.x, 0}},
           {{0, c.z, -c.y, m, 0, 0}},
           {{-c.z, 0, c.x, 0, m, 0}},
           {{c.y, -c.x, 0, 0, 0, m}}}};
}

/// Of a symmetric positive definite matrix, by its Cholesky factor.
TreeResponse::SixColumns TreeResponse::inverseOf(const SixColumns& matrix) {
  double a[6][6];
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = matrix[i].of[j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      a[i][j] = i == j ? std::sqrt(sum) : sum / a[j][j];
    }
  }
  // All columns of the unit matrix at once.
  SixColumns x{};
  for (std::size_t i = 0; i < 6; ++i) {
    x[i].of[i] = 1;
    for (std::size_t k = 0; k < i; ++k) addScaled(x[i], x[k], -a[i][k]);
    for (double& number : x[i].of) number /= a[i][i];
  }
  for (std::size_t i = 6; i-- > 0;) {
    for (std::size_t k = i + 1; k < 6; ++k) addScaled(x[i], x[k], -a[k][i]);
    for (double& number : x[i].of) number /= a[i][i];
  }
  return x;
}

TreeResponse::TreeResponse(const Constants& constants)
    : constants_(constants),
      joints_(constants.tree.rows.size()),
      articulated_(joints_.size()),
      u_(joints_.size()),
      motion_(joints_.size()),
      on_way_(joints_.size()) {
  ways_.reserve(joints_.size());
}

void TreeResponse::place(std::span<const Pose> X_WB, bool joints_yield) {
  p_WO_ = X_WB[0].translation;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Vector3 p = X_WB[i].translation - p_WO_;
    articulated_[i] = inertiaAbout(constants_.inertia[i], X_WB[i].rotation, p);
    const TreeRow& row = constants_.tree.rows[i];
    const Rotation3& R = X_WB[i].rotation;
    const Vector3 axis = row.axis == 0 ? R.x : row.axis == 1 ? R.y : R.z;
    const Vector3 w = row.kind == JointKind::kRevolute ? axis : Vector3{};
    const Vector3 v = row.kind == JointKind::kRevolute ? cross(p, axis) : axis;
    joints_[i].S = {{w.x, w.y, w.z, v.x, v.y, v.z}};
  }
  gatherInward(joints_yield);
}

void TreeResponse::gatherInward(bool joints_yield) {
  for (std::size_t i = joints_.size(); i-- > 1;) {
    Joint& joint = joints_[i];
    const SixColumns& I = articulated_[i];
    joint.U = {};
    for (std::size_t r = 0; r < 6; ++r) addScaled(joint.U, I[r], joint.S.of[r]);  // I is symmetric
    double D = constants_.armature[i - 1];
    for (std::size_t r = 0; r < 6; ++r) D += joint.S.of[r] * joint.U.of[r];
    joint.over_D = joints_yield ? 1 / D : 0;
    SixColumns& parent = articulated_[index(constants_.tree.rows[i].parent)];
    for (std::size_t r = 0; r < 6; ++r) {
      addScaled(parent[r], I[r], 1);
      addScaled(parent[r], joint.U, -joint.U.of[r] * joint.over_D);
    }
  }
  base_inverse_ = inverseOf(articulated_[0]);
}

/// Rows in ascending order: parents come before their children.
void TreeResponse::findWays(std::span<const int> bodies) const {
  std::fill(on_way_.begin(), on_way_.end(), char{0});
  for (const int body : bodies) {
    for (std::size_t i = index(body); i > 0; i = index(constants_.tree.rows[i].parent)) on_way_[i] = 1;
  }
  ways_.clear();
  for (std::size_t i = 1; i < on_way_.size(); ++i) {
    if (on_way_[i] != 0) ways_.push_back(static_cast<int>(i));
  }
}

/// Fills motion_ on the ways with the answers to the six unit impulses on one body.
void TreeResponse::respondTo(int body) const {
  for (const int row : ways_) u_[index(row)] = {};
  SixColumns inward{};  // -p
  for (std::size_t r = 0; r < 6; ++r) inward[r].of[r] = 1;
  for (std::size_t i = index(body); i > 0; i = index(constants_.tree.rows[i].parent)) {
    const Joint& joint = joints_[i];
    for (std::size_t r = 0; r < 6; ++r) addScaled(u_[i], inward[r], joint.S.of[r]);
    for (std::size_t r = 0; r < 6; ++r) addScaled(inward[r], u_[i], -joint.U.of[r] * joint.over_D);
  }
  motion_[0] = {};
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t s = 0; s < 6; ++s) addScaled(motion_[0][r], inward[s], base_inverse_[r].of[s]);
  }
  for (const int row : ways_) {
    const std::size_t i = index(row);
    const Joint& joint = joints_[i];
    motion_[i] = motion_[index(constants_.tree.rows[i].parent)];
    Columns ddq{};
    addScaled(ddq, u_[i], joint.over_D);
    for (std::size_t r = 0; r < 6; ++r) addScaled(ddq, motion_[i][r], -joint.U.of[r] * joint.over_D);
    for (std::size_t r = 0; r < 6; ++r) addScaled(motion_[i][r], ddq, joint.S.of[r]);
  }
}

/// What i answers to j is, turned about, what j answers to i.
void TreeResponse::respond(std::span<const int> bodies, std::span<ResponseBlock> blocks) const {
  findWays(bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    respondTo(bodies[i]);
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      const SixColumns& motion = motion_[index(bodies[j])];
      ResponseBlock& block = blocks[i * bodies.size() + j];
      for (std::size_t r = 0; r < 6; ++r) std::copy_n(motion[r].of, 8, block.row[r]);
    }
  }
}

}  // namespace murosimf
