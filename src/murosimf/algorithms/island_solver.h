#pragma once

/// @file Substeps of free bodies that touch one another, directly or through a robot that recoils: an island.
///
/// Used by PairSolver alone; pair_solver.h tells the method. A contact's response: W n = M_A n + M_B n,
/// M = E/m - [r]x I^-1 [r]x for a free body, 0 for what moves by prescription, the robot's own matrix for what recoils.

#include "murosimf/algorithms/contact_law.h"
#include "murosimf/algorithms/free_body_motion.h"
#include "murosimf/algorithms/pair_solver.h"

namespace murosimf {

/// Velocity of a partner on its path: straight, evenly turning.
struct PartnerPath {
  Vector3 velocity, angular_velocity;  ///< of its origin; world axes
  Pose at(const ContactPartner& partner, double t) const;
};
PartnerPath pathOf(const ContactPartner& partner, double dt);

/// Sphere A of a pair, its centre at p_WC, against B at the pose X_WP of its body.
SphereContact detectSphere(const SpherePair& pair, const Vector3& p_WC, const Pose& X_WP);

/// Work of one pair in this frame.
struct WorkContact {
  int pair = 0;            ///< index in FrameContacts::pairs, and of its KeptContact
  int island = 0;          ///< representative of the group that advances together
  bool active = false;     ///< near enough to touch in this substep
  bool touches = false;    ///< touches at the frame's start or would at its end
  Vector3 arm_a, arm_b;    ///< from the centres of mass (partner: from its origin) to the point
  Vector3 velocity_b;      ///< of a partner's point without recoil
  double start_speed = 0;  ///< u_0
  double response_n = 0, response_t = 0, response_w = 0;  ///< W along n, largest across n, of turning
  double p_n = 0;                                         ///< impulses of this substep, on A
  Vector3 p_t, p_w;
  Vector3 recoil, recoil_start, recoil_shift;  ///< a responsive partner's point since the frame's start: velocity,
                                               ///< velocity at the substep's start, displacement
  int matrix = 0, row = 0, rows = 0;           ///< where its robot's matrix begins; its block row there, of so many
};

class IslandSolver {
 public:
  explicit IslandSolver(const PairSolver::Settings& settings) : settings_(settings) {}

  void reserve(std::size_t bodies, std::size_t pairs);
  /// @param kept one per pair of the frame, in the same order; read as last frame's, written as this frame's
  void advance(FrameContacts& frame, std::span<KeptContact> kept, double dt);

 private:
  // Once per frame.
  void findContacts(double dt);
  double depthAfter(const WorkContact& c, double dt) const;
  void findIslands();
  int rootOf(int node);
  void unite(int a, int b);
  void flagOverlap(const WorkContact& c);

  // Once per island and frame.
  void advanceIsland(int island, double dt);
  void askResponses();
  void askResponse(int first);
  int substepsOf(double dt) const;

  // Per substep, in island_substep.cpp; contacts are those of island_.
  void substep(int island, double t, double h);
  void place(WorkContact& c, double t) const;
  void prepare(WorkContact& c, double h);
  void computeResponses(WorkContact& c) const;
  void warmStart(WorkContact& c, double h);
  void relax(WorkContact& c, double h);
  double limited(const WorkContact& c, double impulse, const NormalStep& step) const;
  void book(WorkContact& c, double h);

  SpherePair& pairOf(const WorkContact& c) const { return frame_->pairs[static_cast<std::size_t>(c.pair)]; }
  KeptContact& keptOf(const WorkContact& c) const { return kept_[static_cast<std::size_t>(c.pair)]; }
  FreeBody& bodyA(const WorkContact& c) const { return frame_->bodies[static_cast<std::size_t>(pairOf(c).body)]; }
  FreeBody* bodyB(const WorkContact& c) const;
  const ContactPartner* partnerOf(const WorkContact& c) const;
  Vector3 relativeVelocity(const WorkContact& c) const;
  Vector3 relativeTurning(const WorkContact& c) const;
  Vector3 responseTo(const WorkContact& c, const Vector3& impulse) const;
  Vector3 recoilOf(const WorkContact& c, const WorkContact& source, const Vector3& impulse) const;
  void give(const WorkContact& c, const Vector3& impulse);
  void giveTurning(const WorkContact& c, const Vector3& angular_impulse);

  PairSolver::Settings settings_;
  FrameContacts* frame_ = nullptr;  // of the call of advance()
  std::span<KeptContact> kept_;
  std::span<WorkContact> island_;
  std::vector<PartnerPath> paths_;
  std::vector<WorkContact> contacts_;
  std::vector<MotionStart> starts_;  // per body
  std::vector<int> parents_;         // union-find over bodies, then responders
  std::vector<ResponsePoint> points_;
  std::vector<double> responses_;  // 3n x 3n of every group of the island, one after another
};

}  // namespace murosimf
