#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/edit.hpp"
#include "mesh/grade/grade.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"

namespace tdbd::mesh {
namespace {

constexpr double too_long = 4.0 / 3.0, too_short = 4.0 / 5.0;
constexpr double poor = 0.3;       ///< a collapse must not create a facet of lower quality
constexpr double same_side = 0.7;  ///< cosine of the largest rotation of a facet in a collapse

/// An edge given by its vertices, and its length divided by the target.
struct RatedEdge {
  double ratio = 0.0;
  int a = 0, b = 0;
};

double ratio(const GradeSurface& g, int a, int b) {
  const Vec3 &x = g.s.position(a), &y = g.s.position(b);
  return (y - x).norm() / target(g, 0.5 * (x + y));
}

/// The edges whose ratio satisfies `is_wanted`, in the order of their corners.
template <class Wanted>
std::vector<RatedEdge> edges(const GradeSurface& g, Wanted is_wanted) {
  std::vector<RatedEdge> found;
  for (int c = 0; c < 3 * g.s.triangle_slots(); ++c) {
    if (!g.s.triangle_is_alive(c / 3) || g.s.opposite_of(c) < c) continue;
    const auto [a, b] = std::minmax({g.s.vertex(next_corner(c)), g.s.vertex(previous_corner(c))});
    if (const double r = ratio(g, a, b); is_wanted(r)) found.push_back({r, a, b});
  }
  return found;
}

void halve(GradeSurface& g, int c) {
  const int a = g.s.vertex(next_corner(c)), b = g.s.vertex(previous_corner(c));
  const Vec3 middle = 0.5 * (g.s.position(a) + g.s.position(b));
  const int m = split_edge(g.s, c, middle);
  g.place.resize(std::max(g.place.size(), at(m) + 1), Place::face);
  g.moved.resize(g.place.size(), 0.0);
  g.moved[at(m)] = std::max(g.moved[at(a)], g.moved[at(b)]);
  g.place[at(m)] = Place::face;
  if (g.features.erase(std::minmax(a, b)) == 0) return;
  g.place[at(m)] = Place::crease;
  g.features.insert(std::minmax(a, m));
  g.features.insert(std::minmax(m, b));
}

/// The neighbour of crease vertex v along its feature that is not `from`.
int along(const GradeSurface& g, int v, int from) {
  int other = -1;
  visit_corners(g.s, v, [&](int c) {
    for (const int w : {g.s.vertex(next_corner(c)), g.s.vertex(previous_corner(c))})
      if (w != from && is_feature(g, v, w)) other = w;
  });
  return other;
}

/// The collapse of vertex `gone` into vertex `keep`.
struct Collapse {
  int gone = 0, keep = 0;
  int next_on_feature = -1;  ///< for a crease vertex: its neighbour on the other side
  std::vector<Facet> old_facets, new_facets;
  double moved = 0.0;
};

Collapse prepare(const GradeSurface& g, int gone, int keep) {
  Collapse k{gone, keep, -1, {}, {}, 0.0};
  visit_corners(g.s, gone, [&](int c) {
    const int p = g.s.vertex(next_corner(c)), q = g.s.vertex(previous_corner(c));
    if (p == keep || q == keep) return;
    k.old_facets.push_back({g.s.position(gone), g.s.position(p), g.s.position(q)});
    k.new_facets.push_back({g.s.position(keep), g.s.position(p), g.s.position(q)});
  });
  if (g.place[at(gone)] == Place::crease) k.next_on_feature = along(g, gone, keep);
  return k;
}

double quality(const Facet& f) { return triangle_quality(f.a, f.b, f.c); }

/// Whether no facet is inverted or gets a quality that is too low, and no edge gets too long for
/// the target.
bool keeps_shape(const GradeSurface& g, const Collapse& k) {
  double worst = poor;
  for (const Facet& f : k.old_facets) worst = std::min(worst, quality(f));
  for (std::size_t i = 0; i < k.new_facets.size(); ++i) {
    const Facet &f = k.new_facets[i], &old = k.old_facets[i];
    const Vec3 n = area_vector(f.a, f.b, f.c), n_old = area_vector(old.a, old.b, old.c);
    if (n.dot(n_old) <= same_side * n.norm() * n_old.norm() || quality(f) < worst) return false;
    for (const Vec3& x : {f.b, f.c})
      if ((x - f.a).norm() > too_long * target(g, 0.5 * (x + f.a))) return false;
  }
  return true;
}

/// Whether the surface stays within the deviation. Two distances are checked: that from the removed
/// vertex to the new facets, added to how far it had moved before, and that from points of the new
/// facets to the given mesh.
bool stays_within_deviation(const GradeSurface& g, Collapse& k) {
  const double most = g.options.deviation + g.rounding;
  const Vec3& x = g.s.position(k.gone);
  double nearest2 = std::numeric_limits<double>::infinity();
  for (const Facet& f : k.new_facets) nearest2 = std::min(nearest2, squared_distance(f, x));
  if (k.next_on_feature >= 0) {
    const Vec3 &a = g.s.position(k.keep), &b = g.s.position(k.next_on_feature);
    nearest2 = std::max(nearest2, squared_distance(Facet{a, b, b}, x));
  }
  k.moved = std::max(g.moved[at(k.keep)], g.moved[at(k.gone)] + std::sqrt(nearest2));
  if (k.moved > most) return false;
  for (const Facet& f : k.new_facets)
    for (const Vec3& y : {Vec3((f.a + f.b + f.c) / 3.0), Vec3(0.5 * (f.a + f.b)),
                          Vec3(0.5 * (f.b + f.c)), Vec3(0.5 * (f.c + f.a))})
      if (!is_near(g.original, y, most)) return false;
  return true;
}

bool may_collapse_vertex(const GradeSurface& g, int gone, int keep) {
  const Place place = g.place[at(gone)];
  return place == Place::face || (place == Place::crease && is_feature(g, gone, keep));
}

bool try_collapse(GradeSurface& g, int gone, int keep) {
  if (!may_collapse_vertex(g, gone, keep)) return false;
  const int c = corner_facing(g.s, keep, gone);
  if (c < 0 || !collapse_keeps_topology(g.s, c)) return false;
  Collapse k = prepare(g, gone, keep);
  if (g.place[at(gone)] == Place::crease &&
      (k.next_on_feature < 0 || is_feature(g, keep, k.next_on_feature)))
    return false;
  if (!keeps_shape(g, k) || !stays_within_deviation(g, k)) return false;
  collapse_edge(g.s, c, Vec3(g.s.position(keep)));
  g.moved[at(keep)] = k.moved;
  if (k.next_on_feature < 0) return true;
  g.features.erase(std::minmax(gone, keep));
  g.features.erase(std::minmax(gone, k.next_on_feature));
  g.features.insert(std::minmax(keep, k.next_on_feature));
  return true;
}

}  // namespace

std::size_t refine(GradeSurface& g) {
  std::size_t halved = 0;
  for (std::size_t before = halved + 1; halved != before;) {
    before = halved;
    std::vector<RatedEdge> longs = edges(g, [](double r) { return r > too_long; });
    std::stable_sort(longs.begin(), longs.end(),
                     [](const RatedEdge& x, const RatedEdge& y) { return x.ratio > y.ratio; });
    for (const RatedEdge& e : longs) {
      const int c = corner_facing(g.s, e.a, e.b);
      halve(g, c);
      ++halved;
    }
  }
  return halved;
}

std::size_t coarsen(GradeSurface& g) {
  std::vector<RatedEdge> shorts = edges(g, [](double r) { return r < too_short; });
  std::stable_sort(shorts.begin(), shorts.end(),
                   [](const RatedEdge& x, const RatedEdge& y) { return x.ratio < y.ratio; });
  std::size_t collapsed = 0;
  for (const RatedEdge& e : shorts) {
    if (!g.s.is_alive(e.a) || !g.s.is_alive(e.b) || corner_facing(g.s, e.a, e.b) < 0) continue;
    collapsed += try_collapse(g, e.a, e.b) || try_collapse(g, e.b, e.a);
  }
  return collapsed;
}

}  // namespace tdbd::mesh
