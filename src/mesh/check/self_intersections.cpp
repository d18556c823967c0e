#include "mesh/check/self_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "mesh/check/nesting.hpp"
#include "mesh/measures.hpp"

namespace tdbd::mesh {
namespace {

/// Tracks the edges of the facets added so far, and whether these facets form a closed surface.
class Closing {
 public:
  void add(const Triangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = t[k], to = t[(k + 1) % 3];
      Uses& uses = uses_[std::minmax({from, to})];
      unfinished_ -= is_unfinished(uses);
      ++(from < to ? uses.forward : uses.backward);
      unfinished_ += is_unfinished(uses);
    }
  }
  bool is_closed() const { return unfinished_ == 0; }

 private:
  struct Uses {
    int forward = 0, backward = 0;
  };
  static int is_unfinished(const Uses& u) {
    return u.forward + u.backward > 0 && (u.forward != 1 || u.backward != 1) ? 1 : 0;
  }
  std::map<std::pair<int, int>, Uses> uses_;
  int unfinished_ = 0;
};

/// Groups facet numbers into runs. A run ends where its facets form a closed surface.
std::vector<std::vector<int>> closing_runs(const std::vector<Triangle>& facets) {
  std::vector<std::vector<int>> runs;
  Closing closing;
  for (int i = 0; i < static_cast<int>(facets.size()); ++i) {
    if (closing.is_closed()) {
      closing = Closing();
      runs.emplace_back();
    }
    runs.back().push_back(i);
    closing.add(facets[at(i)]);
  }
  return runs;
}

}  // namespace

TriangleMesh submesh(const TriangleMesh& m, const std::vector<int>& triangles) {
  std::vector<int> used;
  for (const int i : triangles)
    used.insert(used.end(), m.triangles[at(i)].begin(), m.triangles[at(i)].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  TriangleMesh part;
  part.positions.reserve(used.size());
  for (const int v : used) part.positions.push_back(m.positions[at(v)]);
  part.triangles.reserve(triangles.size());
  for (const int i : triangles) {
    Triangle t = m.triangles[at(i)];
    for (int& v : t)
      v = static_cast<int>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    part.triangles.push_back(t);
  }
  return part;
}

std::vector<Triangle> merge_equal_vertices(const TriangleMesh& m) {
  std::map<std::array<double, 3>, int> first;
  std::vector<int> of_vertex;
  of_vertex.reserve(m.positions.size());
  for (const Vec3& x : m.positions)
    of_vertex.push_back(
        first.try_emplace({x.x(), x.y(), x.z()}, static_cast<int>(of_vertex.size())).first->second);
  std::vector<Triangle> triangles = m.triangles;
  for (Triangle& t : triangles)
    for (int& v : t) v = of_vertex[at(v)];
  return triangles;
}

std::vector<std::vector<int>> divided_facets(const TriangleMesh& m) {
  const std::vector<Triangle> facets = merge_equal_vertices(m);
  std::vector<std::vector<int>> pieces;
  for (const std::vector<int>& run : closing_runs(facets)) {
    std::vector<Triangle> of_run;
    of_run.reserve(run.size());
    for (const int i : run) of_run.push_back(facets[at(i)]);
    for (std::vector<int>& piece : connected_pieces(of_run)) {
      for (int& i : piece) i = run[at(i)];
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

std::vector<TriangleMesh> divide(const TriangleMesh& m) { return submeshes(m, divided_facets(m)); }

std::vector<TriangleMesh> submeshes(const TriangleMesh& m,
                                    const std::vector<std::vector<int>>& pieces) {
  std::vector<TriangleMesh> meshes;
  meshes.reserve(pieces.size());
  for (const std::vector<int>& piece : pieces) meshes.push_back(submesh(m, piece));
  return meshes;
}

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Point point(const NamedFacet& f, std::size_t corner) {
  const Vec3& x = f.x[corner];
  return {x.x(), x.y(), x.z()};
}

Kernel::Triangle_3 triangle(const NamedFacet& f) { return {point(f, 0), point(f, 1), point(f, 2)}; }

NamedFacet facet(const TriangleMesh& m, const Triangle& t) {
  return {t, {m.positions[at(t[0])], m.positions[at(t[1])], m.positions[at(t[2])]}};
}

Box box_of(const TriangleMesh& m, const Triangle& t) {
  Box box;
  for (const int v : t) box.add(m.positions[at(v)]);
  return box;
}

bool has(const Triangle& t, int name) { return std::find(t.begin(), t.end(), name) != t.end(); }

/// Reorders the corners of f: those not shared with `other` come first.
NamedFacet own_corners_first(const NamedFacet& f, const Triangle& other) {
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t i) { return !has(other, f.names[i]); });
  NamedFacet sorted;
  for (std::size_t i = 0; i < 3; ++i) {
    sorted.names[i] = f.names[order[i]];
    sorted.x[i] = f.x[order[i]];
  }
  return sorted;
}

/// Tests two triangles that share an edge: they overlap if they are coplanar and lie on the same
/// side of it.
bool fold_over_edge(const NamedFacet& s, const NamedFacet& t) {
  const Point a = point(s, 1), b = point(s, 2), p = point(s, 0), q = point(t, 0);
  return CGAL::coplanar(a, b, p, q) && CGAL::coplanar_orientation(a, b, p, q) == CGAL::POSITIVE;
}

/// Tests two triangles that share one corner: they overlap if the side opposite to it intersects
/// the other triangle.
bool meet_beside_corner(const NamedFacet& s, const NamedFacet& t) {
  const Kernel::Segment_3 across_s(point(s, 0), point(s, 1)), across_t(point(t, 0), point(t, 1));
  return CGAL::do_intersect(across_s, triangle(t)) || CGAL::do_intersect(across_t, triangle(s));
}

/// Requires triangles with non-zero area.
bool solid_facets_intersect(const NamedFacet& first, const NamedFacet& second) {
  const NamedFacet s = own_corners_first(first, second.names),
                   t = own_corners_first(second, first.names);
  const auto shared =
      std::count_if(s.names.begin(), s.names.end(), [&](int v) { return has(t.names, v); });
  if (shared == 3) return true;
  if (shared == 2) return fold_over_edge(s, t);
  if (shared == 1) return meet_beside_corner(s, t);
  return CGAL::do_intersect(triangle(s), triangle(t));
}

}  // namespace

bool intersect(const NamedFacet& first, const NamedFacet& second) {
  return !triangle(first).is_degenerate() && !triangle(second).is_degenerate() &&
         solid_facets_intersect(first, second);
}

std::vector<std::pair<int, int>> self_intersections(const TriangleMesh& mesh) {
  const TriangleMesh m{mesh.positions, merge_equal_vertices(mesh)};
  std::vector<Box> boxes;
  boxes.reserve(m.triangles.size());
  std::vector<int> order;
  for (const Triangle& t : m.triangles) {
    if (!triangle(facet(m, t)).is_degenerate()) order.push_back(static_cast<int>(boxes.size()));
    boxes.push_back(box_of(m, t));
  }
  const auto left = [&](int i) { return std::pair(boxes[at(i)].lo.x(), i); };
  std::sort(order.begin(), order.end(), [&](int i, int j) { return left(i) < left(j); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const int a = order[i], b = order[j];
      if (boxes[at(b)].lo.x() > boxes[at(a)].hi.x()) break;
      if (boxes[at(a)].overlaps(boxes[at(b)]) &&
          solid_facets_intersect(facet(m, m.triangles[at(a)]), facet(m, m.triangles[at(b)])))
        pairs.emplace_back(std::minmax(a, b));
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

namespace {

/// Pieces that bound nothing.
void find_bad_nesting(const TriangleMesh& m, std::vector<Defect>& found) {
  const auto pieces = connected_pieces(m.triangles);
  if (pieces.size() == 1) return;
  const std::vector<NestedPiece> nested = nested_pieces(submeshes(m, pieces));
  for (std::size_t i = 0; i < nested.size(); ++i)
    if (nested[i].bounds == Bounds::nothing)
      found.push_back(
          {Defect::Kind::bad_nesting,
           fmt::format("{} facets with {} {}, {:.6g} mm3, {}: a cavity must face inward, a body "
                       "outward, and a body inside another counts twice",
                       pieces[i].size(), place_of_triangle(m, pieces[i].front()),
                       nested[i].outward ? "face outward" : "face inward",
                       1e9 * std::abs(enclosed_volume(nested[i].mesh)),
                       nested[i].around.empty() ? "in no other piece" : "inside another piece")});
}

}  // namespace

std::vector<Defect> check_solid(const TriangleMesh& m) {
  std::vector<Defect> defects = check_closed(m);
  if (!defects.empty()) return defects;
  for (const auto& [a, b] : self_intersections(m))
    defects.push_back({Defect::Kind::self_intersection,
                       fmt::format("{} and triangle {}", place_of_triangle(m, a), b)});
  if (defects.empty()) find_bad_nesting(m, defects);
  return defects;
}

}  // namespace tdbd::mesh
