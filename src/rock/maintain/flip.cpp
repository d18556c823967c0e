#include "rock/maintain/flip.hpp"

#include <array>
#include <cmath>

#include "mesh/edit.hpp"
#include "rock/maintain/check_operation.hpp"
#include "rock/maintain/star.hpp"

namespace tdbd::rock {
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

}  // namespace tdbd::rock
