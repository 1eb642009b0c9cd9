#pragma once

/// @file Response of a tree of bodies with a floating base to impulses: articulated bodies [Featherstone 2008, 7.3].
///
/// Everything in world axes, about the base's origin O; S_j motion of joint j, (a; p_j x a) of a revolute and (0; a) of
/// a prismatic one, d_j the rotor's inertia at the joint. From the leaves to the base:
///     U = I^A S,   D = S^T U + d,   I^A_parent += I^A - U U^T / D
/// An impulse f on body k goes inwards, p_k = -f:  u = -S^T p,  p_parent += p + U u / D; the base moves by
/// -(I^A_0)^-1 p_0, and outwards  ddq = (u - U^T a_parent) / D,  a = a_parent + S ddq.
/// Grounds do not hold it and servos are as soft as they can be: it promises no more mass than the robot shows.
/// Cost: about 130 operations a body and 90 in registers of four a joint; for each body that is asked for 50 a joint on
/// the ways to all of them, in registers too.

#include <array>

#include "murosimf/algorithms/contact_frame.h"
#include "murosimf/algorithms/tree_table.h"

namespace murosimf {

class TreeResponse {
 public:
  /// What stays the same; must live longer.
  struct Constants {
    TreeTable tree;
    std::vector<RigidInertia<double>> inertia;  ///< of the bodies, in their own axes about their origins
    std::vector<double> armature;               ///< of the joints
  };
  /// A robot at its present place. Call place() before respond().
  explicit TreeResponse(const Constants& constants);
  /// @param X_WB of all bodies; @param joints_yield false: joints are held, and the tree answers as one body
  void place(std::span<const Pose> X_WB, bool joints_yield);
  /// For n bodies writes n x n blocks: how body i answers impulses on body j stands at blocks[n i + j].
  void respond(std::span<const int> bodies, std::span<ResponseBlock> blocks) const;

 private:
  /// Six numbers, as wide as whole registers: motion (w; v), force (n; f), or one component under six impulses.
  struct alignas(32) Columns {
    double of[8] = {};
  };
  using SixColumns = std::array<Columns, 6>;
  struct Joint {
    Columns S, U;
    double over_D = 0;
  };
  static void addScaled(Columns& a, const Columns& b, double s) {
    for (std::size_t k = 0; k < 8; ++k) a.of[k] += b.of[k] * s;
  }
  static SixColumns inertiaAbout(const RigidInertia<double>& body, const Rotation3& R, const Vector3& p);
  static SixColumns inverseOf(const SixColumns& matrix);
  void gatherInward(bool joints_yield);
  void findWays(std::span<const int> bodies) const;
  void respondTo(int body) const;

  const Constants& constants_;
  Vector3 p_WO_;
  std::vector<Joint> joints_;            // of each row; the base's stays empty
  std::vector<SixColumns> articulated_;  // I^A of each row
  SixColumns base_inverse_{};
  // Work of respond().
  mutable std::vector<int> ways_;           // rows from the base to the bodies that are asked for, without the base
  mutable std::vector<Columns> u_;          // per row
  mutable std::vector<SixColumns> motion_;  // per row
  mutable std::vector<char> on_way_;
};

}  // namespace murosimf
