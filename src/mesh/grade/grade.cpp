#include "mesh/grade/grade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "mesh/check/check.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/edit.hpp"
#include "mesh/measures.hpp"

namespace tdbd::mesh {
namespace {

constexpr int most_rounds = 12;

/// Largest distance of the vertices, edge midpoints and centroids of a mesh from another surface,
/// up to `most`.
double farthest(const TriangleMesh& m, const TriangleTree& from, double most) {
  double worst = 0.0;
  const auto x = [&](int v) { return m.positions[at(v)]; };
  for (const auto& [a, b, c] : m.triangles)
    for (const Vec3& y : {x(a), Vec3(0.5 * (x(a) + x(b))), Vec3(0.5 * (x(b) + x(c))),
                          Vec3(0.5 * (x(c) + x(a))), Vec3((x(a) + x(b) + x(c)) / 3.0)})
      worst = std::max(worst, distance_up_to(from, y, most));
  return worst;
}

void require_bounds(const Graded& g, const TriangleMesh& m, const GradeSurface& surface) {
  const double most = surface.options.deviation + 10.0 * surface.rounding;
  if (g.deviation > most)
    throw RunError(
        fmt::format("grade: the surface moved by {:.3g} m, more than {:.3g} m", g.deviation, most));
  if (std::abs(g.volume_change) > most * area(m))
    throw RunError(fmt::format("grade: the volume changed by {:.3g} m3", g.volume_change));
  if (const auto defects = check_solid(g.mesh); !defects.empty())
    throw RunError("grade: the result bounds no solid: " + summarize(defects));
}

}  // namespace

Graded grade(const TriangleMesh& m, const GradeOptions& options) {
  if (const auto defects = check_solid(m); !defects.empty())
    throw InputError("a mesh that bounds no solid cannot be graded:\n" + summarize(defects));
  GradeSurface surface = make_grade_surface(m, options);
  Graded result;
  result.feature_edges = surface.features.size();
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t halved = refine(surface);
    flip(surface);
    const std::size_t collapsed = coarsen(surface);
    flip(surface);
    relax(surface);
    if (halved + collapsed == 0) break;
  }
  result.mesh = compact(surface.s);
  const double far = 2.0 * options.deviation + 100.0 * surface.rounding;
  result.deviation = std::max(farthest(result.mesh, surface.original, far),
                              farthest(m, TriangleTree(result.mesh), far));
  result.volume_change = enclosed_volume(result.mesh) - enclosed_volume(m);
  require_bounds(result, m, surface);
  return result;
}

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

namespace {

/// Distance from a plane up to which corners count as lying in it. It allows for rounded
/// coordinates in files.
double flat(const GradeSurface& g) { return g.rounding + 0.01 * g.options.deviation; }

/// Smallest improvement of the quality that justifies a change. It prevents cycles of changes that
/// undo each other.
constexpr double gain = 1e-6;

double quality(const Surface& s, int a, int b, int c) {
  return triangle_quality(s.position(a), s.position(b), s.position(c));
}

Vec3 area(const Surface& s, int a, int b, int c) {
  return area_vector(s.position(a), s.position(b), s.position(c));
}

/// Whether flipping the edge at c does not move the surface and improves the facets.
bool should_flip(const GradeSurface& g, int c) {
  const Surface& s = g.s;
  const int o = s.opposite_of(c);
  const int p = s.vertex(c), a = s.vertex(next_corner(c)), b = s.vertex(previous_corner(c));
  const int q = s.vertex(o);
  if (is_feature(g, a, b) || !flip_keeps_topology(s, c)) return false;
  const Vec3 n = area(s, p, a, b), n1 = area(s, p, a, q), n2 = area(s, q, b, p);
  if (n.dot(n1) <= 0.0 || n.dot(n2) <= 0.0) return false;
  const double height = std::abs(n.dot(s.position(q) - s.position(a)));
  if (height > flat(g) * n.norm()) return false;
  return std::min(quality(s, p, a, q), quality(s, q, b, p)) >
         std::min(quality(s, p, a, b), quality(s, a, q, b)) + gain;
}

/// The facets around a vertex, and the mean of its neighbours.
struct Star {
  std::vector<std::pair<int, int>> rims;
  Vec3 middle = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

Star star_of(const Surface& s, int v) {
  Star star;
  visit_corners(s, v, [&](int c) {
    const int p = s.vertex(next_corner(c)), q = s.vertex(previous_corner(c));
    star.rims.emplace_back(p, q);
    star.middle += s.position(p);
    star.normal += area(s, v, p, q);
  });
  star.middle /= static_cast<double>(star.rims.size());
  star.normal.stableNormalize();
  return star;
}

bool is_flat(const GradeSurface& g, const Star& star, const Vec3& x) {
  return std::all_of(star.rims.begin(), star.rims.end(), [&](const auto& rim) {
    return std::abs(star.normal.dot(g.s.position(rim.first) - x)) <= flat(g);
  });
}

/// The worst quality around a vertex if it were at x; negative if a facet is inverted.
double worst_at(const Surface& s, const Star& star, const Vec3& x) {
  double worst = 1.0;
  for (const auto& [p, q] : star.rims) {
    const double side = area_vector(x, s.position(p), s.position(q)).dot(star.normal);
    const double shape = triangle_quality(x, s.position(p), s.position(q));
    worst = std::min(worst, side > 0.0 ? shape : -1.0);
  }
  return worst;
}

}  // namespace

std::size_t flip(GradeSurface& g) {
  constexpr int most_passes = 20;
  std::size_t turned = 0;
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::size_t before = turned;
    for (int c = 0; c < 3 * g.s.triangle_slots(); ++c)
      if (g.s.triangle_is_alive(c / 3) && should_flip(g, c)) {
        flip_edge(g.s, c);
        ++turned;
      }
    if (turned == before) break;
  }
  return turned;
}

std::size_t relax(GradeSurface& g) {
  std::size_t moved = 0;
  for (int v = 0; v < g.s.vertex_slots(); ++v) {
    if (!g.s.is_alive(v) || g.place[at(v)] != Place::face) continue;
    const Star star = star_of(g.s, v);
    Vec3& x = g.s.stars[at(v)].x;
    if (!is_flat(g, star, x)) continue;
    const Vec3 step = star.middle - x;
    const Vec3 y = x + step - star.normal * star.normal.dot(step);
    if (worst_at(g.s, star, y) <= worst_at(g.s, star, x) + gain) continue;
    x = y;
    ++moved;
  }
  return moved;
}

}  // namespace tdbd::mesh
