#include "rock/maintain/collapse.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/edit.hpp"
#include "rock/maintain/check_operation.hpp"
#include "rock/maintain/star.hpp"

namespace tdbd::rock {
namespace {

/// What a collapse to one place would do.
struct Trial {
  Vec3 x_W;
  double volume = 0.0;  ///< m3 of hole gained
};

/// Signed volume under the triangles of both stars about o, with a and b at the given places.
double star_volume(const mesh::Surface& s, int a, int b, const Vec3& xa, const Vec3& xb,
                   const Vec3& o) {
  const auto place = [&](int v) -> Vec3 { return (v == a ? xa : v == b ? xb : s.position(v)) - o; };
  double six = 0.0;
  const auto add = [&](int c, int other) {
    const mesh::Triangle& t = s.triangles[at(c / 3)];
    if (t[0] == other || t[1] == other || t[2] == other) return;
    six += place(t[0]).dot(place(t[1]).cross(place(t[2])));
  };
  mesh::visit_corners(s, a, [&](int c) { add(c, -1); });
  mesh::visit_corners(s, b, [&](int c) { add(c, a); });
  return six / 6.0;
}

/// Guards on one triangle around v, whose corner there goes to x. Nothing: accepted.
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
  const double before = star_volume(s, a, b, xa, xb, o);
  std::array<Trial, 3> all{{{o, 0.0}, {xa, 0.0}, {xb, 0.0}}};
  for (Trial& t : all) t.volume = -(star_volume(s, a, b, t.x_W, t.x_W, o) - before);
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

/// The corners at a and b of the triangles that a collapse of the edge keeps.
template <class Visit>
void visit_kept(const mesh::Surface& s, int a, int b, Visit&& visit) {
  for (const auto& [end, other] : {std::pair{a, b}, std::pair{b, a}})
    mesh::visit_corners(s, end, [&, beside = other](int c) {
      if (s.vertex(mesh::next_corner(c)) != beside && s.vertex(mesh::previous_corner(c)) != beside)
        visit(c);
    });
}

/// How far a place is from the triangles that replace those around a and b, m.
double distance_to_new(const mesh::Surface& s, int a, int b, const Vec3& x_W, const Vec3& from_W) {
  double least = (x_W - from_W).squaredNorm();
  visit_kept(s, a, b, [&](int c) {
    const mesh::Facet f = facet_at(s, c);
    least = std::min(least, mesh::squared_distance({x_W, f.b, f.c}, from_W));
  });
  return std::sqrt(least);
}

/// How far a place is from the triangles around a and b, m.
double distance_to_old(const mesh::Surface& s, int a, int b, const Vec3& from_W) {
  double least = 1e300;
  for (const int end : {a, b})
    mesh::visit_corners(s, end, [&](int c) {
      least = std::min(least, mesh::squared_distance(facet_at(s, c), from_W));
    });
  return std::sqrt(least);
}

/// The farthest middle of a new edge at x from the old surface, m: x itself is on it.
double farthest_new_middle(const mesh::Surface& s, int a, int b, const Vec3& x_W) {
  double farthest = 0.0;
  visit_kept(s, a, b, [&](int c) {
    const Vec3 middle_W = 0.5 * (x_W + s.position(s.vertex(mesh::next_corner(c))));
    farthest = std::max(farthest, distance_to_old(s, a, b, middle_W));
  });
  return farthest;
}

/// The farthest middle of an old edge at a or b from the new surface, m.
double farthest_old_middle(const mesh::Surface& s, int a, int b, const Vec3& x_W) {
  double farthest = 0.0;
  for (const int end : {a, b})
    mesh::visit_corners(s, end, [&](int c) {
      const Vec3 middle_W = 0.5 * (s.position(end) + s.position(s.vertex(mesh::next_corner(c))));
      farthest = std::max(farthest, distance_to_new(s, a, b, x_W, middle_W));
    });
  return farthest;
}

/// The guards on distance, once the others agree: of the dropped vertices and edges to the new
/// surface, and of the new edges to the old one.
std::optional<Refusal> judge_distance(const mesh::Surface& s, int a, int b, const Vec3& x_W,
                                      const MaintenanceLimits& limits, const SurfaceDrift& drift,
                                      double& drifted) {
  double farthest = std::max(farthest_new_middle(s, a, b, x_W), farthest_old_middle(s, a, b, x_W));
  for (const int v : {a, b}) {
    const double d = distance_to_new(s, a, b, x_W, s.position(v));
    if (d > limits.ridge_cut && is_on_ridge(s, v, limits)) return Refusal::ridge;
    farthest = std::max(farthest, d);
  }
  drifted =
      farthest + std::max(largest_drift_around(s, a, drift), largest_drift_around(s, b, drift));
  if (drifted > limits.farthest) return Refusal::distance;
  return std::nullopt;
}

/// The guards that do not depend on the place. Not refused: the edge exists, or no longer does.
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

/// The guards on one place.
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
  note_carried(rock, {keep, {keep, gone, keep}, {1.0 - share, share, 0.0}});
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
  if (!is_accepted(v)) return false;  // or an earlier collapse took the edge
  collapse(rock, v, Operation::collapse, ring, drift, report);
  return true;
}

}  // namespace tdbd::rock
