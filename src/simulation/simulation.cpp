#include "simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bit/swept_parts.hpp"
#include "core/error.hpp"
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

rock::MaintenanceLimits limits_of(const Case& c) {
  rock::MaintenanceLimits l = rock::limits_for(c.rock.edge_length);
  l.shortest_edge = c.maintenance.shortest_edge * c.rock.edge_length;
  l.longest_edge = c.maintenance.longest_edge * c.rock.edge_length;
  l.farthest = 0.5 * l.shortest_edge;
  l.worst_quality = c.maintenance.worst_quality;
  l.flip_quality = c.maintenance.flip_quality;
  l.smoothing = c.maintenance.smoothing;
  l.smooth_quality = c.maintenance.smooth_quality;
  return l;
}

/// Height of the trimming plane above the bit's origin. All that cuts stays below it.
double trim_height(const Case& c) {
  if (c.rock.trim <= 0.0) return 0.0;
  double lowest = -1e300, highest = 1e300;  // z down
  for (const bit::Part& p : bit::swept_parts(c.bit))
    for (const Vec3& x_P : p.mesh_P.positions) {
      const double z_B = (p.X_BP * x_P).z();
      lowest = std::max(lowest, z_B);
      highest = std::min(highest, z_B);
    }
  constexpr double edges_of_wall = 4.0;
  const double least = lowest - highest + edges_of_wall * c.rock.edge_length;
  if (c.rock.trim < least)
    throw InputError(fmt::format(
        "{}: rock.trim: found {:.4g} mm, expected at least {:.4g} mm: the height of what cuts, and "
        "some edges of wall",
        c.path, 1e3 * c.rock.trim, 1e3 * least));
  return c.rock.trim - lowest;
}

/// Trims once the plane has gone down by an edge since it last did.
void trim(const Case& c, double z_W, Simulation& s) {
  if (z_W < s.trimming.done_W + c.rock.edge_length) return;
  rock::TrimReport report;
  rock::trim_wall(s.rock, s.trimming.done_W - 2.0 * s.limits.longest_edge, z_W, s.trimming.work,
                  report);
  s.ledger.trimmed.add(report.volume);
  s.trimming.triangles += report.triangles;
  s.trimming.done_W = z_W;
}

}  // namespace

Simulation start(const Case& c) {
  Simulation s;
  s.steps_done = c.time.first;
  s.bit = rock::prepare_cutting_bit(c.bit, c.update.cutting);
  s.cut_work.most_passes = c.update.most_passes;
  s.cut_work.foresight = foresight_of(c.measure, c.rock.edge_length);
  s.cones = start_cones(c);
  s.measures = start_measures(c.bit, c.measure);
  s.rock = start_rock(c);
  s.limits = limits_of(c);
  s.trimming.height = trim_height(c);
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
  measure(s.rock, c.measure,
          {c.bit, s.bit, s.cut_work, s.cut, X_WB0, X_WB1, c.time.step, c.rock.edge_length,
           revolution_of(c, s.steps_done)},
          s.measures);
  ++s.steps_done;
  if (c.maintenance.every > 0 && s.steps_done % c.maintenance.every == 0) {
    rock::maintain(s.rock, s.limits, s.maintenance_work, s.maintenance);
    if (s.trimming.height > 0.0) trim(c, X_WB1.p.z() - s.trimming.height, s);
  }
}

double ledger_defect(const Simulation& s) {
  const double now = mesh::hole_volume(s.rock.surface, Vec3::Zero());
  const double removed = s.ledger.removed.value(), trimmed = s.ledger.trimmed.value();
  const double scale = std::max(
      {std::abs(now), std::abs(s.ledger.hole_start), std::abs(removed), std::abs(trimmed), 1e-30});
  return std::abs(s.ledger.hole_start + removed + s.maintenance.volume_change - trimmed - now) /
         scale;
}

}  // namespace tdbd::simulation
