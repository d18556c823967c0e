#include "rock/maintain/check_operation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/tolerance.hpp"

namespace tdbd::rock {
namespace {

using mesh::Surface;

double volume_around(const Surface& s, const std::vector<int>& vertices, const Vec3& origin_W) {
  std::set<int> triangles;
  for (const int v : vertices)
    if (s.is_alive(v)) mesh::visit_corners(s, v, [&](int c) { triangles.insert(c / 3); });
  double six = 0.0;
  for (const int t : triangles) {
    const auto& [a, b, c] = s.triangles[at(t)];
    six +=
        (s.position(a) - origin_W).dot((s.position(b) - origin_W).cross(s.position(c) - origin_W));
  }
  return -six / 6.0;
}

/// Whether the two triangles beside the edge that faces c are stored consistently as neighbours.
bool agrees_with_opposite(const Surface& s, int c) {
  const int o = s.opposite_of(c);
  if (o < 0) return true;
  return s.triangle_is_alive(o / 3) && s.opposite_of(o) == c &&
         s.vertex(mesh::next_corner(c)) == s.vertex(mesh::previous_corner(o)) &&
         s.vertex(mesh::previous_corner(c)) == s.vertex(mesh::next_corner(o));
}

/// Describes what is wrong with the triangles around v; empty if nothing is.
std::string defect_at(const Surface& s, int v) {
  constexpr int most_neighbours = 100'000;
  std::set<int> neighbours;
  const int first = s.corner_of[at(v)];
  int c = first, count = 0;
  do {
    if (!s.triangle_is_alive(c / 3) || s.vertex(c) != v) return "a corner of another vertex";
    for (int k = 3 * (c / 3); k < 3 * (c / 3) + 3; ++k)
      if (!agrees_with_opposite(s, k)) return "triangles that disagree about their edge";
    if (!neighbours.insert(s.vertex(mesh::next_corner(c))).second) return "a neighbour twice";
    if (++count > most_neighbours) return "a fan without end";
    c = mesh::turn_left(s, c);
  } while (c >= 0 && c != first);
  if ((c < 0) != s.is_boundary(v)) return "a wrong mark of the boundary";
  return "";
}

bool is_at(const VertexGrid::Block& block, std::size_t i, const Vec3& x_W) {
  return Eigen::Matrix<Single, 3, 1>(block.x[i], block.y[i], block.z[i]) == x_W.cast<Single>();
}

bool is_indexed(const Rock& rock, int v) {
  const Vec3& x_W = rock.surface.position(v);
  Region here;
  here.box = {x_W, x_W};
  std::vector<int> chains;
  int held = 0;
  rock.grid.visit(here, chains, [&](const VertexGrid::Block& block) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i)
      held += block.v[i] == v && is_at(block, i, x_W) ? 1 : 0;
  });
  return held == 1;
}

}  // namespace

LocalState local_state(const Surface& s, std::vector<int> vertices) {
  LocalState state;
  state.origin_W = s.position(vertices.front());
  for (const int v : vertices)
    mesh::visit_corners(s, v, [&](int c) {
      const Vec3& x_W = s.position(s.vertex(mesh::next_corner(c)));
      state.size = std::max(state.size, (x_W - state.origin_W).norm());
    });
  state.volume = volume_around(s, vertices, state.origin_W);
  state.vertices = std::move(vertices);
  return state;
}

std::vector<Violation> check_around(const Rock& rock, const LocalState& before,
                                    double volume_change) {
  const Surface& s = rock.surface;
  std::vector<Violation> found;
  for (const int v : before.vertices) {
    if (!s.is_alive(v)) continue;
    const std::string defect = defect_at(s, v);
    if (!defect.empty())
      found.push_back({Invariant::disc, fmt::format("vertex {} has {}", v, defect)});
    else if (!is_indexed(rock, v))
      found.push_back({Invariant::disc, fmt::format("the index does not have vertex {}", v)});
  }
  if (!found.empty()) return found;
  const double gained = volume_around(s, before.vertices, before.origin_W) - before.volume;
  const double scale = std::pow(2.0 * before.size, 3);
  if (std::abs(gained - volume_change) > tolerance::ledger * scale)
    found.push_back({Invariant::ledger, fmt::format("the hole gained {} mm3, reported are {} mm3",
                                                    1e9 * gained, 1e9 * volume_change)});
  return found;
}

void require_promises_around(const Rock& rock, const LocalState& before, double volume_change,
                             const char* what) {
  const std::vector<Violation> found = check_around(rock, before, volume_change);
  if (!found.empty())
    throw RunError(fmt::format("one of the {} broke a promise of the rock's surface:\n{}", what,
                               describe(found)));
}

}  // namespace tdbd::rock
