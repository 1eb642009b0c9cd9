#pragma once

/// @file Substeps of sides that touch one another, directly or through a robot that recoils: an island.
///
/// Used by PairSolver alone; pair_solver.h tells the method. A contact's response is the change K p of the relative
/// velocity at its point by the impulse p there, of both sides: E/m - [r]x I^-1 [r]x for a free body, 0 for what moves
/// by prescription, that of the robot's own matrix for what recoils.

#include "murosimf/algorithms/contact_law.h"
#include "murosimf/algorithms/free_body_motion.h"
#include "murosimf/algorithms/pair_solver.h"
#include "murosimf/algorithms/partner_path.h"

namespace murosimf {

/// Sphere A of a pair, its centre at p_WC, against B at the pose X_WB of its body.
SphereContact detectSphere(const ContactPair& pair, const Vector3& p_WC, const Pose& X_WB);

/// A partner in this frame.
struct WorkPartner {
  PartnerPath path;
  int group = -1;  ///< of what recoils; -1: it does not
  int place = 0;   ///< among the blocks of its group
  // By impulses and drift, about the group's reference:
  SpatialMotion<double> change, start;  ///< of its motion since the frame's start, and at the substep's start
  SpatialMotion<double> shift;          ///< displacement since the frame's start
};

/// Bodies of one robot that recoil together.
struct RecoilGroup {
  int responder = 0;
  int first = 0, count = 0;  ///< its partners among members_
  ResponseBlocks blocks;
  Vector3 p_WO;  ///< reference
};

/// One side of a contact.
struct WorkSide {
  Vector3 arm;            ///< from the centre of mass (partner: from its origin) to the point
  Vector3 lever;          ///< from the reference of what recoils to the point
  Vector3 path_velocity;  ///< of a partner's point without recoil
};

/// Work of one pair in this frame.
struct WorkContact {
  int pair = 0;          ///< index in FrameContacts::pairs, and of its KeptContact
  int island = 0;        ///< representative of the group that advances together
  bool active = false;   ///< near enough to touch in this substep
  bool touches = false;  ///< touches at the frame's start or would at its end
  WorkSide a, b;
  Rotation3 response;                                     ///< K, by columns
  double start_speed = 0;                                 ///< u_0
  double response_n = 0, response_t = 0, response_w = 0;  ///< W along n, largest across n, of turning
  double late = 0;                                        ///< normal impulse that the last frame owed
  double p_n = 0;                                         ///< impulses of this substep, on A
  Vector3 p_t, p_w;
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
  int nodeOf(const ContactSide& side) const;
  int rootOf(int node) const;
  void unite(int a, int b);
  void flagOverlap(const WorkContact& c);

  // Once per island and frame.
  void advanceIsland(int island, double dt);
  void askResponses();
  void askResponse(int responder);
  int substepsOf(double dt);
  void handOutRecoil(double dt);

  // Per substep, in island_substep.cpp; contacts are those of island_.
  void substep(int island, double t, double h);
  void place(WorkContact& c, double t) const;
  void placeSide(const ContactSide& side, const Vector3& point, const Vector3& origin, WorkSide& work) const;
  void prepare(WorkContact& c, double h);
  void computeResponses(WorkContact& c) const;
  void giveLateImpulses(double h);
  void warmStart(WorkContact& c, double h);
  double relax(WorkContact& c, double h);
  double limited(const WorkContact& c, double impulse, const NormalStep& step) const;
  void book(WorkContact& c, double h);

  // Sides, in island_sides.cpp.
  ContactPair& pairOf(const WorkContact& c) const { return frame_->pairs[static_cast<std::size_t>(c.pair)]; }
  KeptContact& keptOf(const WorkContact& c) const { return kept_[static_cast<std::size_t>(c.pair)]; }
  FreeBody* bodyOf(const ContactSide& side) const;
  const ContactPartner* partnerOf(const ContactSide& side) const;
  bool isPrescribed(const ContactSide& side) const;
  double massOf(const ContactSide& side) const;
  Pose poseOf(const ContactSide& side, double t) const;
  Vector3 startOf(const ContactSide& side) const;
  Vector3 velocityOf(const ContactSide& side, const WorkSide& work) const;
  Vector3 turningOf(const ContactSide& side) const;
  Vector3 relativeVelocity(const WorkContact& c) const;
  Vector3 responseOf(const ContactSide& side, const WorkSide& work, const Vector3& impulse) const;
  Vector3 crossResponse(const WorkContact& c, const Vector3& impulse) const;
  double turningResponse(const ContactSide& side) const;
  SpatialMotion<double> recoilOf(const WorkPartner& moved, const WorkPartner& pushed,
                                 const SpatialForce<double>& impulse) const;
  void give(const WorkContact& c, const Vector3& impulse, const Vector3& angular_impulse);
  void giveTo(const ContactSide& side, const WorkSide& work, const Vector3& impulse, const Vector3& angular_impulse);

  PairSolver::Settings settings_;
  FrameContacts* frame_ = nullptr;  // of the call of advance()
  std::span<KeptContact> kept_;
  std::span<WorkContact> island_;
  std::vector<WorkPartner> partners_;
  std::vector<WorkContact> contacts_;
  std::vector<MotionStart> starts_;  // per body
  std::vector<int> parents_;         // union-find over bodies, then responders
  std::vector<RecoilGroup> groups_;  // of the island
  std::vector<int> members_, asked_, places_;
};

}  // namespace murosimf
