#include "player/vision/ball_finder.h"

#include <algorithm>
#include <array>

#include "player/vision/uncertainty.h"

namespace murosimf::controllers {
namespace {

constexpr int kSpokes = 24;
constexpr int kMostCandidates = 6;

struct OutlinePoint {
  Vector3 ray_C;      ///< unit vector
  bool open = false;  ///< what lies beyond is carpet, line or far background, nothing that may cover the ball
  bool used = true;
};

/// The outline as seen from one place inside.
struct Outline {
  std::array<OutlinePoint, kSpokes> points;
  int count = 0;     ///< edges found; the border of the picture is none
  int on_field = 0;  ///< those with carpet or line beyond
};

/// The cone around a sphere.
struct Cone {
  Vector3 axis_C;        ///< unit vector to the centre
  double sine = 0;       ///< sin alpha
  double deviation = 0;  ///< rms of the used outline points' angles [rad]
  int used = 0;
  int outside = 0;  ///< outline points that lie outside of the cone: nothing that covers a ball can do that
};

Vector3 unitRay(const PictureView& view, const PixelPoint& p) {
  const PlanePoint ray = view.rays->ray(p.u, p.v);
  return normalized(Vector3{ray.a, ray.b, 1});
}

Outline traceOutline(const PictureView& view, const PixelPoint& from, int reach) {
  Outline outline;
  for (int i = 0; i < kSpokes; ++i) {
    const SinCos<double> direction = sincos(2 * kPi / kSpokes * i);
    const Edge edge = walkToEdge(view, kOrangeSignal, from, direction.cos, direction.sin, reach);
    if (edge.end != Edge::End::kFound) continue;
    const bool field = edge.outside == Colour::kGreen || edge.outside == Colour::kWhite;
    outline.points[static_cast<std::size_t>(outline.count++)] = {unitRay(view, edge.at), field, true};
    outline.on_field += field ? 1 : 0;
  }
  return outline;
}

/// Least squares for e . n = 1 over the used points. Columns of the normal matrix are its rows.
std::optional<Vector3> solveCone(const Outline& outline, int count) {
  Vector3 row[3], right;
  for (int i = 0; i < count; ++i) {
    const OutlinePoint& p = outline.points[static_cast<std::size_t>(i)];
    if (!p.used) continue;
    for (int k = 0; k < 3; ++k) row[k] += p.ray_C * p.ray_C[k];
    right += p.ray_C;
  }
  const Vector3 c = cross(row[1], row[2]);
  const double determinant = dot(row[0], c);
  if (determinant < 1e-14) return std::nullopt;
  return (c * right.x + cross(row[2], row[0]) * right.y + cross(row[0], row[1]) * right.z) * (1 / determinant);
}

/// Angle of a point from the outline, positive outside: e . n - 1 = -tan(alpha) times it.
double excess(const OutlinePoint& p, const Vector3& n, double tangent) { return (1 - dot(p.ray_C, n)) / tangent; }

std::optional<Cone> fitOnce(const Outline& outline) {
  const std::optional<Vector3> n = solveCone(outline, outline.count);
  if (!n || squaredNorm(*n) <= 1 + 1e-9) return std::nullopt;
  Cone cone;
  const double cosine = 1 / norm(*n), tangent = sqrt(squaredNorm(*n) - 1);
  cone.axis_C = *n * cosine;
  cone.sine = tangent * cosine;
  double sum = 0;
  for (int i = 0; i < outline.count; ++i) {
    const OutlinePoint& p = outline.points[static_cast<std::size_t>(i)];
    if (!p.used) continue;
    const double e = excess(p, *n, tangent);
    sum += e * e;
    ++cone.used;
  }
  cone.deviation = sqrt(sum / std::max(1, cone.used - 3));
  return cone;
}

int countOutside(const Outline& outline, const Cone& cone, double limit) {
  const double cosine = sqrt(1 - cone.sine * cone.sine);
  int outside = 0;
  for (int i = 0; i < outline.count; ++i) {
    const OutlinePoint& p = outline.points[static_cast<std::size_t>(i)];
    outside += excess(p, cone.axis_C * (1 / cosine), cone.sine / cosine) > limit ? 1 : 0;
  }
  return outside;
}

/// Fits the cone, first by points with open background if there are enough, then by all that agree with it.
std::optional<Cone> fitCone(Outline& outline, double pixel_angle) {
  int open = 0;
  for (int i = 0; i < outline.count; ++i) open += outline.points[static_cast<std::size_t>(i)].open ? 1 : 0;
  for (OutlinePoint& p : outline.points) p.used = open < 7 || p.open;
  std::optional<Cone> cone = fitOnce(outline);
  for (int round = 0; round < 3 && cone; ++round) {
    const double limit = std::max(1.2 * pixel_angle, std::min(2.5 * cone->deviation, 0.12 * cone->sine));
    const double cosine = sqrt(1 - cone->sine * cone->sine);
    const Vector3 n = cone->axis_C * (1 / cosine);
    for (OutlinePoint& p : outline.points) {
      const double e = excess(p, n, cone->sine / cosine);
      p.used = e < limit && e > -limit;
    }
    cone = fitOnce(outline);
    if (cone) cone->outside = countOutside(outline, *cone, limit);
  }
  return cone;
}

/// Share of the disc, as far as the picture shows it, that is orange.
double orangeShare(const PictureView& view, const PixelPoint& centre, double radius) {
  int seen = 0, orange = 0;
  for (int i = 0; i < 36; ++i) {
    const SinCos<double> direction = sincos(2 * kPi / 12 * i + 0.2);
    const double r = radius * (i < 12 ? 0.3 : i < 24 ? 0.55 : 0.8);
    const int u = static_cast<int>(centre.u + r * direction.cos + 0.5);
    const int v = static_cast<int>(centre.v + r * direction.sin + 0.5);
    if (!view.inside(u, v)) continue;
    ++seen;
    orange += view.colour(u, v) == Colour::kOrange ? 1 : 0;
  }
  return seen == 0 ? 0 : static_cast<double>(orange) / seen;
}

PixelPoint pixelOf(const PictureView& view, const Vector3& ray_C) {
  return toPixel(*view.description, {ray_C.x / ray_C.z, ray_C.y / ray_C.z});
}

/// Radius of the circle that covers as much of the picture as the cone: in the plane before the camera the cone's cut
/// is longer by 1 / cos^2 along the way from the axis and by 1 / cos across it; the lens scales areas by its Jacobian.
double radiusInPixels(const PictureView& view, const Cone& cone) {
  const Vector3& c = cone.axis_C;
  const DistortedPoint lens = distort(*view.description, {c.x / c.z, c.y / c.z});
  const double area = lens.determinant();
  return cone.sine / c.z * sqrt(std::max(0.01, area) / c.z) * view.description->fx;
}

/// The fitted ball in the picture.
struct Disc {
  Cone cone;
  PixelPoint centre;
  double radius = 0;  ///< [pixels]
  double on_field = 0, orange = 0;
};

std::optional<Disc> measureDisc(const PictureView& view, PixelPoint seed, int reach) {
  const double pixel_angle = 1 / view.description->fx;
  Outline outline = traceOutline(view, seed, reach);
  std::optional<Cone> cone = fitCone(outline, pixel_angle);
  if (!cone || cone->axis_C.z < 0.1) return std::nullopt;
  const PixelPoint centre = pixelOf(view, cone->axis_C);
  const int u = static_cast<int>(centre.u + 0.5), v = static_cast<int>(centre.v + 0.5);
  if (centre.u > 0 && centre.v > 0 && view.inside(u, v) && view.colour(u, v) == Colour::kOrange) {
    outline = traceOutline(view, centre, reach);
    cone = fitCone(outline, pixel_angle);
    if (!cone || cone->axis_C.z < 0.1) return std::nullopt;
  }
  Disc disc{*cone, pixelOf(view, cone->axis_C), 0, static_cast<double>(outline.on_field) / kSpokes, 0};
  disc.radius = radiusInPixels(view, *cone);
  disc.orange = orangeShare(view, disc.centre, disc.radius);
  return disc;
}

/// Round, orange all over, and on the carpet; the more of it is covered the less is asked of the rest.
bool looksLikeBall(const Disc& disc, double pixel_angle) {
  if (disc.cone.used < 9 || disc.cone.outside > 2 || disc.on_field < 0.25) return false;
  const bool whole = disc.cone.used >= 18;
  if (!whole && disc.radius < 5) return false;  // too little to measure
  const double roundness = std::max(0.04 * disc.cone.sine, 0.6 * pixel_angle);
  return disc.cone.deviation < roundness && disc.orange > (whole ? 0.75 : 0.6);
}

struct Candidate {
  BallPercept ball;
  client::Percept drawn;
};

std::optional<Candidate> placeBall(const PictureView& view, const Disc& disc, double ball_radius) {
  const Vector3 axis_R = view.X_RC.rotation * disc.cone.axis_C;
  const std::optional<Vector3> on_plane = view.meetPlane(axis_R, ball_radius);
  if (!on_plane) return std::nullopt;
  const double by_size = ball_radius / disc.cone.sine;
  const Vector3 p_size = view.X_RC.translation + axis_R * by_size;
  const double camera_height = view.X_RC.translation.z - ball_radius;
  const double tolerance = 0.03 + camera_height * (0.1 + 1 / disc.radius) + by_size * 0.05;
  if (abs(p_size.z - ball_radius) > tolerance) return std::nullopt;

  const double d_plane = horizontal(*on_plane - view.X_RC.translation);
  const double d_size = horizontal(p_size - view.X_RC.translation);
  if (d_plane > 9) return std::nullopt;
  const bool whole = disc.cone.used >= 18;
  const Estimate plane{d_plane, groundDeviation(d_size, camera_height, view.description->fx)};
  const Estimate size{d_size, d_size * ((whole ? 0.35 : 1.0) / disc.radius + 0.01)};
  const Estimate fused = fuse(plane, size);
  const double scale = fused.value / std::max(1e-3, horizontal(axis_R));
  const Vector3 p = view.X_RC.translation + axis_R * scale;

  Candidate c;
  c.ball = {p.x, p.y, fused.deviation};
  c.drawn = {client::Percept::Kind::kBall,
             view.camera,
             disc.centre.u,
             disc.centre.v,
             disc.radius,
             horizontal(p),
             atan2(p.y, p.x)};
  return c;
}

/// A place well inside the region: the middle of its widest run.
PixelPoint seedOf(const ColourGrid& grid, const Region& region) {
  const Run& run = grid.runs()[static_cast<std::size_t>(region.widest_run)];
  return {static_cast<double>(grid.pixelOf((run.first + run.last) / 2)), static_cast<double>(grid.pixelOf(run.row))};
}

std::optional<Candidate> examine(const PictureView& view, const ColourGrid& grid, const Region& region, double radius) {
  const int span = std::max(region.right - region.left, region.bottom - region.top) + 3;
  const std::optional<Disc> disc = measureDisc(view, seedOf(grid, region), span * grid.step());
  if (!disc || !looksLikeBall(*disc, 1 / view.description->fx)) return std::nullopt;
  return placeBall(view, *disc, radius);
}

}  // namespace

void findBalls(const PictureView& view, const ColourGrid& grid, double ball_radius, Percepts& out) {
  std::array<const Region*, kMostCandidates> largest{};
  std::size_t count = 0;
  for (const Region& region : grid.regions()) {
    if (region.colour != Colour::kOrange || region.cells < 3) continue;
    std::size_t place = count < largest.size() ? count++ : largest.size();
    for (; place > 0 && largest[place - 1]->cells < region.cells; --place) {
      if (place < largest.size()) largest[place] = largest[place - 1];
    }
    if (place < largest.size()) largest[place] = &region;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto candidate = examine(view, grid, *largest[i], ball_radius);
    if (!candidate) continue;
    out.balls.push_back(candidate->ball);
    out.drawn.push_back(candidate->drawn);
  }
}

}  // namespace murosimf::controllers
