#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "mesh/check/check.hpp"
#include "mesh/check/nesting.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "mesh/surface.hpp"

namespace tdbd::mesh {

std::size_t orient_pieces(TriangleMesh& m) {
  const std::vector<std::vector<int>> pieces = connected_pieces(m.triangles);
  const std::vector<NestedPiece> nested = nested_pieces(submeshes(m, pieces));
  std::size_t turned = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (nested[at(nested[i].outermost)].outward) continue;
    for (const int t : pieces[i]) std::swap(m.triangles[at(t)][1], m.triangles[at(t)][2]);
    turned += pieces[i].size();
  }
  return turned;
}

std::size_t drop_inner_shells(TriangleMesh& m) {
  const std::vector<std::vector<int>> pieces = connected_pieces(m.triangles);
  const std::vector<NestedPiece> nested = nested_pieces(submeshes(m, pieces));
  std::vector<int> kept;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (nested[i].bounds != Bounds::nothing || nested[i].around.empty())
      kept.insert(kept.end(), pieces[i].begin(), pieces[i].end());
  const std::size_t dropped = m.triangles.size() - kept.size();
  std::ranges::sort(kept);
  if (dropped > 0) m = submesh(m, kept);
  return dropped;
}

namespace {

/// A corner on the side of another facet.
struct PointOnSide {
  double along = 0.0;  ///< fraction of the side
  int vertex = 0;
};

/// The ends of open edges in the order of x, for searches.
std::vector<int> open_vertices(const TriangleMesh& m, const std::vector<Side>& sides) {
  std::vector<int> open;
  for_each_edge(sides, [&](const Side* first, const Side* last) {
    if (last - first == 1) open.insert(open.end(), {first->lo, first->hi});
  });
  const auto key = [&](int v) { return std::pair(position(m, v).x(), v); };
  std::ranges::sort(open, {}, key);
  open.erase(std::unique(open.begin(), open.end()), open.end());
  return open;
}

/// The open vertices between the ends of a side and at most `reach` (m) from it, in the order from
/// lo to hi.
std::vector<PointOnSide> points_on(const TriangleMesh& m, const Side& side,
                                   const std::vector<int>& open, double reach) {
  constexpr double of_edge = 0.01;  // a longer distance is no rounding
  const Vec3 &a = position(m, side.lo), &b = position(m, side.hi), d = b - a;
  const double near = std::min(reach, of_edge * d.norm());
  const Triangle& own = m.triangles[at(side.triangle)];
  std::vector<PointOnSide> found;
  const auto x = [&](int v) { return position(m, v).x(); };
  for (auto v = std::ranges::lower_bound(open, std::min(a.x(), b.x()) - near, {}, x);
       v != open.end() && x(*v) <= std::max(a.x(), b.x()) + near; ++v) {
    if (std::ranges::find(own, *v) != own.end()) continue;
    const Vec3 r = position(m, *v) - a;
    const double along = r.dot(d) / d.squaredNorm();
    const bool is_between = r.norm() > near && (position(m, *v) - b).norm() > near;
    if (along > 0.0 && along < 1.0 && is_between && (r - along * d).norm() <= near)
      found.push_back({along, *v});
  }
  std::ranges::sort(found, {}, [](const PointOnSide& p) { return std::pair(p.along, p.vertex); });
  return found;
}

/// Replaces a facet by a fan from the corner that faces the side.
void split_side(TriangleMesh& m, const Side& side, const std::vector<PointOnSide>& points) {
  const Triangle old = m.triangles[at(side.triangle)];
  const int apex = old[at(side.corner % 3)];
  int from = side.lo;
  const auto piece = [&](int to) {
    return side.forward ? Triangle{apex, from, to} : Triangle{apex, to, from};
  };
  m.triangles[at(side.triangle)] = piece(points.front().vertex);
  for (std::size_t k = 0; k < points.size(); ++k) {
    from = points[k].vertex;
    m.triangles.push_back(piece(k + 1 < points.size() ? points[k + 1].vertex : side.hi));
  }
}

}  // namespace

std::size_t split_t_junctions(TriangleMesh& m, double weld) {
  constexpr double rounding = 5e-6;  // of numbers with six digits
  constexpr int most_passes = 20;    // a pass splits one side of a facet
  double largest = 0.0;
  for (const Vec3& x : m.positions) largest = std::max(largest, x.cwiseAbs().maxCoeff());
  const double reach = std::max(weld, rounding * largest);
  std::size_t split = 0;
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::vector<Side> sides = sorted_sides(m);
    const std::vector<int> open = open_vertices(m, sides);
    std::vector<char> is_split(m.triangles.size(), 0);
    const std::size_t before = split;
    for_each_edge(sides, [&](const Side* first, const Side* last) {
      if (last - first != 1 || is_split[at(first->triangle)] != 0) return;
      const std::vector<PointOnSide> points = points_on(m, *first, open, reach);
      if (points.empty()) return;
      is_split[at(first->triangle)] = 1;
      split_side(m, *first, points);
      split += points.size();
    });
    if (split == before) break;
  }
  return split;
}

std::vector<Opening> openings(const TriangleMesh& m) {
  std::vector<Opening> found;
  for (std::vector<int>& loop : boundary_loops(m)) {
    Opening o;
    Box box;
    for (const int v : loop) {
      box.add(position(m, v));
      o.centre += position(m, v) / static_cast<double>(loop.size());
    }
    o.across = box.size().norm();
    o.loop = std::move(loop);
    found.push_back(std::move(o));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Opening& a, const Opening& b) { return a.across > b.across; });
  return found;
}

std::string describe(const Opening& opening, const std::string& what) {
  return fmt::format("{} of {} edges, {:.4g} mm across, at {}", what, opening.loop.size(),
                     1e3 * opening.across, in_mm(opening.centre));
}

std::size_t fill_sheet_holes(TriangleMesh& m, std::string& refusal) {
  drop_unused_points(m);
  std::vector<std::vector<int>> holes;
  const std::vector<Opening> all = openings(m);
  for (std::size_t i = 1; i < all.size(); ++i) holes.push_back(all[i].loop);
  return fill_loops(m, holes, refusal);
}

void flip(TriangleMesh& m) {
  for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
}

void turn_about_x(TriangleMesh& m) {
  for (Vec3& x : m.positions) x = Vec3(x.x(), -x.y(), -x.z());
}

bool faces_down(const TriangleMesh& m) {
  double down = 0.0;
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const auto [a, b, c] = corners(m, i);
    down += area_vector(a, b, c).z();
  }
  return down >= 0.0;
}

std::vector<std::string> sheet_faults(const TriangleMesh& m) {
  std::vector<std::string> lines;
  std::istringstream text(summarize(check_surface(m)));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  if (!lines.empty()) return lines;
  if (faces_down(m))
    lines.push_back(fmt::format("the facets face down, into the rock (z points down): {}",
                                upside_down_question));
  const auto pairs = self_intersections(m);
  if (!pairs.empty())
    lines.push_back(fmt::format("intersecting pairs of facets: {}, the first {} and triangle {}",
                                pairs.size(), place_of_triangle(m, pairs.front().first),
                                pairs.front().second));
  return lines;
}

}  // namespace tdbd::mesh
