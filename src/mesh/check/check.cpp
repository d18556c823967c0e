#include "mesh/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "mesh/measures.hpp"

namespace tdbd::mesh {
namespace {

/// Joins corners of a vertex into one fan if their triangles share an edge at that vertex.
DisjointSets fans_of_corners(const TriangleMesh& m, const std::vector<Side>& sides) {
  DisjointSets fans(3 * m.triangles.size());
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    for (const Side* s = first + 1; s < last; ++s)
      for (const int v : {s->lo, s->hi})
        fans.join(corner_at(m.triangles, first->triangle, v),
                  corner_at(m.triangles, s->triangle, v));
  });
  return fans;
}

/// Counts the sets whose representative satisfies `use`.
template <class Use>
int count_sets(DisjointSets& sets, int n, Use use) {
  int count = 0;
  for (int i = 0; i < n; ++i) count += use(i) && sets.find(i) == i;
  return count;
}

}  // namespace

DisjointSets::DisjointSets(std::size_t n) : parent_(n) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

int DisjointSets::find(int i) {
  const auto parent = [this](int k) -> int& { return parent_[at(k)]; };
  while (parent(i) != i) i = parent(i) = parent(parent(i));
  return i;
}

void DisjointSets::join(int i, int j) {
  const auto [lo, hi] = std::minmax({find(i), find(j)});
  parent_[at(hi)] = lo;
}

std::vector<std::vector<int>> connected_pieces(const std::vector<Triangle>& triangles) {
  DisjointSets sets(triangles.size());
  for_each_edge(sorted_sides(triangles), [&](const Side* first, const Side* last) {
    for (const Side* s = first; s < last; ++s) sets.join(first->triangle, s->triangle);
  });
  std::map<int, std::vector<int>> of_set;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) of_set[sets.find(t)].push_back(t);
  std::vector<std::vector<int>> pieces;
  pieces.reserve(of_set.size());
  for (auto& [first, piece] : of_set) pieces.push_back(std::move(piece));
  return pieces;
}

std::vector<int> fan_counts(const TriangleMesh& m, const std::vector<Side>& sides) {
  DisjointSets fans = fans_of_corners(m, sides);
  std::vector<int> count(m.positions.size(), 0);
  for (int c = 0; c < static_cast<int>(3 * m.triangles.size()); ++c)
    if (fans.find(c) == c) ++count[at(m.triangles[at(c / 3)][at(c % 3)])];
  return count;
}

Topology topology(const TriangleMesh& m, const std::vector<Side>& sides) {
  const int n = static_cast<int>(m.positions.size());
  DisjointSets pieces(m.positions.size()), loops(m.positions.size());
  std::vector<char> on_boundary(m.positions.size(), 0);
  int edges = 0;
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    ++edges;
    pieces.join(first->lo, first->hi);
    if (last - first > 1) return;
    loops.join(first->lo, first->hi);
    on_boundary[at(first->lo)] = on_boundary[at(first->hi)] = 1;
  });
  return {count_sets(pieces, n, [](int) { return true; }),
          count_sets(loops, n, [&](int v) { return on_boundary[at(v)] != 0; }),
          n - edges + static_cast<int>(m.triangles.size())};
}

namespace {

using Kind = Defect::Kind;
using Defects = std::vector<Defect>;

std::string at_vertex(const TriangleMesh& m, int v) {
  return fmt::format("vertex {} at {}", v, in_mm(m.positions[at(v)]));
}

std::string at_edge(const TriangleMesh& m, const Side& s) {
  return fmt::format("edge {}-{} of triangle {}, from {} to {}", s.lo, s.hi, s.triangle,
                     in_mm(m.positions[at(s.lo)]), in_mm(m.positions[at(s.hi)]));
}

/// Corners whose vertex index is out of range. If there are any, no other check is possible.
Defects indices_out_of_range(const TriangleMesh& m) {
  Defects found;
  const int n = static_cast<int>(m.positions.size());
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    for (const int v : m.triangles[i])
      if (v < 0 || v >= n)
        found.push_back(
            {Kind::index_out_of_range, fmt::format("triangle {} names vertex {} of {}", i, v, n)});
  return found;
}

void find_bad_numbers(const TriangleMesh& m, Defects& found) {
  for (std::size_t v = 0; v < m.positions.size(); ++v)
    if (!m.positions[v].allFinite())
      found.push_back({Kind::not_finite, at_vertex(m, static_cast<int>(v))});
}

void find_degenerate_triangles(const TriangleMesh& m, Defects& found) {
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const auto [a, b, c] = corners(m, i);
    if (triangle_quality(a, b, c) < degenerate_quality)
      found.push_back({Kind::degenerate_triangle, place_of_triangle(m, static_cast<int>(i))});
  }
}

void find_bad_edges(const TriangleMesh& m, const std::vector<Side>& sides, Defects& found) {
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    if (last - first > 2)
      found.push_back({Kind::non_manifold_edge, at_edge(m, *first)});
    else if (last - first == 2 && first[0].forward == first[1].forward)
      found.push_back({Kind::flipped_triangle, at_edge(m, first[1])});
  });
}

void find_open_edges(const TriangleMesh& m, const std::vector<Side>& sides, Defects& found) {
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    if (last - first == 1) found.push_back({Kind::hole, at_edge(m, *first)});
  });
}

void find_bad_vertices(const TriangleMesh& m, const std::vector<int>& fans, Defects& found) {
  for (std::size_t v = 0; v < fans.size(); ++v)
    if (fans[v] > 1)
      found.push_back(
          {Kind::non_manifold_vertex,
           fmt::format("{}, in {} fans of triangles", at_vertex(m, static_cast<int>(v)), fans[v])});
}

void find_isolated_vertices(const TriangleMesh& m, const std::vector<int>& fans, Defects& found) {
  for (std::size_t v = 0; v < fans.size(); ++v)
    if (fans[v] == 0) found.push_back({Kind::isolated_vertex, at_vertex(m, static_cast<int>(v))});
}

/// Requires manifold edges and vertices.
void find_wrong_topology(const TriangleMesh& m, const std::vector<Side>& sides, Defects& found) {
  const Topology t = topology(m, sides);
  if (t.pieces != 1) found.push_back({Kind::several_pieces, fmt::format("{} pieces", t.pieces)});
  if (t.loops != 1)
    found.push_back({Kind::boundary_loops, fmt::format("found {}, expected 1", t.loops)});
  if (t.euler != 1)
    found.push_back({Kind::euler_characteristic, fmt::format("V - E + F = {}, not 1", t.euler)});
}

/// Finds the defects that both checks look for. Fills `sides` and `fans` only if all indices are in
/// range.
Defects find_common(const TriangleMesh& m, std::vector<Side>& sides, std::vector<int>& fans) {
  if (m.triangles.empty()) return {{Kind::empty, "no triangles"}};
  Defects found = indices_out_of_range(m);
  if (!found.empty()) return found;
  find_bad_numbers(m, found);
  find_degenerate_triangles(m, found);
  sides = sorted_sides(m);
  fans = fan_counts(m, sides);
  find_bad_edges(m, sides, found);
  find_bad_vertices(m, fans, found);
  return found;
}

}  // namespace

std::string in_mm(const Vec3& x) {
  return fmt::format("({:.4f}, {:.4f}, {:.4f}) mm", 1e3 * x.x(), 1e3 * x.y(), 1e3 * x.z());
}

std::string place_of_triangle(const TriangleMesh& m, int i) {
  const auto [a, b, c] = corners(m, at(i));
  return fmt::format("triangle {} at {}", i, in_mm((a + b + c) / 3.0));
}

std::vector<Defect> check_closed(const TriangleMesh& m) {
  std::vector<Side> sides;
  std::vector<int> fans;
  Defects found = find_common(m, sides, fans);
  find_open_edges(m, sides, found);
  if (found.empty() && enclosed_volume(m) <= 0.0)
    found.push_back(
        {Kind::inside_out, fmt::format("enclosed volume {} mm3", 1e9 * enclosed_volume(m))});
  return found;
}

std::vector<Defect> check_surface(const TriangleMesh& m) {
  std::vector<Side> sides;
  std::vector<int> fans;
  Defects found = find_common(m, sides, fans);
  find_isolated_vertices(m, fans, found);
  if (found.empty()) find_wrong_topology(m, sides, found);
  return found;
}

std::string name(Defect::Kind kind) {
  switch (kind) {
    case Kind::index_out_of_range:
      return "index out of range";
    case Kind::not_finite:
      return "coordinate not finite";
    case Kind::degenerate_triangle:
      return "degenerate triangle";
    case Kind::hole:
      return "hole";
    case Kind::flipped_triangle:
      return "flipped triangle";
    case Kind::non_manifold_edge:
      return "edge of more than two triangles";
    case Kind::non_manifold_vertex:
      return "non-manifold vertex";
    case Kind::isolated_vertex:
      return "vertex of no triangle";
    case Kind::several_pieces:
      return "not one connected surface";
    case Kind::boundary_loops:
      return "wrong number of boundary loops";
    case Kind::euler_characteristic:
      return "not a disk";
    case Kind::inside_out:
      return "inside out";
    case Kind::empty:
      return "empty mesh";
    case Kind::self_intersection:
      return "self-intersection";
    case Kind::bad_nesting:
      return "piece that bounds nothing";
  }
  return "unknown defect";
}

std::string describe(const std::vector<Defect>& defects, std::size_t max) {
  std::string text;
  for (std::size_t i = 0; i < std::min(max, defects.size()); ++i)
    text += fmt::format("{}: {}\n", name(defects[i].kind), defects[i].where);
  if (defects.size() > max) text += fmt::format("and {} more\n", defects.size() - max);
  return text;
}

std::string summarize(const std::vector<Defect>& defects) {
  std::map<Kind, std::pair<std::size_t, const Defect*>> kinds;
  for (const Defect& d : defects) {
    auto& [count, first] = kinds.try_emplace(d.kind, 0, &d).first->second;
    ++count;
  }
  std::string text;
  for (const auto& [kind, found] : kinds)
    text += found.first == 1 ? fmt::format("{}: {}\n", name(kind), found.second->where)
                             : fmt::format("{}: {} times, first {}\n", name(kind), found.first,
                                           found.second->where);
  return text;
}

}  // namespace tdbd::mesh
