#pragma once

/// @file Which objects may touch one another, and how, where it is not as their surfaces say.
///
/// Rules speak of pairs of bodies; the later one holds over the earlier, item by item. Without any, bodies of different
/// objects touch as the table of surfaces says, with up to four points, and bodies of one robot do not touch.
/// A body is meant by its path, or by that of any object above it: "robots.red" means all bodies of all red robots.
/// Names may hold the signs * ? [...] of file names in a shell: "robots.*.*.left_*". The ground is the object "ground".

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/world/diagnostics.h"
#include "murosimf/world/surface_table.h"

namespace murosimf {

inline constexpr std::string_view kGroundPath = "ground";

/// Whether a pattern means the object with this path.
bool patternMeans(std::string_view pattern, std::string_view path);

/// Objects, named by patterns.
struct ObjectSet {
  std::vector<std::string> patterns;
  bool contains(std::string_view path) const;
  friend bool operator==(const ObjectSet&, const ObjectSet&) = default;
};

/// Constants of a pair of surfaces that are to be others.
struct SurfaceChange {
  std::optional<NormalLaw> normal_law;
  std::optional<FrictionLaw> friction_law;
  std::optional<double> stiffness, restitution_factor, blend_speed, dissipation, friction, stick_speed,
      viscous_friction, turning_friction, rolling_resistance;
  void applyTo(SurfacePair& pair) const;
  friend bool operator==(const SurfaceChange&, const SurfaceChange&) = default;
};

struct ContactRule {
  enum class Pairs {
    kBetween,  ///< one body of `a`, one of `b`, not of the same robot
    kWithin,   ///< both of `a`, not of the same robot
    kSelf,     ///< both of `a`, of the same robot
  };
  Pairs pairs = Pairs::kBetween;
  ObjectSet a, b;
  std::optional<bool> check;      ///< whether they touch at all
  std::optional<bool> one_point;  ///< the deepest point alone stands for the contact
  SurfaceChange surface;
  friend bool operator==(const ContactRule&, const ContactRule&) = default;
};

/// What holds for one pair of bodies.
struct ContactTerms {
  bool check = true;
  bool one_point = false;
  SurfacePair surface;
  friend bool operator==(const ContactTerms&, const ContactTerms&) = default;
};

/// A body as rules see it.
struct ContactBody {
  std::string_view path;     ///< of the body, or of the object that is one
  std::string_view surface;  ///< of its shape
};

/// What the rules make of the table for two bodies; `same_robot`: of one and the same.
/// @throws std::invalid_argument naming both surfaces when they may touch and the table lacks the pair
ContactTerms contactTerms(const SurfaceTable& table, const std::vector<ContactRule>& rules, const ContactBody& a,
                          const ContactBody& b, bool same_robot);

}  // namespace murosimf
