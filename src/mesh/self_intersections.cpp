#include "mesh/self_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "mesh/measures.hpp"
#include "mesh/solids.hpp"

namespace tdbd::mesh {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Point point(const TriangleMesh& m, int v) {
  const Vec3& x = m.positions[index(v)];
  return {x.x(), x.y(), x.z()};
}

Kernel::Triangle_3 triangle(const TriangleMesh& m, const Triangle& t) {
  return {point(m, t[0]), point(m, t[1]), point(m, t[2])};
}

Box box_of(const TriangleMesh& m, const Triangle& t) {
  Box box;
  for (const int v : t) box.add(m.positions[index(v)]);
  return box;
}

/// The corners of t, those that are no corner of `other` first.
Triangle own_corners_first(Triangle t, const Triangle& other) {
  std::stable_partition(t.begin(), t.end(), [&](int v) {
    return std::find(other.begin(), other.end(), v) == other.end();
  });
  return t;
}

/// Triangles over one edge overlap when they are in one plane on one side of it.
bool fold_over_edge(const TriangleMesh& m, const Triangle& s, const Triangle& t) {
  const Point a = point(m, s[1]), b = point(m, s[2]), p = point(m, s[0]), q = point(m, t[0]);
  return CGAL::coplanar(a, b, p, q) && CGAL::coplanar_orientation(a, b, p, q) == CGAL::POSITIVE;
}

/// Triangles with one corner in common overlap when the side across from it meets the other.
bool meet_beside_corner(const TriangleMesh& m, const Triangle& s, const Triangle& t) {
  const Kernel::Segment_3 across_s(point(m, s[0]), point(m, s[1]));
  const Kernel::Segment_3 across_t(point(m, t[0]), point(m, t[1]));
  return CGAL::do_intersect(across_s, triangle(m, t)) ||
         CGAL::do_intersect(across_t, triangle(m, s));
}

bool intersect(const TriangleMesh& m, const Triangle& first, const Triangle& second) {
  const Triangle s = own_corners_first(first, second), t = own_corners_first(second, first);
  const auto shared = std::count_if(
      s.begin(), s.end(), [&](int v) { return std::find(t.begin(), t.end(), v) != t.end(); });
  if (shared == 3) return true;
  if (shared == 2) return fold_over_edge(m, s, t);
  if (shared == 1) return meet_beside_corner(m, s, t);
  return CGAL::do_intersect(triangle(m, s), triangle(m, t));
}

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const TriangleMesh& mesh) {
  const TriangleMesh m{mesh.positions, by_first_of_equals(mesh)};
  std::vector<Box> boxes;
  boxes.reserve(m.triangles.size());
  std::vector<int> order;
  for (const Triangle& t : m.triangles) {
    if (!triangle(m, t).is_degenerate()) order.push_back(static_cast<int>(boxes.size()));
    boxes.push_back(box_of(m, t));
  }
  const auto left = [&](int i) { return std::pair(boxes[index(i)].lo.x(), i); };
  std::sort(order.begin(), order.end(), [&](int i, int j) { return left(i) < left(j); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const int a = order[i], b = order[j];
      if (boxes[index(b)].lo.x() > boxes[index(a)].hi.x()) break;
      if (boxes[index(a)].overlaps(boxes[index(b)]) &&
          intersect(m, m.triangles[index(a)], m.triangles[index(b)]))
        pairs.emplace_back(std::minmax(a, b));
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Defect> check_solid(const TriangleMesh& m) {
  std::vector<Defect> defects = check_closed(m);
  if (!defects.empty()) return defects;
  for (const auto& [a, b] : self_intersections(m))
    defects.push_back({Defect::Kind::self_intersection,
                       fmt::format("{} and triangle {}", place_of_triangle(m, a), b)});
  return defects;
}

}  // namespace tdbd::mesh
