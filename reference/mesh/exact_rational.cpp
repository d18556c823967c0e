#include "reference/mesh/exact_rational.hpp"

#include <array>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

using RVec3 = std::array<Rational, 3>;

RVec3 exact(const Vec3& a) { return {Rational(a[0]), Rational(a[1]), Rational(a[2])}; }

RVec3 operator+(const RVec3& a, const RVec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

RVec3 operator-(const RVec3& a, const RVec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

RVec3 operator*(const Rational& s, const RVec3& a) { return {s * a[0], s * a[1], s * a[2]}; }

Rational dot(const RVec3& a, const RVec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

RVec3 cross(const RVec3& a, const RVec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::array<RVec3, 3> corners(const mesh::TriangleMesh& m, const mesh::Triangle& f) {
  return {exact(m.positions[f[0]]), exact(m.positions[f[1]]), exact(m.positions[f[2]])};
}

/// Integral of det J over the prism between triangles x (zeta = 0) and y (zeta = 1). With edges
/// e1(zeta), e2(zeta) linear in zeta and w the mean displacement of the corners, V = 1/2 integral
/// of (e1 x e2) . w d zeta, and e1 x e2 = (1-zeta)^2 A + zeta (1-zeta) B + zeta^2 C, whose weights
/// have the integrals 1/3, 1/6, 1/3.
Rational prism(const std::array<RVec3, 3>& x, const std::array<RVec3, 3>& y) {
  const RVec3 e1x = x[1] - x[0], e2x = x[2] - x[0], e1y = y[1] - y[0], e2y = y[2] - y[0];
  const RVec3 A = cross(e1x, e2x);
  const RVec3 B = cross(e1x, e2y) + cross(e1y, e2x);
  const RVec3 C = cross(e1y, e2y);
  const RVec3 w = Rational(1, 3) * ((y[0] - x[0]) + (y[1] - x[1]) + (y[2] - x[2]));
  const RVec3 mean_normal = Rational(1, 3) * A + Rational(1, 6) * B + Rational(1, 3) * C;
  return Rational(1, 2) * dot(mean_normal, w);
}

}  // namespace

Rational signed_volume_rational(const mesh::TriangleMesh& m) {
  Rational six_volumes(0);
  for (const mesh::Triangle& f : m.triangles) {
    const auto [a, b, c] = corners(m, f);
    six_volumes += dot(a, cross(b, c));
  }
  return six_volumes / Rational(6);
}

Rational prism_volume_rational(const mesh::TriangleMesh& before, const mesh::TriangleMesh& after) {
  if (before.triangles != after.triangles)
    throw RunError("prism_volume: the two surfaces do not have the same triangles");
  Rational sum(0);
  for (const mesh::Triangle& f : before.triangles)
    sum += prism(corners(before, f), corners(after, f));
  return sum;
}

}  // namespace tdbd::reference
