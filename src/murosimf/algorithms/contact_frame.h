#pragma once

/// @file What the pair phase needs to know of one frame, and what it hands back: plain data, filled by a module.
///
/// A pair is one point at which two sides may touch in this frame; a side is a free body or a partner, whose motion is
/// not the pair phase's. Spheres of free bodies are looked for anew in every substep; points of other shapes are found
/// once, at the frame's start (`found`), and go on from there with the motion of both sides.
/// Pairs that stay apart cost little and change nothing. A sphere's pair must be listed before it touches: one that
/// appears more than 2 mm deep counts as a teleport.
/// Names are hashName() of the object's full name: order and memory depend on names alone, so adding an object does
/// not change a bit of contacts that it has no part in.

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/algorithms/shape.h"
#include "murosimf/algorithms/sphere_contact.h"
#include "murosimf/algorithms/surface_pair.h"
#include "murosimf/math/spatial.h"

namespace murosimf {

/// Identity of a contact from frame to frame. A and B: either, but always the same ones.
struct ContactKey {
  std::uint64_t name_a = 0, name_b = 0;
  std::uint16_t shape_a = 0, shape_b = 0;  ///< number of the shape on its body
  std::uint32_t feature = 0;               ///< number of the point of a manifold; 0 for spheres
  friend auto operator<=>(const ContactKey&, const ContactKey&) = default;
};

/// A rigid body moved by the pair phase itself. Body frame B: origin at the centre of mass, principal axes.
struct FreeBody {
  double mass = 1;            ///< [kg] > 0
  Vector3 inertia{1, 1, 1};   ///< principal moments about the centre of mass [kg m^2] > 0
  Pose X_WB;                  ///< state
  Vector3 velocity;           ///< v_WB_W of the centre of mass [m/s]; state
  Vector3 angular_velocity;   ///< w_WB_W [rad/s]; state
  Vector3 force_W, torque_W;  ///< held over the frame, gravity not included [N], [N m]
};

enum class PartnerKind : std::uint8_t {
  kStatic,      ///< never moves: ground, wall, post
  kPrescribed,  ///< moves on a given path whatever it meets: a body of a kinematic robot
  kResponsive,  ///< recoils: a body of a robot with dynamics
};

/// A body that is not free. In the frame it moves straight and turns evenly from X_start to X_end; a responsive one
/// goes on with `motion`, recoils besides, and drifts as what else pushes it changes its velocity.
struct ContactPartner {
  PartnerKind kind = PartnerKind::kStatic;
  Pose X_start, X_end;  ///< kPrescribed: pose in the world at the frame's start and end; after a teleport both are the
                        ///< new pose. Others: X_start alone
  SpatialMotion<double> motion;  ///< kResponsive: at the start, of its origin, world axes
  double mass = 0;               ///< of the whole robot [kg]; caps the force that prescribed motion gives and gets
  int responder = -1;            ///< kResponsive: index of its robot in FrameContacts::responders
  int body = 0;                  ///< kResponsive: the robot's own number of this body
  SpatialMotion<double> drift;   ///< kResponsive: acceleration by all but the pairs, about the responder's reference
  Vector3 impulse;               ///< out: on the partner, sum over the frame [N s]; / dt is the wrench to hold
  Vector3 angular_impulse;       ///< out: about X_start.translation [N m s]
  SpatialMotion<double> recoil;  ///< out, kResponsive: change of motion by the impulses, about the same reference
};

struct ContactSide {
  int body = -1;     ///< in FrameContacts::bodies; -1: a partner
  int partner = -1;  ///< in FrameContacts::partners; -1: a free body
};

struct ContactPair {
  ContactKey key;
  ContactSide a, b;  ///< the normal points from B to A; not both static or prescribed
  SurfacePair surface;
  bool found = false;  ///< `contact` has been found at the frame's start; otherwise A is a free body's sphere:
  Vector3 p_BC;        ///< its centre on A [m]
  double radius = 0;   ///< of the sphere; of other shapes how deep they may be pushed in: half their thickness [m]
  double rolling_radius = 0;         ///< of the shape that rolls [m]; 0: `radius`
  bool plane = false;                ///< B is the half-space below z = 0 of X_PS; otherwise `shape`
  Shape shape;                       ///< B's shape; of another free body a sphere
  const ConvexHull* hull = nullptr;  ///< of a kConvex shape
  Pose X_PS;                         ///< its place on B
  double share = 1;                  ///< of the surfaces' stiffness that this point carries: 1/n of n points
  SphereContact contact;             ///< in where `found`; out: at the start of the last substep
  Vector3 impulse;                   ///< out: on A, sum over the frame [N s]
  Vector3 moment_A, moment_B;        ///< out: on a partner, about its X_start.translation, sum over the frame [N m s]
  bool touched = false;              ///< out: an impulse passed in this frame
  bool fresh = false;                ///< out: no point of this key was kept from the last frame
};

/// How a body answers the impulses on a body of the same robot: row[b][a] is the change of component a of its motion
/// (w; v) by a unit of component b of the impulse (moment; force). Rows are as wide as whole registers.
struct ResponseBlock {
  alignas(32) double row[6][8] = {};
};

/// n x n blocks of n bodies of one robot.
struct ResponseBlocks {
  const ResponseBlock* blocks = nullptr;
  int count = 0;  ///< n
  /// How the body at place i answers impulses on the one at place j.
  const ResponseBlock& at(int i, int j) const { return blocks[i * count + j]; }
};

/// How a robot's own step answers impulses: H^-1 of its motion algorithm (rigid, articulated with servos), as the
/// changes of its bodies' motion. It must not promise more mass than the robot then shows.
/// Everything of a robot is in world axes, about one point of reference: motion (w; v), impulse (moment; force).
class Response {
 public:
  explicit Response(const Vector3& p_WO = {}) : p_WO_(p_WO) {}
  Response(const Response&) = delete;
  Response& operator=(const Response&) = delete;
  virtual ~Response() = default;
  const Vector3& reference() const { return p_WO_; }
  void setReference(const Vector3& p_WO) { p_WO_ = p_WO; }
  /// Blocks of these bodies at least, valid until the next call. Overwrites their `places` among the blocks. As one
  /// matrix symmetric, positive semidefinite.
  virtual ResponseBlocks respond(std::span<const int> bodies, std::span<int> places) const = 0;

 private:
  Vector3 p_WO_;
};

struct FrameContacts {
  Vector3 gravity{0, 0, -9.81};  ///< [m/s^2]
  std::vector<FreeBody> bodies;
  std::vector<ContactPartner> partners;
  std::vector<ContactPair> pairs;  ///< any order; advance() sorts them by key
  std::vector<const Response*> responders;
};

/// What is remembered of a contact from frame to frame: state, saved in checkpoints and hashes; no padding.
struct KeptContact {
  ContactKey key;
  double normal_force = 0;       ///< of the last substep [N]
  Vector3 friction_force;        ///< on A [N]
  Vector3 turning_torque;        ///< on A [N m]
  Vector3 normal;                ///< from B to A
  double approach_speed = 0;     ///< v_in: largest since the contact began [m/s]
  double depth = 0;              ///< at the frame's end [m]
  std::uint64_t overlapped = 0;  ///< 1: began as an overlap (a teleport), so it separates slowly
  friend bool operator==(const KeptContact&, const KeptContact&) = default;
};
inline KeptContact freshContact(const ContactKey& key) {
  KeptContact contact;
  contact.key = key;
  return contact;
}

}  // namespace murosimf
