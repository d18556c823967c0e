#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mesh/check/check.hpp"
#include "mesh/check/check_edges.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "mesh/search/inside.hpp"

namespace tdbd::mesh {
namespace {

const Vec3& position(const TriangleMesh& m, int v) { return m.positions[at(v)]; }

/// Number of the corner of triangle t at vertex v.
int corner(const TriangleMesh& m, int t, int v) {
  const Triangle& c = m.triangles[at(t)];
  return 3 * t + static_cast<int>(std::find(c.begin(), c.end(), v) - c.begin());
}

int apex(const TriangleMesh& m, const Side& s) {
  for (const int v : m.triangles[at(s.triangle)])
    if (v != s.lo && v != s.hi) return v;
  return s.lo;
}

/// The facets of an edge in the order of their angle about it, from lo to hi.
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

/// Joins the corners of two facets at both ends of their edge.
void join(const TriangleMesh& m, DisjointSets& fans, const Side& a, const Side& b) {
  for (const int v : {a.lo, a.hi}) fans.join(corner(m, a.triangle, v), corner(m, b.triangle, v));
}

/// The normal of a facet that runs from lo to hi points counter-clockwise about that edge: the
/// inside comes before it, and after one that runs back. Pairs (0 1) (2 3) ... or (1 2) ...
/// (last 0), as most facets say.
void join_pairs(const TriangleMesh& m, DisjointSets& fans, const std::vector<Side>& order) {
  std::size_t votes = 0;
  for (std::size_t i = 0; i < order.size(); ++i) votes += order[i].forward == (i % 2 == 1);
  const std::size_t from = 2 * votes >= order.size() ? 0 : 1;
  for (std::size_t i = from; i < order.size() + from; i += 2)
    join(m, fans, order[i % order.size()], order[(i + 1) % order.size()]);
}

std::string edge_text(const TriangleMesh& m, const Side& s) {
  const Vec3 x = 0.5e3 * (position(m, s.lo) + position(m, s.hi));
  return fmt::format("triangle {} at ({:.4f}, {:.4f}, {:.4f}) mm", s.triangle, x.x(), x.y(), x.z());
}

/// Gives every fan of corners but the first a vertex of its own.
std::size_t part_fans(TriangleMesh& m, DisjointSets& fans) {
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

/// Facets that are to be turned: found from neighbour to neighbour, seeds first.
struct Turning {
  std::vector<std::vector<std::pair<int, bool>>> neighbours;  ///< facet, agrees
  std::vector<int> sign;                                      ///< 0: not reached
};

/// Reaches the piece of facet `seed`; its facets in the order reached, empty if it has one side.
std::vector<int> reach(Turning& t, int seed) {
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

Turning make_turning(const TriangleMesh& m) {
  Turning t{std::vector<std::vector<std::pair<int, bool>>>(m.triangles.size()),
            std::vector<int>(m.triangles.size(), 0)};
  for_each_edge(sorted_sides(m), [&](const Side* first, const Side* last) {
    if (last - first != 2) return;
    const bool agrees = first[0].forward != first[1].forward;
    t.neighbours[at(first[0].triangle)].emplace_back(first[1].triangle, agrees);
    t.neighbours[at(first[1].triangle)].emplace_back(first[0].triangle, agrees);
  });
  return t;
}

/// Boundary loops in the sense of the facets that will fill them: against the open edges.
std::vector<std::vector<int>> loops_of(const TriangleMesh& m) {
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

/// Facets of each piece that hangs together by edges.
std::vector<std::vector<int>> pieces_of(const TriangleMesh& m) {
  DisjointSets sets(m.triangles.size());
  for_each_edge(sorted_sides(m), [&](const Side* first, const Side* last) {
    for (const Side* s = first; s < last; ++s) sets.join(first->triangle, s->triangle);
  });
  std::map<int, std::vector<int>> of_set;
  for (int t = 0; t < static_cast<int>(m.triangles.size()); ++t) of_set[sets.find(t)].push_back(t);
  std::vector<std::vector<int>> pieces;
  pieces.reserve(of_set.size());
  for (auto& [first, facets] : of_set) pieces.push_back(std::move(facets));
  return pieces;
}

Vec3 centre(const TriangleMesh& m, int t) {
  const Triangle& c = m.triangles[at(t)];
  return (position(m, c[0]) + position(m, c[1]) + position(m, c[2])) / 3.0;
}

}  // namespace

std::size_t part_non_manifold(TriangleMesh& m, std::string& refusal) {
  DisjointSets fans(3 * m.triangles.size());
  for_each_edge(sorted_sides(m), [&](const Side* first, const Side* last) {
    if (last - first == 2) join(m, fans, first[0], first[1]);
    if (last - first < 3) return;
    if ((last - first) % 2 == 0)
      join_pairs(m, fans, around(m, first, last));
    else if (refusal.empty())
      refusal = fmt::format("{} facets meet at an edge of {}: which of them bound the solid?",
                            last - first, edge_text(m, *first));
  });
  return refusal.empty() ? part_fans(m, fans) : 0;
}

std::size_t turn_facets(TriangleMesh& m, std::string& refusal) {
  Turning t = make_turning(m);
  std::size_t turned = 0;
  for (int seed = 0; seed < static_cast<int>(m.triangles.size()); ++seed) {
    if (t.sign[at(seed)] != 0) continue;
    const std::vector<int> piece = reach(t, seed);
    if (piece.empty()) {
      refusal = "the surface at " + place_of_triangle(m, seed) + " has one side only";
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

std::size_t turn_pieces(TriangleMesh& m) {
  const std::vector<std::vector<int>> pieces = pieces_of(m);
  std::vector<TriangleMesh> meshes;
  std::vector<TriangleTree> trees;
  meshes.reserve(pieces.size());
  trees.reserve(pieces.size());
  for (const std::vector<int>& piece : pieces) {
    meshes.push_back(submesh(m, piece));
    trees.emplace_back(meshes.back());
  }
  std::size_t turned = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vec3 x = centre(m, pieces[i].front());
    bool outwards = true;
    for (std::size_t j = 0; j < pieces.size(); ++j)
      if (j != i && trees[j].box().contains(x) && inside(trees[j], x)) outwards = !outwards;
    if ((enclosed_volume(meshes[i]) > 0.0) == outwards) continue;
    for (const int t : pieces[i]) std::swap(m.triangles[at(t)][1], m.triangles[at(t)][2]);
    turned += pieces[i].size();
  }
  return turned;
}

std::size_t fill_holes(TriangleMesh& m, std::string& refusal) {
  const std::vector<std::vector<int>> loops = loops_of(m);
  for (const std::vector<int>& loop : loops) {
    std::vector<Vec3> points;
    points.reserve(loop.size());
    for (const int v : loop) points.push_back(position(m, v));
    const std::vector<Triangle> patch = triangulate_loop(points);
    if (patch.size() + 2 != loop.size()) {
      refusal =
          fmt::format("the hole of {} edges at ({:.4f}, {:.4f}, {:.4f}) mm has no filling",
                      loop.size(), 1e3 * points[0].x(), 1e3 * points[0].y(), 1e3 * points[0].z());
      return 0;
    }
    for (const Triangle& t : patch)
      m.triangles.push_back({loop[at(t[0])], loop[at(t[1])], loop[at(t[2])]});
  }
  return loops.size();
}

}  // namespace tdbd::mesh
