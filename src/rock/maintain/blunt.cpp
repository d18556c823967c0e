#include "rock/maintain/blunt.hpp"

#include <algorithm>
#include <cmath>

#include "rock/maintain/star.hpp"

namespace tdbd::rock {
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

}  // namespace tdbd::rock
