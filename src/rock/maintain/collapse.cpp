#include "rock/maintain/collapse.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/compensated_sum.hpp"
#include "mesh/edit.hpp"
#include "rock/maintain/invariants.hpp"

namespace tdbd::rock {
namespace {

bool is_above(const mesh::Surface& s, int t, double z_W) {
  const mesh::Triangle& v = s.triangles[at(t)];
  return std::ranges::all_of(v, [&](int i) { return s.position(i).z() < z_W; });
}

/// Triangles above the plane at boundary vertices, in ascending order.
void find_first(const Rock& rock, double from_z_W, double z_W, TrimWorkspace& work) {
  constexpr double everywhere = 1e300;
  Region slab_W;
  slab_W.box = {Vec3(-everywhere, -everywhere, from_z_W), Vec3(everywhere, everywhere, z_W)};
  work.vertices.clear();
  rock.grid.visit(slab_W, work.chains, [&](const VertexGrid::Block& block) {
    for (int i = 0; i < block.count; ++i) {
      const int v = block.v[at(i)];
      if (rock.surface.is_boundary(v) && rock.surface.position(v).z() < z_W)
        work.vertices.push_back(v);
    }
  });
  std::sort(work.vertices.begin(), work.vertices.end());
  work.triangles.clear();
  for (const int v : work.vertices)
    mesh::visit_corners(rock.surface, v, [&](int c) { work.triangles.push_back(c / 3); });
}

double six_hole_volumes(const mesh::Surface& s, int t) {
  const mesh::Triangle& v = s.triangles[at(t)];
  return -s.position(v[0]).dot(s.position(v[1]).cross(s.position(v[2])));
}

/// Removes one triangle and queues the triangles at its corners.
void remove(Rock& rock, int t, TrimWorkspace& work) {
  const mesh::Triangle corners = rock.surface.triangles[at(t)];
  const int gone = mesh::remove_triangle(rock.surface, t);
  if (gone >= 0) rock.grid.remove(gone);
  for (const int v : corners) discard_ring_note(rock, v);
  for (const int v : corners)
    if (v != gone)
      mesh::visit_corners(rock.surface, v, [&](int c) { work.triangles.push_back(c / 3); });
}

}  // namespace

void trim_wall(Rock& rock, double from_z_W, double z_W, TrimWorkspace& work, TrimReport& report) {
  find_first(rock, from_z_W, z_W, work);
  CompensatedSum six_volumes;
  for (std::size_t i = 0; i < work.triangles.size(); ++i) {
    const int t = work.triangles[i];
    if (!rock.surface.triangle_is_alive(t) || !is_above(rock.surface, t, z_W)) continue;
    if (!mesh::removal_keeps_disc(rock.surface, t)) continue;
    six_volumes.add(six_hole_volumes(rock.surface, t));
    remove(rock, t, work);
    ++report.triangles;
  }
  report.volume += six_volumes.value() / 6.0;
}

namespace {

/// A collapse to one place.
struct Trial {
  Vec3 x_W;
  double volume = 0.0;  ///< m3 of hole gained
};

/// A triangle at the edge (a, b), relative to the edge's midpoint, and which of its corners are a
/// or b.
struct StarTriangle {
  std::array<Vec3, 3> x;
  std::array<bool, 3> is_end;
};

/// Visits the triangles of both stars; those at both a and b once.
template <class Visit>
void visit_stars(const mesh::Surface& s, int a, int b, const Vec3& o_W, Visit&& visit) {
  const auto pass = [&](int c, int other) {
    const mesh::Triangle& t = s.triangles[at(c / 3)];
    if (t[0] == other || t[1] == other || t[2] == other) return;
    StarTriangle star;
    for (std::size_t i = 0; i < 3; ++i) {
      star.x[i] = s.position(t[i]) - o_W;
      star.is_end[i] = t[i] == a || t[i] == b;
    }
    visit(star);
  };
  mesh::visit_corners(s, a, [&](int c) { pass(c, -1); });
  mesh::visit_corners(s, b, [&](int c) { pass(c, a); });
}

/// Guards on one triangle around v whose corner at v moves to x. Nothing: accepted.
std::optional<Refusal> judge(const mesh::Surface& s, int c, const Vec3& x, double quality_floor,
                             const MaintenanceLimits& limits) {
  const mesh::Facet before = facet_at(s, c), after{x, before.b, before.c};
  if (const auto why = judge_turn(area_vector(before), area_vector(after), limits)) return why;
  if ((before.b - x).norm() > limits.longest_edge) return Refusal::too_long;
  if (quality(after) < quality_floor) return Refusal::quality;
  return std::nullopt;
}

std::optional<Refusal> judge_star(const mesh::Surface& s, int v, int other, const Vec3& x,
                                  double quality_floor, const MaintenanceLimits& limits) {
  std::optional<Refusal> why;
  mesh::visit_corners(s, v, [&](int c) {
    if (why || s.vertex(mesh::next_corner(c)) == other ||
        s.vertex(mesh::previous_corner(c)) == other)
      return;
    why = judge(s, c, x, quality_floor, limits);
  });
  return why;
}

std::array<Trial, 3> trials(const mesh::Surface& s, int a, int b) {
  const Vec3 &xa = s.position(a), &xb = s.position(b);
  const Vec3 o = 0.5 * (xa + xb);
  std::array<Trial, 3> all{{{o, 0.0}, {xa, 0.0}, {xb, 0.0}}};
  // six times the signed volumes between the origin and the triangles
  const std::array<Vec3, 3> places{o - o, xa - o, xb - o};
  double before = 0.0;
  std::array<double, 3> after{};
  visit_stars(s, a, b, o, [&](const StarTriangle& t) {
    before += t.x[0].dot(t.x[1].cross(t.x[2]));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto corner = [&](std::size_t k) -> const Vec3& {
        return t.is_end[k] ? places[i] : t.x[k];
      };
      after[i] += corner(0).dot(corner(1).cross(corner(2)));
    }
  });
  for (std::size_t i = 0; i < 3; ++i) all[i].volume = -(after[i] / 6.0 - before / 6.0);
  std::stable_sort(all.begin(), all.end(), [](const Trial& x, const Trial& y) {
    return std::abs(x.volume) < std::abs(y.volume);
  });
  return all;
}

std::optional<Refusal> judge_trial(const mesh::Surface& s, int a, int b, const Trial& t,
                                   double quality_floor, const MaintenanceLimits& limits) {
  if (std::abs(t.volume) > limits.volume_per_operation) return Refusal::volume;
  if (const auto why = judge_star(s, a, b, t.x_W, quality_floor, limits)) return why;
  return judge_star(s, b, a, t.x_W, quality_floor, limits);
}

/// A collapse of the inner edge (a, b) to x_W whose distances are measured. Only the largest
/// distance matters, so a search at one place stops when that place cannot be the farthest.
struct Measured {
  const mesh::Surface& s;
  int a, b;
  Vec3 x_W;
};

/// Visits the triangles around an inner vertex as (vertex, neighbour, next neighbour), starting at
/// the triangle with index `first`, while `visit` returns true. Returns whether it always did.
template <class Visit>
bool visit_from(const mesh::Surface& s, int v, int first, Visit&& visit) {
  const mesh::VertexStar& star = s.star(v);
  const int* ring = s.ring(star);
  const int size = star.size;
  for (int k = 0, i = first; k < size; ++k) {
    const int next = i + 1 < size ? i + 1 : 0;
    if (!visit(ring[i], ring[next])) return false;
    i = next;
  }
  return true;
}

/// The squared distance, m2, of a place from the triangles that replace those around a and b. Stops
/// at any value up to `enough2`. Starts at triangle `first` of `end`, which should be the nearest.
double squared_distance_to_new(const Measured& m, const Vec3& from_W, double enough2, int end,
                               int first) {
  double least = (m.x_W - from_W).squaredNorm();
  if (least <= enough2) return least;
  for (const int v : {end, end == m.a ? m.b : m.a}) {
    const int other = v == m.a ? m.b : m.a;
    if (!visit_from(m.s, v, v == end ? first : 0, [&](int p, int q) {
          if (p == other || q == other) return true;
          const mesh::Facet f{m.x_W, m.s.position(p), m.s.position(q)};
          least = std::min(least, mesh::squared_distance(f, from_W));
          return least > enough2;
        }))
      break;
  }
  return least;
}

/// The same for the present triangles around a and b.
double squared_distance_to_old(const Measured& m, const Vec3& from_W, double enough2, int end,
                               int first) {
  double least = 1e300;
  for (const int v : {end, end == m.a ? m.b : m.a})
    if (!visit_from(m.s, v, v == end ? first : 0, [&](int p, int q) {
          const mesh::Facet f{m.s.position(v), m.s.position(p), m.s.position(q)};
          least = std::min(least, mesh::squared_distance(f, from_W));
          return least > enough2;
        }))
      break;
  return least;
}

/// The largest of `farthest2` and the squared distances, m2, of edge midpoints from the other
/// surface: of the new edges to x_W from the old surface, and of the old edges from the new
/// surface. Stops above `most2`.
double farthest_middle(const Measured& m, double farthest2, double most2) {
  for (const int end : {m.a, m.b}) {
    const int other = end == m.a ? m.b : m.a;
    const mesh::VertexStar& star = m.s.star(end);
    const int* ring = m.s.ring(star);
    for (int i = 0; i < star.size && farthest2 <= most2; ++i) {
      const Vec3& w_W = m.s.position(ring[i]);
      const Vec3 old_W = 0.5 * (m.s.position(end) + w_W), new_W = 0.5 * (m.x_W + w_W);
      farthest2 = std::max(farthest2, squared_distance_to_new(m, old_W, farthest2, end, i));
      if (ring[i] != other && ring[i + 1 < star.size ? i + 1 : 0] != other)
        farthest2 = std::max(farthest2, squared_distance_to_old(m, new_W, farthest2, end, i));
    }
  }
  return farthest2;
}

}  // namespace

std::optional<Refusal> judge_distance(const mesh::Surface& s, int a, int b, const Vec3& x_W,
                                      const MaintenanceLimits& limits, const SurfaceDrift& drift,
                                      double& drifted) {
  const Measured m{s, a, b, x_W};
  double farthest2 = 0.0;
  for (const int v : {a, b}) {
    const double d2 = squared_distance_to_new(m, s.position(v), 0.0, v, 0);
    if (std::sqrt(d2) > limits.ridge_cut && is_on_ridge(s, v, limits)) return Refusal::ridge;
    farthest2 = std::max(farthest2, d2);
  }
  constexpr double rounded_up = 1.0 + 1e-12;
  const double most = limits.farthest * rounded_up;
  const double before =
      std::max(largest_drift_around(s, a, drift), largest_drift_around(s, b, drift));
  drifted = std::sqrt(farthest_middle(m, farthest2, most * most)) + before;
  if (drifted > limits.farthest) return Refusal::distance;
  return std::nullopt;
}

namespace {

/// The guards that do not depend on the place. Accepts an edge that no longer exists.
CollapseVerdict judge_edge(const mesh::Surface& s, int a, int b) {
  CollapseVerdict v;
  if (s.is_boundary(a) || s.is_boundary(b)) {
    v.refused = Refusal::boundary;
    return v;
  }
  v.corner = mesh::corner_facing(s, a, b);
  if (v.corner >= 0 && !mesh::collapse_keeps_topology(s, v.corner)) v.refused = Refusal::topology;
  return v;
}

double quality_floor(const mesh::Surface& s, int a, int b) {
  return std::min(0.3, std::min(worst_quality(s, a), worst_quality(s, b)));
}

/// The guards that depend on the place.
void judge_place(const mesh::Surface& s, int a, int b, const Trial& t, double floor,
                 const MaintenanceLimits& limits, const SurfaceDrift& drift, CollapseVerdict& v) {
  v.refused = judge_trial(s, a, b, t, floor, limits);
  if (!v.refused) v.refused = judge_distance(s, a, b, t.x_W, limits, drift, v.drift);
  v.x_W = t.x_W;
  v.volume = t.volume;
}

}  // namespace

CollapseVerdict judge_collapse(const mesh::Surface& s, int a, int b,
                               const MaintenanceLimits& limits, const SurfaceDrift& drift) {
  CollapseVerdict v = judge_edge(s, a, b);
  if (v.corner < 0 || v.refused) return v;
  const double floor = quality_floor(s, a, b);
  std::optional<Refusal> first;
  for (const Trial& t : trials(s, a, b)) {
    judge_place(s, a, b, t, floor, limits, drift, v);
    if (!v.refused) return v;
    if (!first) first = v.refused;
  }
  v.refused = first;
  return v;
}

std::array<CollapseVerdict, 3> judge_collapses(const mesh::Surface& s, int a, int b,
                                               const MaintenanceLimits& limits,
                                               const SurfaceDrift& drift) {
  const CollapseVerdict edge = judge_edge(s, a, b);
  std::array<CollapseVerdict, 3> all{edge, edge, edge};
  if (edge.corner < 0 || edge.refused) return all;
  const double floor = quality_floor(s, a, b);
  const std::array<Trial, 3> places = trials(s, a, b);
  for (std::size_t i = 0; i < 3; ++i) judge_place(s, a, b, places[i], floor, limits, drift, all[i]);
  return all;
}

void collapse(Rock& rock, const CollapseVerdict& verdict, Operation what, std::vector<int>& ring,
              SurfaceDrift& drift, MaintenanceReport& report) {
  mesh::Surface& s = rock.surface;
  const int c = verdict.corner;
  const int keep = s.vertex(mesh::next_corner(c)), gone = s.vertex(mesh::previous_corner(c));
  ring.clear();
  for (const int v : {keep, gone})
    mesh::visit_corners(s, v, [&](int k) { ring.push_back(s.vertex(mesh::next_corner(k))); });
  LocalState before;
  if constexpr (check_every_operation) before = local_state(s, ring);
  const Vec3 from_W = s.position(keep), edge_W = s.position(gone) - from_W;
  const double share = std::clamp(
      edge_W.dot(verdict.x_W - from_W) / std::max(edge_W.squaredNorm(), 1e-300), 0.0, 1.0);
  record_carried(rock, {keep, {keep, gone, keep}, {1.0 - share, share, 0.0}});
  mesh::collapse_edge(s, c, verdict.x_W);
  rock.grid.remove(gone);
  rock.grid.move(keep, verdict.x_W);
  for (const int v : ring)
    if (v != gone) touch(rock, v);
  drift.note(keep, verdict.drift);
  count_done(report, what, verdict.volume);
  if constexpr (check_every_operation)
    require_promises_around(rock, before, verdict.volume, name_of(what));
}

bool try_collapse(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                  SurfaceDrift& drift, MaintenanceReport& report) {
  const CollapseVerdict v = judge_collapse(rock.surface, a, b, limits, drift);
  if (v.refused) count_refused(report, Operation::collapse, *v.refused);
  if (!is_accepted(v)) return false;  // or an earlier collapse removed the edge
  collapse(rock, v, Operation::collapse, ring, drift, report);
  return true;
}

}  // namespace tdbd::rock
