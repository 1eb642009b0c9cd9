#include "murosimf/render/mass_renderers.h"

#include <cmath>

namespace murosimf {

namespace {

/// Columns of R and the diagonal of R^T I R become the principal axes and moments, one plane (p, q) at a time.
void annihilate(double (&a)[3][3], Vector3 (&axes)[3], int p, int q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (theta < 0 ? -1.0 : 1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  const int r = 3 - p - q;
  const double apq = a[p][q], arp = a[r][p], arq = a[r][q];
  a[p][p] -= t * apq, a[q][q] += t * apq;
  a[p][q] = a[q][p] = 0;
  a[r][p] = a[p][r] = c * arp - s * arq;
  a[r][q] = a[q][r] = s * arp + c * arq;
  const Vector3 old = axes[p];
  axes[p] = old * c - axes[q] * s;
  axes[q] = old * s + axes[q] * c;
}

std::vector<PrincipalMass> massesOf(const RenderedObject& object) {
  std::vector<PrincipalMass> masses;
  for (const ObjectId body : object.world.members(object.object, subset::kBodies)) {
    const auto inertia = object.world.find(body, kBodyInertia);
    masses.push_back(inertia ? principalMass(*inertia) : PrincipalMass{});
  }
  return masses;
}

const Tint kMassTint{1.0F, 0.9F, 0.2F};

}  // namespace

PrincipalMass principalMass(const RigidInertia<double>& inertia) {
  PrincipalMass result;
  result.mass = inertia.m;
  if (!(inertia.m > 0)) return result;
  const Vector3 c = inertia.mc * (1 / inertia.m);
  const double m = inertia.m, cc = dot(c, c);
  const auto& I = inertia.I;
  // About the centre of mass: I - m (c.c 1 - c c^T).
  double a[3][3] = {{I.xx - m * (cc - c.x * c.x), I.xy + m * c.x * c.y, I.xz + m * c.x * c.z},
                    {I.xy + m * c.x * c.y, I.yy - m * (cc - c.y * c.y), I.yz + m * c.y * c.z},
                    {I.xz + m * c.x * c.z, I.yz + m * c.y * c.z, I.zz - m * (cc - c.z * c.z)}};
  Vector3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int sweep = 0; sweep < 8; ++sweep) {
    annihilate(a, axes, 0, 1);
    annihilate(a, axes, 0, 2);
    annihilate(a, axes, 1, 2);
  }
  const Vector3 z = cross(axes[0], axes[1]);  // right-handed
  result.X_BC = {{axes[0], axes[1], z}, c};
  const double x = a[0][0], y = a[1][1], w = a[2][2];
  const auto half = [&](double others, double own) { return std::sqrt(std::max(0.0, 1.5 * (others - own) / m)); };
  result.half_edges = {half(y + w, x), half(x + w, y), half(x + y, w)};
  return result;
}

CentreOfMassRenderer::CentreOfMassRenderer(const RenderedObject& object) : places_(object), bodies_(massesOf(object)) {}

void CentreOfMassRenderer::draw(const RenderMoment& now, DrawList& list) {
  double mass = 0;
  Vector3 moment;
  for (std::size_t row = 0; row < bodies_.size(); ++row) {
    if (!(bodies_[row].mass > 0)) continue;
    const Vector3 p_W = places_.pose(static_cast<int>(row), now.frame) * bodies_[row].X_BC.translation;
    mass += bodies_[row].mass;
    moment += p_W * bodies_[row].mass;
    list.sphere(p_W, 0.008 * std::cbrt(bodies_[row].mass / 0.1), kMassTint);
  }
  if (!(mass > 0)) return;
  const Vector3 c_W = moment * (1 / mass), ground_W{c_W.x, c_W.y, 0.004};
  list.sphere(c_W, 0.025, {1.0F, 0.35F, 0.1F});
  list.rod(c_W, ground_W, 0.002, {1.0F, 0.35F, 0.1F});
  list.mesh(MeshLibrary::kCylinder, {{}, ground_W}, {0.02, 0.02, 0.002}, {1.0F, 0.35F, 0.1F});
}

InertiaRenderer::InertiaRenderer(const RenderedObject& object) : places_(object), bodies_(massesOf(object)) {}

void InertiaRenderer::draw(const RenderMoment& now, DrawList& list) {
  for (std::size_t row = 0; row < bodies_.size(); ++row) {
    const PrincipalMass& body = bodies_[row];
    if (!(body.mass > 0)) continue;
    const Pose X_WC = places_.pose(static_cast<int>(row), now.frame) * body.X_BC;
    list.mesh(MeshLibrary::kBox, X_WC, body.half_edges, {0.3F, 0.6F, 1.0F, 0.45F});
  }
}

}  // namespace murosimf
