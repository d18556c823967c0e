#include "rock/maintain/smooth.hpp"

#include <algorithm>
#include <cmath>

#include "rock/maintain/star.hpp"

namespace tdbd::rock {
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
