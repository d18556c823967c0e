#include "rock/maintain/operations.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/edit.hpp"
#include "rock/maintain/invariants.hpp"

namespace tdbd::rock {

bool bisect_edge(Rock& rock, int a, int b, const MaintenanceLimits& limits, std::vector<int>& ring,
                 MaintenanceReport& report) {
  mesh::Surface& s = rock.surface;
  const int c = mesh::corner_facing(s, a, b);
  if (c < 0 || s.opposite_of(c) < 0) {
    count_refused(report, Operation::bisection, Refusal::boundary);
    return false;
  }
  if ((s.position(b) - s.position(a)).norm() <= limits.longest_edge) return false;
  const int o = s.opposite_of(c);
  const int p = s.vertex(c), q = s.vertex(o);
  const int last_part = rock.last_part[at(a)];
  LocalState before;
  if constexpr (check_every_operation) before = local_state(s, {a, b, p, q});
  const int m = mesh::split_edge(s, c, 0.5 * (s.position(a) + s.position(b)));
  register_vertex(rock, m, last_part);
  record_carried(rock, {m, {a, b, a}, {0.5, 0.5, 0.0}});
  ring.assign({a, b, p, q, m});
  for (const int v : ring) touch(rock, v);
  count_done(report, Operation::bisection, 0.0);
  if constexpr (check_every_operation) require_promises_around(rock, before, 0.0, "bisections");
  return true;
}

namespace {

using mesh::Facet;

/// The edge (a, b), and the vertices p and q that face it.
struct Diagonals {
  Vec3 a, b, p, q;
};

Diagonals diagonals(const mesh::Surface& s, int c) {
  const Facet f = facet_at(s, c);
  return {f.b, f.c, f.a, s.position(s.vertex(s.opposite_of(c)))};
}

/// The four vertices of the two triangles beside the edge that faces c.
std::array<int, 4> corners_around(const mesh::Surface& s, int c) {
  return {s.vertex(c), s.vertex(mesh::next_corner(c)), s.vertex(mesh::previous_corner(c)),
          s.vertex(s.opposite_of(c))};
}

double largest_drift_of(const mesh::Surface& s, int c, const SurfaceDrift& drift) {
  double largest = 0.0;
  for (const int v : corners_around(s, c)) largest = std::max(largest, drift.of(v));
  return largest;
}

double worse_quality(const Facet& f, const Facet& g) { return std::min(quality(f), quality(g)); }

/// The limit on a flip's change of volume: smaller for better triangles, zero at `flip_quality`.
double most_volume(const Diagonals& d, const MaintenanceLimits& limits) {
  const double q = worse_quality({d.p, d.a, d.b}, {d.q, d.b, d.a});
  return limits.volume_per_operation *
         std::max(0.0, 1.0 - q / std::max(limits.flip_quality, 1e-300));
}

/// Quality is tested first: it refuses most flips and needs only one square root.
std::optional<Refusal> judge_shape(const Diagonals& d, const MaintenanceLimits& limits) {
  const std::array<Facet, 2> before{{{d.p, d.a, d.b}, {d.q, d.b, d.a}}},
      after{{{d.p, d.a, d.q}, {d.q, d.b, d.p}}};
  constexpr double least_gain = 1.1;  // of quality; prevents alternating flips due to rounding
  if (worse_quality(after[0], after[1]) <= least_gain * worse_quality(before[0], before[1]))
    return Refusal::quality;
  for (const Facet& f : before)
    for (const Facet& g : after)
      if (const auto why = judge_turn(area_vector(f), area_vector(g), limits)) return why;
  if ((d.q - d.p).norm() > limits.longest_edge) return Refusal::too_long;
  if ((d.q - d.p).norm() < limits.shortest_edge) return Refusal::too_short;
  return std::nullopt;
}

}  // namespace

Verdict judge_flip(const mesh::Surface& s, int c, const MaintenanceLimits& limits,
                   const SurfaceDrift& drift) {
  Verdict v;
  if (s.opposite_of(c) < 0) {
    v.refused = Refusal::boundary;
    return v;
  }
  const Diagonals d = diagonals(s, c);
  v.refused = judge_shape(d, limits);
  if (v.refused) return v;
  const Vec3 across = (d.b - d.a).cross(d.q - d.p);
  const double six_volumes = (d.p - d.a).dot(across);
  const double distance = std::abs(six_volumes) / std::max(across.norm(), 1e-300);
  v.volume = six_volumes / 6.0;
  v.drift = distance + largest_drift_of(s, c, drift);
  if (!mesh::flip_keeps_topology(s, c))
    v.refused = Refusal::topology;
  else if (std::abs(v.volume) > most_volume(d, limits))
    v.refused = Refusal::volume;
  else if (distance > limits.ridge_cut && is_sharp(s, c, limits))
    v.refused = Refusal::ridge;
  else if (v.drift > limits.farthest)
    v.refused = Refusal::distance;
  return v;
}

bool try_flip(Rock& rock, int c, const MaintenanceLimits& limits, SurfaceDrift& drift,
              MaintenanceReport& report) {
  mesh::Surface& s = rock.surface;
  const Verdict v = judge_flip(s, c, limits, drift);
  if (v.refused) {
    count_refused(report, Operation::flip, *v.refused);
    return false;
  }
  const auto corners = corners_around(s, c);
  for (const int w : corners) touch(rock, w);
  LocalState before;
  if constexpr (check_every_operation) before = local_state(s, {corners.begin(), corners.end()});
  mesh::flip_edge(s, c);
  drift.note(s.vertex(c), v.drift);
  drift.note(s.vertex(mesh::previous_corner(c)), v.drift);
  count_done(report, Operation::flip, v.volume);
  if constexpr (check_every_operation) require_promises_around(rock, before, v.volume, "flips");
  return true;
}

namespace {

/// Shape of the tip formed by a vertex and its triangles.
struct Tip {
  double above_highest = 1e300, above_mean = 0.0;  ///< m, above the neighbours' highest and mean
  double seen_from_above = 0.0;                    ///< m2, area in the horizontal projection
};

Tip tip_at(const mesh::Surface& s, int v) {
  Tip tip;
  int neighbours = 0;
  mesh::visit_corners(s, v, [&](int c) {
    const int w = s.vertex(mesh::next_corner(c));
    const double above = s.position(w).z() - s.position(v).z();  // z down
    tip.above_highest = std::min(tip.above_highest, above);
    tip.above_mean += above;
    tip.seen_from_above -= area_vector(facet_at(s, c)).z();
    ++neighbours;
  });
  tip.above_mean /= neighbours;
  return tip;
}

/// Whether an interior vertex is above all its neighbours.
bool tops_neighbours(const mesh::Surface& s, int v) {
  const mesh::VertexStar& star = s.star(v);
  const int* ring = s.ring(star);
  return std::all_of(ring, ring + star.size,
                     [&](int w) { return s.position(w).z() - star.x.z() > 0.0; });  // z down
}

}  // namespace

BluntVerdict judge_blunt(const mesh::Surface& s, int v, const MaintenanceLimits& limits,
                         const SurfaceDrift& drift) {
  BluntVerdict verdict;
  if (!s.is_boundary(v) && !tops_neighbours(s, v)) return verdict;  // excludes most vertices early
  const Tip tip = tip_at(s, v);
  const double shortest = limits.shortest_edge;
  verdict.is_spike = tip.above_highest > 0.0 && tip.above_mean > 0.5 * shortest &&
                     tip.seen_from_above < shortest * shortest;
  if (!verdict.is_spike) return verdict;
  const double drifted = largest_drift_around(s, v, drift);
  verdict.drop = std::min(tip.above_mean, limits.farthest - drifted);
  verdict.drift = drifted + verdict.drop;
  verdict.volume = verdict.drop * tip.seen_from_above / 3.0;
  if (s.is_boundary(v))
    verdict.refused = Refusal::boundary;
  else if (verdict.drop <= 0.0)
    verdict.refused = Refusal::distance;
  else if (std::abs(verdict.volume) > limits.volume_per_operation)
    verdict.refused = Refusal::volume;
  return verdict;
}

bool try_blunt(Rock& rock, int v, const MaintenanceLimits& limits, SurfaceDrift& drift,
               MaintenanceReport& report) {
  const BluntVerdict verdict = judge_blunt(rock.surface, v, limits, drift);
  if (!verdict.is_spike) return false;
  const Vec3 x_W = rock.surface.position(v) + Vec3(0.0, 0.0, verdict.drop);
  return move_if_accepted(rock, v, x_W, Operation::blunting, verdict, drift, report);
}

namespace {

using mesh::Facet;

/// Sums over the triangles around an interior vertex.
struct VertexRing {
  Vec3 mean_W = Vec3::Zero();  ///< of the neighbours
  Vec3 area = Vec3::Zero();    ///< sum of the area vectors, m2
};

VertexRing ring_of(const mesh::Surface& s, int v) {
  VertexRing r;
  int neighbours = 0;
  mesh::visit_corners(s, v, [&](int c) {
    r.mean_W += s.position(s.vertex(mesh::next_corner(c)));
    r.area += area_vector(facet_at(s, c));
    ++neighbours;
  });
  r.mean_W /= neighbours;
  return r;
}

std::optional<Refusal> judge_length(double length, const MaintenanceLimits& limits) {
  if (length > limits.longest_edge) return Refusal::too_long;
  if (length < limits.shortest_edge) return Refusal::too_short;
  return std::nullopt;
}

/// The guards on each triangle around v.
std::optional<Refusal> judge_triangles(const mesh::Surface& s, int v, const Vec3& x_W,
                                       const MaintenanceLimits& limits) {
  constexpr double least_gain = 1.02;  // prevents alternating moves due to rounding
  const double floor = least_gain * worst_quality(s, v);
  double swept = 0.0;  // m3
  std::optional<Refusal> why;
  mesh::visit_corners(s, v, [&](int c) {
    if (why) return;
    const Facet before = facet_at(s, c), after{x_W, before.b, before.c};
    why = judge_turn(area_vector(before), area_vector(after), limits);
    if (!why) why = judge_length((before.b - x_W).norm(), limits);
    if (!why && quality(after) <= floor) why = Refusal::quality;
    swept += std::abs(area_vector(before).dot(x_W - before.a)) / 3.0;
  });
  if (!why && swept > limits.volume_per_operation) why = Refusal::volume;
  return why;
}

/// The larger of the distance of the old place from the new triangles and that of the new place
/// from the old ones, m.
double distance_moved(const mesh::Surface& s, int v, const Vec3& x_W) {
  double old_to_new = 1e300, new_to_old = 1e300;
  mesh::visit_corners(s, v, [&](int c) {
    const Facet before = facet_at(s, c);
    old_to_new = std::min(old_to_new, mesh::squared_distance({x_W, before.b, before.c}, before.a));
    new_to_old = std::min(new_to_old, mesh::squared_distance(before, x_W));
  });
  return std::sqrt(std::max(old_to_new, new_to_old));
}

}  // namespace

SmoothVerdict judge_smooth(const mesh::Surface& s, int v, const MaintenanceLimits& limits,
                           const SurfaceDrift& drift) {
  SmoothVerdict verdict;
  if (s.is_boundary(v)) {
    verdict.refused = Refusal::boundary;
    return verdict;
  }
  if (is_on_ridge(s, v, limits)) {
    verdict.refused = Refusal::ridge;
    return verdict;
  }
  const VertexRing ring = ring_of(s, v);
  const Vec3 n = ring.area.normalized(), way = ring.mean_W - s.position(v);
  verdict.x_W = s.position(v) + (way - n.dot(way) * n);
  verdict.volume = -ring.area.dot(verdict.x_W - s.position(v)) / 3.0;
  verdict.refused = judge_triangles(s, v, verdict.x_W, limits);
  if (verdict.refused) return verdict;
  verdict.drift = largest_drift_around(s, v, drift) + distance_moved(s, v, verdict.x_W);
  if (verdict.drift > limits.farthest) verdict.refused = Refusal::distance;
  return verdict;
}

bool try_smooth(Rock& rock, int v, const MaintenanceLimits& limits, SurfaceDrift& drift,
                MaintenanceReport& report) {
  const SmoothVerdict verdict = judge_smooth(rock.surface, v, limits, drift);
  return move_if_accepted(rock, v, verdict.x_W, Operation::smoothing, verdict, drift, report);
}

}  // namespace tdbd::rock
