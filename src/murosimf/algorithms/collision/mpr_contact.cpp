#include "murosimf/algorithms/collision/mpr_contact.h"

#include <ccd/ccd.h>

#include <limits>

namespace murosimf {
namespace {

constexpr double kTolerance = 1e-6;      // [m]
constexpr int kMostSupportPoints = 400;  // no pair of ours needs a tenth

/// One of the two shapes, as the library's functions see it.
struct Side {
  const ConvexPair& pair;
  bool is_b;
  mutable int calls = 0;
};

ccd_vec3_t toCcd(const Vector3& v) { return {{v.x, v.y, v.z}}; }
Vector3 fromCcd(const ccd_vec3_t& v) { return {v.v[0], v.v[1], v.v[2]}; }

/// The library's loops have no limit of their own; they end at numbers that are none.
void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* result) {
  const Side& side = *static_cast<const Side*>(object);
  const Vector3 d = fromCcd(*direction);
  if (++side.calls > kMostSupportPoints) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    *result = {{kNone, kNone, kNone}};
  } else {
    *result = toCcd(side.is_b ? side.pair.supportOfB(d) : side.pair.supportOfA(d));
  }
}

void centre(const void* object, ccd_vec3_t* result) {
  const Side& side = *static_cast<const Side*>(object);
  *result = toCcd(side.is_b ? side.pair.X_AB * innerPoint(side.pair.b) : innerPoint(side.pair.a));
}

}  // namespace

bool overlapByPortal(const ConvexPair& pair) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = support, ccd.support2 = support;
  ccd.center1 = centre, ccd.center2 = centre;
  ccd.mpr_tolerance = kTolerance;
  const Side a{pair, false}, b{pair, true};
  return ccdMPRIntersect(&a, &b, &ccd) != 0;
}

}  // namespace murosimf
