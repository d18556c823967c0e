#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "core/types.hpp"

namespace tdbd::mesh {

/// A triangle by its corners, m, counter-clockwise seen from outside.
struct Facet {
  Vec3 a, b, c;
};

/// A line against a facet's plane: its parameter there, how steeply it goes out of the plane (times
/// twice the facet's area) and the barycentric coordinates that face the edges ab, bc and ca:
/// negative beyond that edge.
struct PlaneCrossing {
  double s = 0.0, out = 0.0;
  std::array<double, 3> beside{};
};

/// x + s d against a facet's plane (Moeller and Trumbore, 1997). Nothing when the sine between them
/// is at most `parallel`, and for d = 0.
inline std::optional<PlaneCrossing> cross_plane(const Facet& f, const Vec3& x, const Vec3& d,
                                                double parallel) {
  const Vec3 e1 = f.b - f.a, e2 = f.c - f.a, n = e1.cross(e2), r = x - f.a;
  const double out = n.dot(d);
  if (out * out <= parallel * parallel * n.squaredNorm() * d.squaredNorm()) return std::nullopt;
  const Vec3 w = d.cross(r);
  const double beta = w.dot(e2) / out, gamma = -w.dot(e1) / out;
  return PlaneCrossing{-n.dot(r) / out, out, {gamma, 1.0 - beta - gamma, beta}};
}

/// Where a line meets the plane of a facet, and how well inside the facet that is.
struct LineHit {
  double s = 0.0;       ///< the line's parameter
  double margin = 0.0;  ///< smallest barycentric coordinate: 0 on the rim, negative outside
};

/// x + s d against a facet. Nothing when they are parallel to rounding, and for d = 0.
inline std::optional<LineHit> meet(const Facet& f, const Vec3& x, const Vec3& d) {
  constexpr double rounding = 1e-15;
  const auto crossing = cross_plane(f, x, d, rounding);
  if (!crossing) return std::nullopt;
  return LineHit{crossing->s, *std::ranges::min_element(crossing->beside)};
}

/// Square of the distance from x to the nearest point of a facet, m2.
double squared_distance(const Facet& f, const Vec3& x);

}  // namespace tdbd::mesh
