#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// A triangle given by its corners, m, counter-clockwise seen from outside.
struct Facet {
  Vec3 a, b, c;
};

/// Intersection of a line with the plane of a facet.
struct PlaneCrossing {
  double s = 0.0;    ///< parameter of the line
  double out = 0.0;  ///< direction along the normal, times twice the facet's area
  std::array<double, 3>
      beside{};  ///< barycentric coordinates opposite ab, bc and ca: negative beyond that edge
};

/// Intersects the line x + s d with the plane of a facet (Moeller and Trumbore, 1997). Returns
/// nothing if the sine of the angle between them is at most `parallel`, or if d = 0.
inline std::optional<PlaneCrossing> cross_plane(const Facet& f, const Vec3& x, const Vec3& d,
                                                double parallel) {
  const Vec3 e1 = f.b - f.a, e2 = f.c - f.a, n = e1.cross(e2), r = x - f.a;
  const double out = n.dot(d);
  if (out * out <= parallel * parallel * n.squaredNorm() * d.squaredNorm()) return std::nullopt;
  const Vec3 w = d.cross(r);
  const double beta = w.dot(e2) / out, gamma = -w.dot(e1) / out;
  return PlaneCrossing{-n.dot(r) / out, out, {gamma, 1.0 - beta - gamma, beta}};
}

/// Intersection of a line with the plane of a facet, and how far inside the facet it is.
struct LineHit {
  double s = 0.0;       ///< parameter of the line
  double margin = 0.0;  ///< smallest barycentric coordinate: 0 on an edge, negative outside
};

/// Intersects the line x + s d with the plane of a facet. Returns nothing if they are parallel up
/// to rounding, or if d = 0.
inline std::optional<LineHit> meet(const Facet& f, const Vec3& x, const Vec3& d) {
  constexpr double rounding = 1e-15;
  const auto crossing = cross_plane(f, x, d, rounding);
  if (!crossing) return std::nullopt;
  return LineHit{crossing->s, *std::ranges::min_element(crossing->beside)};
}

/// Squared distance from x to the closest point of a facet, m2.
double squared_distance(const Facet& f, const Vec3& x);

struct Surface;

/// Area vector of a triangle, mesh (2): half the cross product of two edges, along the normal. m2.
inline Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a);
}

/// Shape quality q = 4 sqrt(3) A / (a^2 + b^2 + c^2), mesh (5), thesis 4.2.4.4: 1 for an
/// equilateral triangle, 0 for a degenerate one.
double triangle_quality(const Vec3& a, const Vec3& b, const Vec3& c);

/// Shape quality of a surface: the quality of its worst triangle, and the quality that 99 % of the
/// triangles exceed. Zero without triangles.
struct QualityStatistics {
  double least = 0.0, one_percent = 0.0;
};
QualityStatistics quality_statistics(const TriangleMesh& m);
QualityStatistics quality_statistics(const Surface& s);

/// Volume enclosed by a closed mesh, m3, mesh (3): signed tetrahedra about the first position
/// (compensated sum). Positive if the normals point outwards.
double enclosed_volume(const TriangleMesh& m);

/// Total area, m2.
double area(const TriangleMesh& m);

/// Axis-aligned box. The empty box has lo > hi.
struct Box {
  Vec3 lo = Vec3::Constant(1e300);
  Vec3 hi = Vec3::Constant(-1e300);

  void add(const Vec3& x) {
    lo = lo.cwiseMin(x);
    hi = hi.cwiseMax(x);
  }
  bool contains(const Vec3& x) const {
    return (x.array() >= lo.array()).all() && (x.array() <= hi.array()).all();
  }
  bool overlaps(const Box& b) const {
    return (lo.array() <= b.hi.array()).all() && (b.lo.array() <= hi.array()).all();
  }
  Vec3 size() const { return hi - lo; }
};

Box bounding_box(const TriangleMesh& m);

}  // namespace tdbd::mesh
