#pragma once

/// @file What the pair phase needs to know of one frame, and what it hands back: plain data, filled by a module.
///
/// Free bodies carry spheres. A pair says: this sphere of that free body may touch this shape of a partner (or a
/// sphere of another free body) in this frame. Pairs that stay apart cost little and change nothing; a pair must be
/// listed before it touches, because one that appears more than 2 mm deep counts as a teleport.
/// Names are hashName() of the object's full name: order and memory depend on names alone, so adding an object does
/// not change a bit of contacts that it has no part in.

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/algorithms/shape.h"
#include "murosimf/algorithms/sphere_contact.h"
#include "murosimf/algorithms/surface_pair.h"

namespace murosimf {

/// Identity of a contact from frame to frame. A: the free body (of two, either, but always the same one).
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

/// A body that is not free. In the frame it moves straight and turns evenly from X_start to X_end.
struct ContactPartner {
  PartnerKind kind = PartnerKind::kStatic;
  Pose X_start, X_end;      ///< pose in the world at the frame's start and end; a responsive one's: without the pairs'
                            ///< impulses of this frame. After a teleport both are the new pose. kStatic: X_start
  double pusher_mass = 0;   ///< kPrescribed: mass of the whole robot [kg]; caps the force that it gives
  int responder = -1;       ///< kResponsive: index of its robot in FrameContacts::responders
  int body = 0;             ///< kResponsive: the robot's own number of this body
  Vector3 impulse;          ///< out: on the partner, sum over the frame [N s]; / dt is the wrench to hold
  Vector3 angular_impulse;  ///< out: about X_start.translation [N m s]
};

struct SpherePair {
  ContactKey key;
  int body = 0;         ///< A in FrameContacts::bodies
  Vector3 p_BC;         ///< centre of A's sphere on its body [m]
  double radius = 0;    ///< of A's sphere [m]
  int partner = -1;     ///< B in FrameContacts::partners; -1: B is other_body
  bool plane = false;   ///< B is the half-space below z = 0 of X_PS; otherwise `shape`
  Shape shape;          ///< B's shape
  Pose X_PS;            ///< its place on the partner; of another free body: translation is the sphere's centre,
  int other_body = -1;  ///<   shape.half_size.x its radius
  SurfacePair surface;
  SphereContact contact;  ///< out: as detected last in this frame
  Vector3 impulse;        ///< out: on A, sum over the frame [N s]
  Vector3 moment_B;       ///< out: on B, about its X_start.translation, sum over the frame [N m s]
  bool touched = false;   ///< out: an impulse passed in this frame
};

/// A contact point on a body of a robot, world axes.
struct ResponsePoint {
  int body = 0;
  Vector3 p_W;
};

/// How a robot's own step answers impulses: J H^-1 J^T. H^-1 is that of its motion algorithm (rigid, articulated with
/// servos); it must not promise more mass than the robot then shows.
class Response {
 public:
  Response() = default;
  Response(const Response&) = delete;
  Response& operator=(const Response&) = delete;
  virtual ~Response() = default;
  /// For n points writes the 3n x 3n matrix M, row by row: velocity change of point i along axis a per impulse on
  /// point j along axis b stands at M[(3 i + a) 3 n + 3 j + b] [1/kg]. Symmetric, positive semidefinite.
  virtual void respond(std::span<const ResponsePoint> points, std::span<double> matrix) const = 0;
};

struct FrameContacts {
  Vector3 gravity{0, 0, -9.81};  ///< [m/s^2]
  std::vector<FreeBody> bodies;
  std::vector<ContactPartner> partners;
  std::vector<SpherePair> pairs;  ///< any order; advance() sorts them by key
  std::vector<const Response*> responders;
};

/// What is remembered of a contact from frame to frame: state, saved in checkpoints and hashes; no padding.
struct KeptContact {
  ContactKey key;
  double normal_force = 0;       ///< of the last substep [N]
  Vector3 friction_force;        ///< on A [N]
  Vector3 turning_torque;        ///< on A [N m]
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
