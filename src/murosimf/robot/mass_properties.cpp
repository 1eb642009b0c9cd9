#include "murosimf/robot/mass_properties.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace murosimf {
namespace {

Vector3 times(const SymmetricMatrix& m, const Vector3& v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

SymmetricMatrix operator+(const SymmetricMatrix& a, const SymmetricMatrix& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}

/// R M R^T.
SymmetricMatrix turned(const Rotation3& R, const SymmetricMatrix& M) {
  const Rotation3 rows = transposed(R);
  const Vector3 mx = times(M, rows.x), my = times(M, rows.y), mz = times(M, rows.z);
  return {dot(rows.x, mx), dot(rows.y, my), dot(rows.z, mz), dot(rows.x, my), dot(rows.x, mz), dot(rows.y, mz)};
}

/// Inertia of a point mass at r about the origin: m (r^2 1 - r r^T).
SymmetricMatrix pointInertia(double mass, const Vector3& r) {
  return {mass * (r.y * r.y + r.z * r.z),
          mass * (r.x * r.x + r.z * r.z),
          mass * (r.x * r.x + r.y * r.y),
          -mass * r.x * r.y,
          -mass * r.x * r.z,
          -mass * r.y * r.z};
}

using Matrix = std::array<std::array<double, 3>, 3>;

/// One Jacobi rotation in the plane (p, q): makes the entry (p, q) zero and keeps the eigenvalues.
void annihilate(Matrix& a, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (theta < 0 ? -1.0 : 1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  const std::size_t r = 3 - p - q;
  const double arp = a[r][p], arq = a[r][q];
  a[p][p] -= t * a[p][q];
  a[q][q] += t * a[p][q];
  a[p][q] = a[q][p] = 0;
  a[r][p] = a[p][r] = c * arp - s * arq;
  a[r][q] = a[q][r] = s * arp + c * arq;
}

bool allFinite(const MassProperties& b) {
  for (const double x : {b.mass, b.p_BC_B.x, b.p_BC_B.y, b.p_BC_B.z, b.I_C_B.xx, b.I_C_B.yy, b.I_C_B.zz, b.I_C_B.xy,
                         b.I_C_B.xz, b.I_C_B.yz}) {
    if (!std::isfinite(x)) return false;
  }
  return true;
}

}  // namespace

MassProperties boxMass(double mass, const Vector3& edges, const Vector3& centre) {
  const Vector3 squares{edges.x * edges.x, edges.y * edges.y, edges.z * edges.z};
  const double twelfth = mass / 12;
  return {mass,
          centre,
          {twelfth * (squares.y + squares.z), twelfth * (squares.x + squares.z), twelfth * (squares.x + squares.y), 0,
           0, 0}};
}

MassProperties moved(const Pose& X_AB, const MassProperties& body) {
  return {body.mass, X_AB * body.p_BC_B, turned(X_AB.rotation, body.I_C_B)};
}

MassProperties welded(const MassProperties& a, const MassProperties& b) {
  if (b.mass == 0) return a;
  if (a.mass == 0) return b;
  const double mass = a.mass + b.mass;
  const Vector3 centre = (a.p_BC_B * a.mass + b.p_BC_B * b.mass) * (1 / mass);
  return {mass, centre,
          a.I_C_B + pointInertia(a.mass, a.p_BC_B - centre) + (b.I_C_B + pointInertia(b.mass, b.p_BC_B - centre))};
}

Vector3 principalMoments(const SymmetricMatrix& m) {
  Matrix a{{{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}}};
  for (int sweep = 0; sweep < 12; ++sweep) {  // converges quadratically: five are enough for all digits
    annihilate(a, 0, 1);
    annihilate(a, 0, 2);
    annihilate(a, 1, 2);
  }
  Vector3 moments{a[0][0], a[1][1], a[2][2]};
  if (moments.y < moments.x) std::swap(moments.x, moments.y);
  if (moments.z < moments.y) std::swap(moments.y, moments.z);
  if (moments.y < moments.x) std::swap(moments.x, moments.y);
  return moments;
}

std::string massProblem(const MassProperties& body) {
  if (!allFinite(body)) return "mass properties hold a number that is not finite";
  if (!(body.mass > 0)) return fmt::format("mass is {} kg, expected more than 0", body.mass);
  const Vector3 moments = principalMoments(body.I_C_B);
  const std::string found =
      fmt::format("inertia has the principal moments {:.4g}, {:.4g}, {:.4g} kg m^2", moments.x, moments.y, moments.z);
  if (!(moments.x > 0)) return found + ", expected all to be positive";
  if (!(moments.x + moments.y >= moments.z * (1 - 1e-6))) {
    return found + ", expected the two smaller ones to add up to at least the largest, as they do for every body";
  }
  return "";
}

}  // namespace murosimf
