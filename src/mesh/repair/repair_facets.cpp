#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "mesh/check/check.hpp"
#include "mesh/check/topology.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair_steps.hpp"

namespace tdbd::mesh {
namespace {

bool same_corners(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

bool is_flat(const TriangleMesh& m, const Triangle& t) {
  return triangle_quality(position(m, t[0]), position(m, t[1]), position(m, t[2])) <
         degenerate_quality;
}

/// Keeps the triangles whose index satisfies `keep`. Returns the number of dropped triangles.
template <class Keep>
std::size_t keep_triangles(TriangleMesh& m, Keep keep) {
  std::vector<Triangle> kept;
  kept.reserve(m.triangles.size());
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    if (keep(i)) kept.push_back(m.triangles[i]);
  const std::size_t gone = m.triangles.size() - kept.size();
  m.triangles = std::move(kept);
  return gone;
}

/// Finds for every vertex the first vertex within `weld`, by a sweep along x.
std::vector<int> first_within(const TriangleMesh& m, double weld) {
  std::vector<int> order(m.positions.size()), first(m.positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(first.begin(), first.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::pair(position(m, a).x(), a) < std::pair(position(m, b).x(), b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (first[at(order[i])] != order[i]) continue;
    for (std::size_t j = i + 1;
         j < order.size() && position(m, order[j]).x() - position(m, order[i]).x() <= weld; ++j)
      if (first[at(order[j])] == order[j] &&
          (position(m, order[j]) - position(m, order[i])).norm() <= weld)
        first[at(order[j])] = order[i];
  }
  return first;
}

/// The corner that faces the longest side.
std::size_t middle_corner(const TriangleMesh& m, const Triangle& t) {
  const auto side = [&](std::size_t k) {
    return (position(m, t[(k + 1) % 3]) - position(m, t[(k + 2) % 3])).squaredNorm();
  };
  return side(0) >= side(1) && side(0) >= side(2) ? 0 : side(1) >= side(2) ? 1 : 2;
}

/// The other triangle at the side that faces corner k of triangle i, if there is exactly one.
std::optional<std::size_t> neighbour(const TriangleMesh& m, std::size_t i, std::size_t k) {
  const int a = m.triangles[i][(k + 1) % 3], b = m.triangles[i][(k + 2) % 3];
  std::optional<std::size_t> found;
  for (std::size_t j = 0; j < m.triangles.size(); ++j) {
    const Triangle& t = m.triangles[j];
    const bool has =
        std::count(t.begin(), t.end(), a) == 1 && std::count(t.begin(), t.end(), b) == 1;
    if (j == i || !has) continue;
    if (found) return {};
    found = j;
  }
  return found;
}

/// Splits the neighbour across the longest side of a triangle with zero area, and drops that
/// triangle.
bool split_neighbour(TriangleMesh& m, std::size_t i) {
  const std::size_t k = middle_corner(m, m.triangles[i]);
  const auto j = neighbour(m, i, k);
  if (!j) return false;
  const int middle = m.triangles[i][k], a = m.triangles[i][(k + 1) % 3],
            b = m.triangles[i][(k + 2) % 3];
  Triangle with_a = m.triangles[*j], with_b = with_a;
  std::replace(with_a.begin(), with_a.end(), b, middle);
  std::replace(with_b.begin(), with_b.end(), a, middle);
  m.triangles[*j] = with_a;
  m.triangles[i] = with_b;
  return true;
}

}  // namespace

std::size_t merge_points(TriangleMesh& m, double weld) {
  const std::vector<int> first = first_within(m, weld);
  std::size_t merged = 0;
  for (std::size_t v = 0; v < first.size(); ++v) merged += first[v] != static_cast<int>(v);
  if (merged == 0) return 0;
  for (Triangle& t : m.triangles)
    for (int& v : t) v = first[at(v)];
  drop_unused_points(m);
  return merged;
}

std::size_t drop_unused_points(TriangleMesh& m) {
  std::vector<int> number(m.positions.size(), -1);
  for (const Triangle& t : m.triangles)
    for (const int v : t) number[at(v)] = 0;
  std::vector<Vec3> used;
  used.reserve(m.positions.size());
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] == 0) {
      number[v] = static_cast<int>(used.size());
      used.push_back(m.positions[v]);
    }
  const std::size_t gone = m.positions.size() - used.size();
  m.positions = std::move(used);
  for (Triangle& t : m.triangles)
    for (int& v : t) v = number[at(v)];
  return gone;
}

std::size_t drop_duplicates(TriangleMesh& m) {
  std::map<Triangle, std::vector<std::size_t>> with_corners;
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    Triangle t = m.triangles[i];
    std::sort(t.begin(), t.end());
    with_corners[t].push_back(i);
  }
  std::vector<char> keep(m.triangles.size(), 0);
  for (const auto& [corners, all] : with_corners) {
    int facing = 0;
    for (const std::size_t i : all) {
      const Triangle& t = m.triangles[i];
      const auto smallest = std::min_element(t.begin(), t.end()) - t.begin();
      facing += t[(static_cast<std::size_t>(smallest) + 1) % 3] == corners[1] ? 1 : -1;
    }
    if (all.size() == 1 || facing != 0) keep[all.front()] = 1;
  }
  return keep_triangles(m, [&](std::size_t i) { return keep[i] != 0; });
}

std::size_t remove_degenerate(TriangleMesh& m) {
  std::size_t removed =
      keep_triangles(m, [&](std::size_t i) { return !same_corners(m.triangles[i]); });
  // A split may reduce the area of the neighbour to zero; at most one pass per triangle is needed.
  for (std::size_t pass = 0, done = 1; done > 0 && pass < m.triangles.size(); ++pass) {
    done = 0;
    for (std::size_t i = 0; i < m.triangles.size(); ++i)
      if (is_flat(m, m.triangles[i]) && split_neighbour(m, i)) {
        done = 1;
        ++removed;
        break;
      }
  }
  return removed;
}

std::size_t drop_sheets(TriangleMesh& m) {
  const std::vector<Side> sides = sorted_sides(m);
  DisjointSets sheets(m.triangles.size());
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    if (last - first == 2) sheets.join(first[0].triangle, first[1].triangle);
  });
  std::vector<char> is_open(m.triangles.size(), 0), stands(m.triangles.size(), 0);
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    for (const Side* s = first; s < last; ++s) {
      const std::size_t sheet = at(sheets.find(s->triangle));
      if (last - first == 1) is_open[sheet] = 1;
      if (last - first > 2) stands[sheet] = 1;
    }
  });
  return keep_triangles(m, [&](std::size_t i) {
    const std::size_t sheet = at(sheets.find(static_cast<int>(i)));
    return is_open[sheet] == 0 || stands[sheet] == 0;
  });
}

}  // namespace tdbd::mesh
