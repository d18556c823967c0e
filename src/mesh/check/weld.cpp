#include "mesh/check/weld.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "mesh/check/self_intersections.hpp"
#include "mesh/surface.hpp"

namespace tdbd::mesh {
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
