#include "mesh/grade/grade_surface.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/measures.hpp"
#include "mesh/search/inside.hpp"

namespace tdbd::mesh {
namespace {

/// A feature that bends by more than this angle at a vertex has a corner there.
constexpr double corner_bend = 0.87;  // rad

Vec3 normal(const Surface& s, int t) {
  return area_vector(s.position(s.vertex(3 * t)), s.position(s.vertex(3 * t + 1)),
                     s.position(s.vertex(3 * t + 2)))
      .stableNormalized();
}

/// The other ends of the feature edges at each vertex.
std::vector<std::vector<int>> feature_ends(const GradeSurface& g) {
  std::vector<std::vector<int>> ends(g.s.stars.size());
  for (const auto& [a, b] : g.features) {
    ends[at(a)].push_back(b);
    ends[at(b)].push_back(a);
  }
  return ends;
}

Place place_of(const Surface& s, int v, const std::vector<int>& ends) {
  if (ends.empty()) return Place::face;
  if (ends.size() != 2) return Place::corner;
  const Vec3 d = (s.position(v) - s.position(ends[0])).stableNormalized();
  const Vec3 e = (s.position(ends[1]) - s.position(v)).stableNormalized();
  return d.dot(e) > std::cos(corner_bend) ? Place::crease : Place::corner;
}

/// The features as facets with zero area, for distance queries.
TriangleMesh feature_facets(const GradeSurface& g) {
  TriangleMesh m{positions_of(g.s), {}};
  m.triangles.reserve(g.features.size());
  for (const auto& [a, b] : g.features) m.triangles.push_back({a, b, b});
  return m;
}

}  // namespace

GradeSurface make_grade_surface(const TriangleMesh& m, const GradeOptions& options) {
  GradeSurface g;
  g.s = make_surface(m);
  g.options = options;
  g.original = TriangleTree(m);
  g.rounding = 1e-13 * bounding_box(m).size().norm();
  for (int c = 0; c < 3 * g.s.triangle_slots(); ++c)
    if (const int o = g.s.opposite_of(c);
        o > c && normal(g.s, c / 3).dot(normal(g.s, o / 3)) < std::cos(options.angle))
      g.features.insert(std::minmax({g.s.vertex(next_corner(c)), g.s.vertex(previous_corner(c))}));
  const auto ends = feature_ends(g);
  g.place.reserve(ends.size());
  for (std::size_t v = 0; v < ends.size(); ++v)
    g.place.push_back(place_of(g.s, static_cast<int>(v), ends[v]));
  g.moved.assign(ends.size(), 0.0);
  g.feature_tree = TriangleTree(feature_facets(g));
  return g;
}

double target(const GradeSurface& g, const Vec3& x) {
  const GradeOptions& o = g.options;
  if (o.growth <= 0.0) return g.features.empty() ? o.face : o.edge;
  const double reach = (o.face - o.edge) / o.growth;
  return o.edge + o.growth * distance_up_to(g.feature_tree, x, reach);
}

bool is_feature(const GradeSurface& g, int a, int b) {
  return g.features.contains(std::minmax(a, b));
}

}  // namespace tdbd::mesh
