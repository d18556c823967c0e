#include "mesh/check/nesting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "mesh/check/self_intersections.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "mesh/surface.hpp"

namespace tdbd::mesh {
namespace {

/// What the tests of two pieces need. Trees are built when they are first used.
struct ClosedPiece {
  Box box;
  double volume = 0.0;  ///< m3, signed
  bool is_closed = false;
  std::optional<TriangleTree> tree;
};

Box box_of(const Facet& f) {
  Box box;
  for (const Vec3& x : {f.a, f.b, f.c}) box.add(x);
  return box;
}

/// Whether two facets intersect; corners at the same position are common.
bool facets_intersect(const Facet& f, const Facet& g) {
  const NamedFacet first{{0, 1, 2}, {f.a, f.b, f.c}};
  NamedFacet second{{3, 4, 5}, {g.a, g.b, g.c}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (second.x[i] == first.x[k]) second.names[i] = first.names[k];
  return intersect(first, second);
}

bool intersects(const TriangleMesh& piece, const TriangleTree& tree) {
  for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
    const auto [a, b, c] = corners(piece, i);
    const Facet facet{a, b, c};
    const Box box = box_of(facet);
    const auto meets = [&](const Box& other) { return other.overlaps(box); };
    const auto is_apart = [&](const Facet& g) {
      return !box_of(g).overlaps(box) || !facets_intersect(facet, g);
    };
    if (!tree.visit(meets, is_apart)) return true;
  }
  return false;
}

bool surrounds(const TriangleMesh& outer, ClosedPiece& o, const TriangleMesh& inner) {
  if (!o.tree) o.tree.emplace(outer);
  const auto [a, b, c] = corners(inner, 0);
  return inside(*o.tree, (a + b + c) / 3.0) && !intersects(inner, *o.tree);
}

Bounds bounds_of(const std::vector<NestedPiece>& all, const NestedPiece& piece) {
  int outside = 0;
  for (const int j : piece.around) outside += all[at(j)].outward ? 1 : -1;
  const int inside = outside + (piece.outward ? 1 : -1);
  return (outside > 0) == (inside > 0) ? Bounds::nothing : Bounds::solid_or_cavity;
}

}  // namespace

std::vector<NestedPiece> nested_pieces(std::vector<TriangleMesh> pieces) {
  std::vector<NestedPiece> all;
  std::vector<ClosedPiece> closed;
  for (TriangleMesh& piece : pieces) {
    TriangleMesh equal{{}, merge_equal_vertices(piece)};
    const double volume = enclosed_volume(piece);
    closed.push_back({bounding_box(piece), volume, open_edges(equal) == 0, {}});
    all.push_back({std::move(piece), {}, static_cast<int>(all.size()), volume > 0.0, {}});
    all.back().bounds = Bounds::unknown;
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j) {
      const Box &box = closed[i].box, &other = closed[j].box;
      if (i == j || !closed[i].is_closed || !closed[j].is_closed || !other.contains(box.lo) ||
          !other.contains(box.hi) || !surrounds(all[j].mesh, closed[j], all[i].mesh))
        continue;
      all[i].around.push_back(static_cast<int>(j));
    }
  const auto size = [&](int i) { return std::abs(closed[at(i)].volume); };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].around.empty())
      all[i].outermost = *std::ranges::max_element(all[i].around, {}, size);
    if (closed[i].is_closed) all[i].bounds = bounds_of(all, all[i]);
  }
  return all;
}

namespace {

/// The group of all facets of a piece, or -1 if they have none or several.
int group_of(const std::vector<int>& group_of_facet, const std::vector<int>& piece) {
  if (group_of_facet.empty()) return -1;
  const int group = group_of_facet[at(piece.front())];
  const bool is_one =
      std::ranges::all_of(piece, [&](int i) { return group_of_facet[at(i)] == group; });
  return is_one ? group : -1;
}

/// Whether the box of any piece contains that of another. Most files have no such pieces. A closed
/// piece has at least four facets.
bool any_may_nest(const TriangleMesh& m, const std::vector<std::vector<int>>& pieces) {
  std::vector<Box> boxes;
  for (const std::vector<int>& piece : pieces) {
    if (pieces.size() == 1 || piece.size() < 4) continue;
    boxes.emplace_back();
    for (const int t : piece)
      for (const Vec3& x : corners(m, at(t))) boxes.back().add(x);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < boxes.size(); ++j)
      if (i != j && boxes[j].contains(boxes[i].lo) && boxes[j].contains(boxes[i].hi)) return true;
  return false;
}

}  // namespace

std::vector<std::vector<int>> facets_of_bodies(const TriangleMesh& m) {
  return facets_of_bodies(m, {});
}

std::vector<std::vector<int>> facets_of_bodies(const TriangleMesh& m,
                                               const std::vector<int>& group_of_facet) {
  std::vector<std::vector<int>> pieces = divided_facets(m), facets(pieces.size());
  if (any_may_nest(m, pieces)) {
    const std::vector<NestedPiece> nested = nested_pieces(submeshes(m, pieces));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const int own = group_of(group_of_facet, pieces[i]);
      const int outer = group_of(group_of_facet, pieces[at(nested[i].outermost)]);
      const bool is_other = own >= 0 && outer >= 0 && own != outer;
      std::vector<int>& body = facets[is_other ? i : at(nested[i].outermost)];
      body.insert(body.end(), pieces[i].begin(), pieces[i].end());
    }
    std::erase_if(facets, [](const std::vector<int>& body) { return body.empty(); });
  } else {
    facets = std::move(pieces);
  }
  for (std::vector<int>& body : facets) std::ranges::sort(body);
  return facets;
}

namespace {

/// The vertices in the order of x, then of their numbers.
std::vector<int> order_of_x(const TriangleMesh& m) {
  std::vector<int> order(m.positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::pair(position(m, a).x(), a) < std::pair(position(m, b).x(), b);
  });
  return order;
}

std::vector<int> first_at_equal_places(const TriangleMesh& m) {
  std::vector<int> order(m.positions.size()), first(m.positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(first.begin(), first.end(), 0);
  const auto key = [&](int v) {
    const Vec3& x = position(m, v);
    return std::tuple(x.x(), x.y(), x.z(), v);
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (position(m, order[i]) == position(m, order[i - 1]))
      first[at(order[i])] = first[at(order[i - 1])];
  return first;
}

/// Pairs of vertices at most `weld` apart, as ranks in `order`, sorted; the smaller rank comes
/// first. The sweep follows an oblique direction, because meshes have many vertices in planes
/// across the axes.
std::vector<std::pair<int, int>> close_pairs(const TriangleMesh& m, const std::vector<int>& order,
                                             double weld) {
  const Vec3 oblique = Vec3(0.61803, 0.70711, 0.34202).normalized();
  constexpr double rounding = 1e-14;
  std::vector<double> along(order.size());
  double farthest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    along[i] = oblique.dot(position(m, order[i]));
    farthest = std::max(farthest, std::abs(along[i]));
  }
  const double reach = weld + rounding * (weld + farthest);
  std::vector<int> ranks(order.size());
  std::iota(ranks.begin(), ranks.end(), 0);
  std::sort(ranks.begin(), ranks.end(),
            [&](int a, int b) { return std::pair(along[at(a)], a) < std::pair(along[at(b)], b); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < ranks.size(); ++i)
    for (std::size_t j = i + 1;
         j < ranks.size() && along[at(ranks[j])] - along[at(ranks[i])] <= reach; ++j) {
      const Vec3 gap = position(m, order[at(ranks[j])]) - position(m, order[at(ranks[i])]);
      if (gap.norm() <= weld) pairs.emplace_back(std::minmax(ranks[i], ranks[j]));
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool lost_a_corner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// The length that nine tenths of the edges exceed.
double short_edge(const TriangleMesh& m) {
  std::vector<double> lengths;
  lengths.reserve(3 * m.triangles.size());
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const auto [a, b, c] = corners(m, i);
    for (const double length : {(b - a).norm(), (c - b).norm(), (a - c).norm()})
      lengths.push_back(length);
  }
  if (lengths.empty()) return 0.0;
  const auto tenth = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 10);
  std::nth_element(lengths.begin(), tenth, lengths.end());
  return *tenth;
}

std::size_t open_edges_of(const std::vector<Triangle>& triangles) {
  std::size_t open = 0;
  for_each_edge(sorted_sides(triangles),
                [&](const Side* first, const Side* last) { open += last - first == 1; });
  return open;
}

}  // namespace

std::vector<int> first_within(const TriangleMesh& m, double weld) {
  if (weld == 0.0) return first_at_equal_places(m);
  const std::vector<int> order = order_of_x(m);
  std::vector<int> first(m.positions.size());
  std::iota(first.begin(), first.end(), 0);
  for (const auto& [a, b] : close_pairs(m, order, weld)) {
    const int from = order[at(a)], to = order[at(b)];
    if (first[at(from)] == from && first[at(to)] == to) first[at(to)] = from;
  }
  return first;
}

std::size_t weld_points(TriangleMesh& m, double weld, std::vector<int>* tags) {
  const std::vector<int> first = first_within(m, weld);
  std::size_t merged = 0;
  for (std::size_t v = 0; v < first.size(); ++v) merged += first[v] != static_cast<int>(v);
  for (Triangle& t : m.triangles)
    for (int& v : t) v = first[at(v)];
  if (merged == 0) return 0;
  std::vector<int> kept, kept_tags;
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    if (lost_a_corner(m.triangles[i])) continue;
    kept.push_back(static_cast<int>(i));
    if (tags != nullptr) kept_tags.push_back((*tags)[i]);
  }
  m = submesh(m, kept);  // without the points that are no longer used
  if (tags != nullptr) *tags = std::move(kept_tags);
  return merged;
}

std::size_t open_edges(const TriangleMesh& m) { return open_edges_of(m.triangles); }

std::optional<WeldHint> weld_hint(const TriangleMesh& m) {
  constexpr double finest = 1e-10, ratio = 10.0, of_edge = 0.25, remaining = 0.1;  // m
  WeldHint best;
  TriangleMesh equal = m;
  weld_points(equal, 0.0);
  best.before = best.after = open_edges(equal);
  const double longest = of_edge * short_edge(m);
  for (double distance = finest; best.after > 0 && distance <= longest; distance *= ratio) {
    TriangleMesh welded = equal;
    if (weld_points(welded, distance) == 0) continue;
    if (const std::size_t open = open_edges(welded); open < best.after) {
      best.after = open;
      best.distance = distance;
    }
  }
  if (best.distance == 0.0 ||
      static_cast<double>(best.after) > remaining * static_cast<double>(best.before))
    return std::nullopt;
  return best;
}

std::string weld_text(const WeldHint& hint) {
  return fmt::format("{:.6g} mm", 1e3 * hint.distance);
}

std::string describe(const WeldHint& hint) {
  return fmt::format(
      "{} edges are open because points that should coincide differ slightly; with --weld '{}' "
      "{} edges are open",
      hint.before, weld_text(hint), hint.after);
}

}  // namespace tdbd::mesh
