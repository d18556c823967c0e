#include <algorithm>
#include <limits>

#include "mesh/edit.hpp"
#include "mesh/grade/grade_surface.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/inside.hpp"

namespace tdbd::mesh {
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
