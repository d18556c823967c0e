#include "rock/maintain/invariants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "mesh/check/check.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/triangle_tree.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/operations.hpp"
#include "rock/maintain/touched_region.hpp"

namespace tdbd::rock {
namespace {

using mesh::Surface;
using Violations = std::vector<Violation>;

std::string in_mm(const Vec3& x_W) {
  return fmt::format("({:.4f}, {:.4f}, {:.4f}) mm", 1e3 * x_W.x(), 1e3 * x_W.y(), 1e3 * x_W.z());
}

std::string at_vertex(const Surface& s, int v) {
  return fmt::format("vertex {} at {}", v, in_mm(s.position(v)));
}

std::string at_triangle(const Surface& s, int t) {
  const auto& [a, b, c] = s.triangles[at(t)];
  return fmt::format("triangle {} at {}", t,
                     in_mm((s.position(a) + s.position(b) + s.position(c)) / 3.0));
}

void append(Violations& to, Violations from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// Checks that the index contains every living vertex once, in the right place.
Violations check_index(const Rock& rock) {
  const Surface& s = rock.surface;
  Violations found;
  std::vector<int> held(s.stars.size(), 0);
  std::vector<int> chains;
  Region everywhere;
  everywhere.box = {Vec3::Constant(-1e300), Vec3::Constant(1e300)};
  rock.grid.visit(everywhere, chains, [&](const VertexGrid::Block& block) {
    for (std::size_t i = 0; i < at(block.count); ++i) {
      const int v = block.v[i];
      const Vec3 x_W(block.x[i], block.y[i], block.z[i]);
      if (v < s.vertex_slots() && x_W == s.position(v).cast<Single>().cast<double>())
        ++held[at(v)];
      else
        found.push_back(
            {Invariant::disc, fmt::format("the index has vertex {} at {}", v, in_mm(x_W))});
    }
  });
  for (int v = 0; v < s.vertex_slots(); ++v)
    if (held[at(v)] != (s.is_alive(v) ? 1 : 0))
      found.push_back({Invariant::disc,
                       fmt::format("the index has {} {} times", at_vertex(s, v), held[at(v)])});
  return found;
}

double length(const Surface& s, int a, int b) { return (s.position(b) - s.position(a)).norm(); }

std::string at_edge(const Surface& s, int a, int b) {
  return fmt::format("edge {}-{} of {:.4f} mm at {}", a, b, 1e3 * length(s, a, b),
                     in_mm(0.5 * (s.position(a) + s.position(b))));
}

RepairScope wider(RepairScope a, RepairScope b) { return a == RepairScope::all ? a : b; }

void check_edge(const Surface& s, int c, const MaintenanceLimits& limits, const SurfaceDrift& drift,
                RepairScope scope, Violations& found) {
  const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
  if (scope == RepairScope::all && length(s, a, b) > limits.longest_edge && s.opposite_of(c) >= 0)
    found.push_back({Invariant::edges, at_edge(s, a, b) + " is too long"});
  if (length(s, a, b) < limits.shortest_edge && is_accepted(judge_collapse(s, a, b, limits, drift)))
    found.push_back({Invariant::edges, at_edge(s, a, b) + " is too short and would collapse"});
}

void check_shape(const Surface& s, int t, const MaintenanceLimits& limits,
                 const SurfaceDrift& drift, Violations& found) {
  const mesh::Facet f = facet_at(s, 3 * t);
  const double q = quality(f);
  const std::array<double, 3> edges{(f.b - f.c).squaredNorm(), (f.c - f.a).squaredNorm(),
                                    (f.a - f.b).squaredNorm()};
  const auto corner = [&](auto edge) { return 3 * t + static_cast<int>(edge - edges.begin()); };
  const int shortest = corner(std::min_element(edges.begin(), edges.end()));
  const int longest = corner(std::max_element(edges.begin(), edges.end()));
  const int a = s.vertex(mesh::next_corner(shortest)),
            b = s.vertex(mesh::previous_corner(shortest));
  const auto note = [&](const char* what) {
    found.push_back({Invariant::quality,
                     fmt::format("{} has quality {:.4f} and its {}", at_triangle(s, t), q, what)});
  };
  if (q < limits.worst_quality &&
      is_accepted(judge_collapse(s, std::min(a, b), std::max(a, b), limits, drift)))
    note("shortest edge would collapse");
  if (q < limits.flip_quality && !judge_flip(s, longest, limits, drift).refused)
    note("longest edge would flip");
}

bool in_both(const Surface& s, const Surface& o, int t) {
  return t < o.triangle_slots() && s.triangle_is_alive(t) && o.triangle_is_alive(t);
}

/// Whether the triangle in a living slot of s differs from that in o.
bool is_changed(const Surface& s, const Surface& o, int t) {
  if (!in_both(s, o, t) || s.triangles[at(t)] != o.triangles[at(t)]) return true;
  return std::ranges::any_of(s.triangles[at(t)],
                             [&](int v) { return s.position(v) != o.position(v); });
}

Vec3 area_of(const Surface& s, int t) {
  const auto& [a, b, c] = s.triangles[at(t)];
  return mesh::area_vector(s.position(a), s.position(b), s.position(c));
}

double distance_to(const mesh::TriangleTree& tree, const Vec3& x_W, double reach) {
  double best = reach * reach;
  tree.visit(
      [&](const mesh::Box& b) {
        return (x_W.cwiseMax(b.lo).cwiseMin(b.hi) - x_W).squaredNorm() < best;
      },
      [&](const mesh::Facet& f) {
        best = std::min(best, mesh::squared_distance(f, x_W));
        return true;
      });
  return std::sqrt(best);
}

std::array<Vec3, 7> samples(const Surface& s, int t) {
  const auto& [i, j, k] = s.triangles[at(t)];
  const Vec3 &a = s.position(i), &b = s.position(j), &c = s.position(k);
  return {a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3.0};
}

/// What maintenance had to examine: everything at due and new vertices, and all but bisections
/// beside its own changes.
std::vector<RepairScope> scope_of(const Rock& before, const MaintenanceLimits& limits,
                                  const Surface& after) {
  std::vector<RepairScope> scope(after.stars.size(), RepairScope::all);
  for (int v = 0; v < before.surface.vertex_slots(); ++v)
    if (before.surface.is_alive(v) && (before.touched[at(v)] == 0 || !is_due(before, limits, v)))
      scope[at(v)] = RepairScope::none;
  for (int t = 0; t < after.triangle_slots(); ++t)
    if (after.triangle_is_alive(t) && is_changed(after, before.surface, t))
      for (const int v : after.triangles[at(t)])
        if (scope[at(v)] == RepairScope::none) scope[at(v)] = RepairScope::no_bisections;
  return scope;
}

/// Per root of a patch: whether a vertex of the patch is touched or has a touched neighbour.
std::vector<std::uint8_t> patches_at_touched(const Rock& before, mesh::DisjointSets& patches) {
  std::vector<std::uint8_t> is_known(before.surface.stars.size(), 0);
  for (const mesh::Triangle& t : before.surface.triangles)
    if (t[0] >= 0 && std::ranges::any_of(t, [&](int v) { return before.touched[at(v)] != 0; }))
      for (const int v : t) is_known[at(patches.find(v))] = 1;
  return is_known;
}

}  // namespace

std::string describe(const Violations& found, std::size_t max) {
  std::string text;
  for (std::size_t i = 0; i < std::min(max, found.size()); ++i)
    text += fmt::format("M{}: {}\n", static_cast<int>(found[i].which) + 1, found[i].where);
  if (found.size() > max) text += fmt::format("and {} more\n", found.size() - max);
  return text;
}

Violations check_disc(const Rock& rock) {
  Violations found;
  for (const mesh::Defect& d : mesh::check_surface(mesh::compact(rock.surface)))
    if (d.kind != mesh::Defect::Kind::degenerate_triangle)  // cutting may press a triangle flat
      found.push_back({Invariant::disc, mesh::name(d.kind) + ": " + d.where});
  if (!mesh::adjacency_is_consistent(rock.surface))
    found.push_back({Invariant::disc, "the corners' adjacency is not that of the triangles"});
  append(found, check_index(rock));
  return found;
}

Violations check_repairs(const Surface& s, const std::vector<RepairScope>& scope,
                         const MaintenanceLimits& limits, const SurfaceDrift& drift) {
  Violations found;
  for (int t = 0; t < s.triangle_slots(); ++t) {
    if (!s.triangle_is_alive(t)) continue;
    const auto in_scope = [&](int v) { return scope[at(v)] != RepairScope::none; };
    if (std::ranges::none_of(s.triangles[at(t)], in_scope)) continue;
    check_shape(s, t, limits, drift, found);
    for (int c = 3 * t; c < 3 * t + 3; ++c) {
      const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
      if (!in_scope(a) && !in_scope(b)) continue;
      if (a < b || s.opposite_of(c) < 0)
        check_edge(s, c, limits, drift, wider(scope[at(a)], scope[at(b)]), found);
    }
  }
  return found;
}

Violations check_normals(const Surface& before, const Surface& after) {
  Violations found;
  for (int t = 0; t < before.triangle_slots(); ++t)
    if (in_both(before, after, t) && area_of(before, t).dot(area_of(after, t)) < 0.0)
      found.push_back(
          {Invariant::normals, at_triangle(after, t) + " turned by more than 90 degrees"});
  return found;
}

Violations check_ledger(const Surface& before, const Surface& after, double change) {
  const mesh::Box box_W = mesh::bounding_box(mesh::compact(before));
  const Vec3 origin_W = 0.5 * (box_W.lo + box_W.hi);
  const double size = box_W.size().norm();
  const double gained = mesh::hole_volume(after, origin_W) - mesh::hole_volume(before, origin_W);
  if (std::abs(gained - change) <= tolerance::ledger * size * size * size) return {};
  return {{Invariant::ledger,
           fmt::format("the hole gained {} mm3, reported are {} mm3", 1e9 * gained, 1e9 * change)}};
}

Deviation deviation(const Surface& from, const Surface& to, double reach) {
  const mesh::TriangleTree tree(mesh::compact(to));
  Deviation worst;
  for (int t = 0; t < from.triangle_slots(); ++t) {
    if (!from.triangle_is_alive(t) || !is_changed(from, to, t)) continue;
    for (const Vec3& x_W : samples(from, t))
      if (const double d = distance_to(tree, x_W, reach); d > worst.distance) worst = {d, x_W};
  }
  return worst;
}

Violations check_distance(const Surface& before, const Surface& after,
                          const MaintenanceLimits& limits, const MaintenanceReport& report) {
  Violations found;
  const bool untangled = report.carried_out(Operation::untangling) > 0;
  const double bound = untangled ? limits.untangle_farthest : 0.5 * limits.shortest_edge,
               reach = 2.0 * limits.longest_edge;
  const auto check = [&](const Surface& from, const Surface& to, const char* which) {
    const Deviation d = deviation(from, to, reach);
    if (d.distance >= bound && d.distance > 0.0)
      found.push_back(
          {Invariant::distance, fmt::format("{} strays {:.4f} mm at {}, bound {:.4f} mm", which,
                                            1e3 * d.distance, in_mm(d.x_W), 1e3 * bound)});
  };
  check(after, before, "the new surface");
  check(before, after, "the old surface");
  return found;
}

Violations check_locality(const Rock& before, const Surface& after) {
  const Surface& s = before.surface;
  Violations found;
  mesh::DisjointSets patches(s.stars.size());
  std::vector<std::uint8_t> in_changed(s.stars.size(), 0);
  std::vector<int> changed;
  for (int t = 0; t < s.triangle_slots(); ++t) {
    if (!s.triangle_is_alive(t) || !is_changed(s, after, t)) continue;
    changed.push_back(t);
    for (const int v : s.triangles[at(t)]) in_changed[at(v)] = 1;
  }
  for (const auto& [a, b, c] : s.triangles) {
    if (a < 0) continue;
    for (const auto& [v, w] : {std::pair{a, b}, {b, c}, {c, a}})
      if (in_changed[at(v)] && in_changed[at(w)]) patches.join(v, w);
  }
  const std::vector<std::uint8_t> is_known = patches_at_touched(before, patches);
  for (int v = 0; v < s.vertex_slots(); ++v) {
    if (!s.is_boundary(v)) continue;
    if (!after.is_alive(v) || !after.is_boundary(v) || after.position(v) != s.position(v))
      found.push_back({Invariant::locality, "of the boundary, " + at_vertex(s, v) + " changed"});
  }
  for (const int t : changed)
    if (!is_known[at(patches.find(s.triangles[at(t)][0]))])
      found.push_back({Invariant::locality, at_triangle(s, t) + " changed, untouched"});
  return found;
}

Violations check_maintenance(const Rock& before, const Rock& after, const MaintenanceLimits& limits,
                             const MaintenanceReport& report, const SurfaceDrift& drift) {
  Violations found = check_disc(after);
  if (!found.empty()) return found;  // the other checks walk around vertices and need a valid disc
  const Surface &s = before.surface, &now = after.surface;
  append(found, check_repairs(now, scope_of(before, limits, now), limits, drift));
  append(found, check_ledger(s, now, report.volume_change));
  append(found, check_distance(s, now, limits, report));
  append(found, check_locality(before, now));
  return found;
}

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
