#pragma once

/// @file What a camera could see: which things, and which parts of lines, with nothing wrong.
///
/// In view    A thing is in view when one of nine points of its axis falls into the picture, through the real lens; a
///            ball when its centre does. Of a line, the parts that do.
/// Occlusion  A small picture is cast, about 160 pixels wide, that tells what each pixel shows. A thing is seen when
///            kLeastPixels of the camera's own picture show it, at least one of the small one; a point of a line when
///            its pixel shows the ground.
/// Lines are tried every kLineStep; ends of what is seen are halved out from there: exact where the picture ends, to a
/// small pixel where something hides the line.
/// Cost       640 x 480: one picture of 160 x 120, plus some microseconds a line. No allocation after the first looks.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "murosimf/algorithms/ray_caster.h"
#include "murosimf/modules/camera/sight_errors.h"

namespace murosimf {

inline constexpr double kLeastPixels = 12, kLineStep = 0.1;  // [m]

/// A landmark, found among the drawables of a scene.
struct OracleTarget {
  SightKind kind = SightKind::kBall;
  int first = 0, last = 0;  ///< drawables [first, last) show it; none: paint on the ground
  int carrier = -1;         ///< drawable whose pose moves it; -1: it stands in W
  Pose X_SB;                ///< B in the carrier's frame
  Vector3 a, b;             ///< these and what follows: as in Landmark
  bool grounded = false;
  double height = 0;
};

/// One thing seen: where, in W; q: a line's other end, else p.
struct TrueSight {
  int target = 0;
  Vector3 p_W, q_W;
};

/// A camera of 1/divisor the size, whose pixels are squares of divisor x divisor pixels.
CameraModel shrunkCamera(const CameraModel& camera, int divisor);

class OracleEye {
 public:
  /// @param hidden  owners of drawables that the camera does not show
  OracleEye(const CameraModel& camera, std::vector<OracleTarget> targets, std::vector<std::uint32_t> hidden,
            const ErrorsByKind& errors);

  const CameraModel& camera() const { return camera_; }
  const std::vector<OracleTarget>& targets() const { return targets_; }
  /// Looks from X_WC. @return what is seen, in the order of targets; valid until the next look
  std::span<const TrueSight> look(const RayScene& scene, const Pose& X_WC);

 private:
  struct View {  // of the look that is under way
    const RayScene* scene = nullptr;
    Pose X_WC;
  };
  void castSmallPicture(const View& view);
  void lookForThing(const View& view, int target);
  void lookForLine(const View& view, int target);
  /// Where a point falls into the picture, if it does.
  std::optional<ImagePoint> placeOf(const View& view, const Vector3& p_W) const;
  bool showsGround(ImagePoint place) const;
  Vector3 endBetween(const View& view, const Vector3& seen, const Vector3& unseen, const SightErrors& errors) const;
  bool isSeen(const View& view, const Vector3& p_W, const SightErrors& errors) const;

  CameraModel camera_;
  std::vector<OracleTarget> targets_;
  std::vector<std::uint32_t> hidden_;
  ErrorsByKind errors_;
  double valid_radius_;  // of the lens
  int divisor_, least_pixels_;
  std::unique_ptr<const RayTable> small_rays_;  // null: nothing hides anything
  PreparedScene prepared_;
  Picture picture_;
  std::vector<int> pixels_;  // that show each drawable
  std::vector<TrueSight> sights_;
};

}  // namespace murosimf
