#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "mesh/check/check.hpp"
#include "mesh/check/weld.hpp"
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

namespace {

int apex(const TriangleMesh& m, const Side& s) {
  for (const int v : m.triangles[at(s.triangle)])
    if (v != s.lo && v != s.hi) return v;
  return s.lo;
}

/// The facets of an edge, sorted by their angle about it, as seen from lo to hi.
std::vector<Side> around(const TriangleMesh& m, const Side* first, const Side* last) {
  const Vec3 e = (position(m, first->hi) - position(m, first->lo)).stableNormalized();
  const Vec3 u =
      (position(m, apex(m, *first)) - position(m, first->lo)).cross(e).stableNormalized().cross(-e);
  const auto angle = [&](const Side& s) {
    const Vec3 d = position(m, apex(m, s)) - position(m, s.lo);
    return std::atan2(d.dot(e.cross(u)), d.dot(u));
  };
  std::vector<Side> order(first, last);
  std::sort(order.begin(), order.end(), [&](const Side& a, const Side& b) {
    return std::pair(angle(a), a.triangle) < std::pair(angle(b), b.triangle);
  });
  return order;
}

/// Joins the corners of two facets at both ends of their edge into the same fan.
void join(const TriangleMesh& m, DisjointSets& fans, const Side& a, const Side& b) {
  for (const int v : {a.lo, a.hi})
    fans.join(corner_at(m.triangles, a.triangle, v), corner_at(m.triangles, b.triangle, v));
}

/// Pairs the facets of an edge that bound the same solid. The normal of a facet that traverses the
/// edge from lo to hi points counter-clockwise about the edge, so the inside is before that facet,
/// and after a facet that traverses it backwards. The majority of the facets decides between the
/// pairs (0 1) (2 3) ... and (1 2) ... (last 0).
void join_pairs(const TriangleMesh& m, DisjointSets& fans, const std::vector<Side>& order) {
  std::size_t votes = 0;
  for (std::size_t i = 0; i < order.size(); ++i) votes += order[i].forward == (i % 2 == 1);
  const std::size_t from = 2 * votes >= order.size() ? 0 : 1;
  for (std::size_t i = from; i < order.size() + from; i += 2)
    join(m, fans, order[i % order.size()], order[(i + 1) % order.size()]);
}

/// Assigns a new vertex to every fan of corners at a vertex except the first.
std::size_t separate_fans(TriangleMesh& m, DisjointSets& fans) {
  std::vector<int> first_fan(m.positions.size(), -1);
  std::map<int, int> vertex_of_fan;
  std::size_t doubled = 0;
  for (int c = 0; c < static_cast<int>(3 * m.triangles.size()); ++c) {
    int& v = m.triangles[at(c / 3)][at(c % 3)];
    const int fan = fans.find(c);
    if (const auto known = vertex_of_fan.find(fan); known != vertex_of_fan.end()) {
      v = known->second;
      continue;
    }
    if (first_fan[at(v)] >= 0) {
      m.positions.push_back(Vec3(position(m, v)));
      first_fan.push_back(fan);
      v = static_cast<int>(m.positions.size()) - 1;
      ++doubled;
    }
    first_fan[at(v)] = fan;
    vertex_of_fan[fan] = v;
  }
  return doubled;
}

/// Orientation of facets relative to the first facet of their piece, propagated from neighbour to
/// neighbour.
struct Orientation {
  std::vector<std::vector<std::pair<int, bool>>> neighbours;  ///< facet, and whether it agrees
  std::vector<int> sign;                                      ///< -1: flipped; 0: not reached
};

/// Returns the facets of the piece of facet `seed` in the order they are reached; empty if the
/// piece is one-sided.
std::vector<int> reach(Orientation& t, int seed) {
  std::vector<int> piece{seed};
  t.sign[at(seed)] = 1;
  for (std::size_t k = 0; k < piece.size(); ++k)
    for (const auto& [other, agrees] : t.neighbours[at(piece[k])]) {
      const int sign = agrees ? t.sign[at(piece[k])] : -t.sign[at(piece[k])];
      if (t.sign[at(other)] == -sign) return {};
      if (t.sign[at(other)] == 0) piece.push_back(other);
      t.sign[at(other)] = sign;
    }
  return piece;
}

Orientation make_orientation(const TriangleMesh& m) {
  Orientation t{std::vector<std::vector<std::pair<int, bool>>>(m.triangles.size()),
                std::vector<int>(m.triangles.size(), 0)};
  for_each_edge(sorted_sides(m), [&](const Side* first, const Side* last) {
    if (last - first != 2) return;
    const bool agrees = first[0].forward != first[1].forward;
    t.neighbours[at(first[0].triangle)].emplace_back(first[1].triangle, agrees);
    t.neighbours[at(first[1].triangle)].emplace_back(first[0].triangle, agrees);
  });
  return t;
}

}  // namespace

std::size_t split_non_manifold(TriangleMesh& m, std::string& refusal) {
  DisjointSets fans(3 * m.triangles.size());
  for_each_edge(sorted_sides(m), [&](const Side* first, const Side* last) {
    if (last - first == 2) join(m, fans, first[0], first[1]);
    if (last - first < 3) return;
    if ((last - first) % 2 == 0)
      join_pairs(m, fans, around(m, first, last));
    else if (refusal.empty())
      refusal = fmt::format(
          "{} facets meet at an edge of triangle {} at {}: which of them bound the solid is "
          "unknown",
          last - first, first->triangle,
          in_mm(0.5 * (position(m, first->lo) + position(m, first->hi))));
  });
  return refusal.empty() ? separate_fans(m, fans) : 0;
}

std::size_t orient_facets(TriangleMesh& m, std::string& refusal) {
  Orientation t = make_orientation(m);
  std::size_t turned = 0;
  for (int seed = 0; seed < static_cast<int>(m.triangles.size()); ++seed) {
    if (t.sign[at(seed)] != 0) continue;
    const std::vector<int> piece = reach(t, seed);
    if (piece.empty()) {
      refusal = "the surface at " + place_of_triangle(m, seed) + " is one-sided";
      return 0;
    }
    const auto against =
        std::count_if(piece.begin(), piece.end(), [&](int i) { return t.sign[at(i)] < 0; });
    const int minority = 2 * static_cast<std::size_t>(against) > piece.size() ? 1 : -1;
    for (const int i : piece)
      if (t.sign[at(i)] == minority) {
        std::swap(m.triangles[at(i)][1], m.triangles[at(i)][2]);
        ++turned;
      }
  }
  return turned;
}

std::vector<std::vector<int>> boundary_loops(const TriangleMesh& m) {
  std::map<int, int> next;
  for_each_edge(sorted_sides(m), [&](const Side* first, const Side* last) {
    if (last - first == 1)
      next[first->forward ? first->hi : first->lo] = first->forward ? first->lo : first->hi;
  });
  std::vector<std::vector<int>> loops;
  while (!next.empty()) {
    std::vector<int>& loop = loops.emplace_back();
    int v = next.begin()->first;
    for (auto to = next.find(v); to != next.end(); to = next.find(v)) {
      loop.push_back(v);
      v = to->second;
      next.erase(to);
    }
  }
  return loops;
}

namespace {

/// Whether the points of a loop lie in a plane, up to a thousandth of its length.
bool is_flat(const std::vector<Vec3>& loop) {
  constexpr double flat = 1e-3;
  Vec3 normal = Vec3::Zero();
  double length = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3 &x = loop[k], &next = loop[(k + 1) % loop.size()];
    normal += (x - loop[0]).cross(next - loop[0]);
    length += (next - x).norm();
  }
  normal = normal.stableNormalized();
  return std::ranges::all_of(
      loop, [&](const Vec3& x) { return std::abs(normal.dot(x - loop[0])) <= flat * length; });
}

/// Why the patch of a hole is refused: it is large, and its shape is a guess. Empty if it is not.
std::string patch_refusal(const TriangleMesh& m, const std::vector<Vec3>& loop,
                          const std::vector<Triangle>& patch) {
  const double added = area({loop, patch}), present = area(m);
  if (is_flat(loop) || added <= most_filled * present) return "";
  return fmt::format(
      "filling the hole of {} edges at {} adds {:.6g} mm2 to {:.6g} mm2, {:.1f} %; the hole is not "
      "flat, so its shape is unknown; at most {:.0f} % are filled",
      loop.size(), in_mm(loop[0]), 1e6 * added, 1e6 * present, 100.0 * added / present,
      100.0 * most_filled);
}

}  // namespace

std::size_t fill_loops(TriangleMesh& m, const std::vector<std::vector<int>>& loops,
                       std::string& refusal) {
  TriangleMesh filled = m;
  for (const std::vector<int>& loop : loops) {
    std::vector<Vec3> points;
    points.reserve(loop.size());
    for (const int v : loop) points.push_back(position(m, v));
    const std::vector<Triangle> patch = triangulate_loop(points);
    if (patch.size() + 2 != loop.size())
      refusal =
          fmt::format("the hole of {} edges at {} cannot be filled", loop.size(), in_mm(points[0]));
    else
      refusal = patch_refusal(m, points, patch);
    if (!refusal.empty()) return 0;
    for (const Triangle& t : patch)
      filled.triangles.push_back({loop[at(t[0])], loop[at(t[1])], loop[at(t[2])]});
  }
  m = std::move(filled);
  return loops.size();
}

std::size_t fill_holes(TriangleMesh& m, std::string& refusal) {
  return fill_loops(m, boundary_loops(m), refusal);
}

}  // namespace tdbd::mesh
