#include "simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/rock_start.hpp"
#include "simulation/start_check.hpp"

namespace tdbd::simulation {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double time_of(const Case& c, long steps) { return c.time.step * static_cast<double>(steps); }

/// Revolution during which the step from `steps_done` happens: its middle decides.
std::size_t revolution_of(const Case& c, long steps_done) {
  const double middle = c.time.step * (static_cast<double>(steps_done) + 0.5);
  return static_cast<std::size_t>(std::abs(angle_turned(c.motion, middle)) /
                                  (2.0 * std::numbers::pi));
}

void note(const Case& c, Simulation& s) {
  VolumeLedger& l = s.ledger;
  const std::size_t revolution = revolution_of(c, s.steps_done);
  if (l.removed_by_revolution.size() <= revolution)
    l.removed_by_revolution.resize(revolution + 1, std::vector<double>(at(s.bit.part_count), 0.0));
  for (std::size_t i = 0; i < s.cut.removed_by_part.size(); ++i) {
    const double v = s.cut.removed_by_part[i];
    if (v == 0.0) continue;
    l.removed.add(v);
    l.removed_by_part[i].add(v);
    l.removed_by_revolution[revolution][i] += v;
  }
}

}  // namespace

Simulation start(const Case& c) {
  Simulation s;
  s.steps_done = c.time.first;
  s.bit = rock::prepare_cutting_bit(c.bit, c.update.cutting);
  s.cut_work.most_passes = c.update.most_passes;
  s.cones = start_cones(c);
  s.rock = start_rock(c);
  s.limits = rock::limits_for(c.rock.edge_length);
  s.limits.shortest_edge = c.maintenance.shortest_edge * c.rock.edge_length;
  s.limits.longest_edge = c.maintenance.longest_edge * c.rock.edge_length;
  s.limits.worst_quality = c.maintenance.worst_quality;
  demand_free_start(c, s.rock.surface);
  s.start_triangles = s.rock.surface.triangle_count();
  s.ledger.hole_start = mesh::hole_volume(s.rock.surface, Vec3::Zero());
  s.ledger.removed_by_part.resize(at(s.bit.part_count));
  return s;
}

void step(const Case& c, Simulation& s) {
  const Pose X_WB0 = pose_at(c.motion, time_of(c, s.steps_done));
  const Pose X_WB1 = pose_at(c.motion, time_of(c, s.steps_done + 1));
  if (!c.bit.cones.empty()) {
    const std::vector<double> from = angles_of(s.cones);
    turn_cones(c, s.steps_done, s.cut, s.cones);
    rock::turn_cones(s.bit, c.bit, from, angles_of(s.cones));
  }
  rock::cut_rock(s.rock, s.bit, X_WB0, X_WB1, s.cut_work, s.cut);
  note(c, s);
  ++s.steps_done;
  if (c.maintenance.every > 0 && s.steps_done % c.maintenance.every == 0)
    rock::maintain(s.rock, s.limits, s.maintenance_work, s.maintenance);
}

double ledger_defect(const Simulation& s) {
  const double now = mesh::hole_volume(s.rock.surface, Vec3::Zero());
  const double removed = s.ledger.removed.value();
  const double scale =
      std::max({std::abs(now), std::abs(s.ledger.hole_start), std::abs(removed), 1e-30});
  return std::abs(s.ledger.hole_start + removed + s.maintenance.volume_change - now) / scale;
}

}  // namespace tdbd::simulation
