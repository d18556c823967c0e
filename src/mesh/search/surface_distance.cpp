#include "mesh/search/surface_distance.hpp"

#include <algorithm>

#include "mesh/search/inside.hpp"

namespace tdbd::mesh {
namespace {

/// Computes distances of successive points. The distance of the last point bounds that of the next
/// one, which speeds up the search.
struct Walk {
  const TriangleTree& to;
  Vec3 last;
  double there;  ///< m, distance of the last point

  double distance_of(const Vec3& x) {
    constexpr double above = 1.0 + 1e-9, least = 1e-12;  // m: margin for rounding
    there = distance_up_to(to, x, (there + (x - last).norm()) * above + least);
    last = x;
    return there;
  }
};

/// Calls visit(x) for the centroid of each of the n * n equal parts of a triangle.
template <class Visit>
void visit_parts(const Facet& f, int n, Visit&& visit) {
  const auto point = [&](double i, double j) -> Vec3 {
    return f.a + (f.b - f.a) * (i / n) + (f.c - f.a) * (j / n);
  };
  constexpr double third = 1.0 / 3.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      visit(point(i + third, j + third));
      if (i + j + 1 < n) visit(point(i + 2.0 * third, j + 2.0 * third));
    }
}

/// Number of parts per edge such that every point of the facet is at most `spacing` from a corner
/// or from the centroid of a part.
int parts_along(const Facet& f, double spacing) {
  const double longest = std::max({(f.b - f.a).norm(), (f.c - f.b).norm(), (f.a - f.c).norm()});
  return 1 + static_cast<int>(longest / spacing);
}

}  // namespace

SurfaceDistance distance_to(const TriangleMesh& from, const TriangleTree& to, double spacing) {
  SurfaceDistance found;
  if (from.triangles.empty()) return found;
  const Vec3& first = from.positions[at(from.triangles.front()[0])];
  Walk walk{to, first, distance(to, first)};
  for (const Triangle& t : from.triangles) {
    const Facet f{from.positions[at(t[0])], from.positions[at(t[1])], from.positions[at(t[2])]};
    for (const Vec3& x : {f.a, f.b, f.c})
      found.largest = std::max(found.largest, walk.distance_of(x));
    const int n = parts_along(f, spacing);
    const double area = 0.5 * (f.b - f.a).cross(f.c - f.a).norm() / (n * n);
    visit_parts(f, n, [&](const Vec3& x) {
      const double d = walk.distance_of(x);
      found.largest = std::max(found.largest, d);
      found.volume += d * area;
    });
  }
  return found;
}

}  // namespace tdbd::mesh
