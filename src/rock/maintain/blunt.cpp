#include "rock/maintain/blunt.hpp"

#include <algorithm>
#include <cmath>

#include "rock/maintain/check_operation.hpp"
#include "rock/maintain/star.hpp"

namespace tdbd::rock {
namespace {

/// What the triangles around a vertex say about it as a tip.
struct Tip {
  double above_highest = 1e300, above_mean = 0.0;  ///< m, of the neighbours
  double seen_from_above = 0.0;                    ///< m2
  double stray = 0.0;                              ///< m, largest
};

Tip tip_at(const mesh::Surface& s, int v, const Strays& strays) {
  Tip tip;
  tip.stray = strays.of(v);
  int neighbours = 0;
  mesh::visit_corners(s, v, [&](int c) {
    const int w = s.vertex(mesh::next_corner(c));
    const double above = s.position(w).z() - s.position(v).z();  // z down
    tip.above_highest = std::min(tip.above_highest, above);
    tip.above_mean += above;
    tip.seen_from_above -= area_vector(facet_at(s, c)).z();
    tip.stray = std::max(tip.stray, strays.of(w));
    ++neighbours;
  });
  tip.above_mean /= neighbours;
  return tip;
}

}  // namespace

BluntVerdict judge_blunt(const mesh::Surface& s, int v, const MaintenanceLimits& limits,
                         const Strays& strays) {
  BluntVerdict verdict;
  const Tip tip = tip_at(s, v, strays);
  const double shortest = limits.shortest_edge;
  verdict.is_spike = tip.above_highest > 0.0 && tip.above_mean > 0.5 * shortest &&
                     tip.seen_from_above < shortest * shortest;
  if (!verdict.is_spike) return verdict;
  verdict.drop = std::min(tip.above_mean, limits.farthest - tip.stray);
  verdict.stray = tip.stray + verdict.drop;
  verdict.volume = verdict.drop * tip.seen_from_above / 3.0;
  if (s.is_boundary(v))
    verdict.refused = Refusal::boundary;
  else if (verdict.drop <= 0.0)
    verdict.refused = Refusal::distance;
  else if (std::abs(verdict.volume) > limits.volume_per_operation)
    verdict.refused = Refusal::volume;
  return verdict;
}

bool try_blunt(Rock& rock, int v, const MaintenanceLimits& limits, Strays& strays,
               MaintenanceReport& report) {
  const BluntVerdict verdict = judge_blunt(rock.surface, v, limits, strays);
  if (!verdict.is_spike) return false;
  if (verdict.refused) {
    note_refused(report, Operation::blunting, *verdict.refused);
    return false;
  }
  LocalState before;
  if constexpr (check_every_operation) before = local_state(rock.surface, {v});
  place_vertex(rock, v, rock.surface.position(v) + Vec3(0.0, 0.0, verdict.drop));
  strays.note(v, verdict.stray);
  note_done(report, Operation::blunting, verdict.volume);
  if constexpr (check_every_operation) demand_around(rock, before, verdict.volume, "bluntings");
  return true;
}

}  // namespace tdbd::rock
