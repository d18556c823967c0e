#pragma once

#include <algorithm>
#include <optional>

#include "core/types.hpp"

namespace tdbd::mesh {

/// A triangle by its corners, m, counter-clockwise seen from outside.
struct Facet {
  Vec3 a, b, c;
};

/// Where a line meets the plane of a facet, and how well inside the facet that is.
struct LineHit {
  double s = 0.0;       ///< the line's parameter
  double margin = 0.0;  ///< smallest barycentric coordinate: 0 on the rim, negative outside
};

/// x + s d against a facet's plane (Moeller and Trumbore, 1997). Nothing when they are parallel to
/// rounding, and for d = 0.
inline std::optional<LineHit> meet(const Facet& f, const Vec3& x, const Vec3& d) {
  constexpr double parallel = 1e-15;
  const Vec3 e1 = f.b - f.a, e2 = f.c - f.a, n = e1.cross(e2), r = x - f.a;
  const double det = n.dot(d);
  if (det * det <= parallel * parallel * n.squaredNorm() * d.squaredNorm()) return std::nullopt;
  const Vec3 w = d.cross(r);
  const double beta = w.dot(e2) / det, gamma = -w.dot(e1) / det;
  return LineHit{-n.dot(r) / det, std::min({beta, gamma, 1.0 - beta - gamma})};
}

/// Square of the distance from x to the nearest point of a facet, m2.
double squared_distance(const Facet& f, const Vec3& x);

}  // namespace tdbd::mesh
