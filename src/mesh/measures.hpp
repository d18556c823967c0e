#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

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
struct QualityFigures {
  double least = 0.0, one_percent = 0.0;
};
QualityFigures quality_figures(const TriangleMesh& m);
QualityFigures quality_figures(const Surface& s);

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
