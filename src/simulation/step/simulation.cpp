#include "simulation/step/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/start/rock_start.hpp"
#include "simulation/start/start_check.hpp"
#include "simulation/step/force_step.hpp"

namespace tdbd::simulation {
namespace {

double time_of(const Case& c, long steps) { return c.time.step * static_cast<double>(steps); }

/// Revolution during which the bit goes from one place to another: the middle decides.
std::size_t revolution_of(const Place& from, const Place& to) {
  const double middle = 0.5 * (from.turned + to.turned);
  return static_cast<std::size_t>(std::abs(middle) / (2.0 * std::numbers::pi));
}

void note(std::size_t revolution, Simulation& s) {
  VolumeLedger& l = s.ledger;
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
  l.untangle_farthest = 2.0 * l.shortest_edge;
  l.worst_quality = c.maintenance.worst_quality;
  l.flip_quality = c.maintenance.flip_quality;
  l.smoothing = c.maintenance.smoothing;
  l.smooth_quality = c.maintenance.smooth_quality;
  return l;
}

/// Takes the bit to the end of the step: along its motion, or as forces move it.
void advance(const Case& c, Simulation& s) {
  const Place from = s.place;
  if (s.drive) {
    s.drive_before = *s.drive;
    dynamics::open_step(c.drilling.system, c.time.step, *s.drive);
    s.place = place_of(c.drilling.system, s.drive->state);
  } else {
    s.place = place_at(c.motion, time_of(c, s.steps_done + 1));
  }
  if (c.bit.cones.empty()) return;
  const std::vector<double> angles = angles_of(s.cones);
  if (s.drive)
    follow_cones(s.drive->state, c.time.step, s.place.turned - from.turned, s.cones);
  else
    turn_cones(c, s.steps_done, s.cut, s.cones);
  rock::turn_cones(s.bit, c.bit, angles, angles_of(s.cones));
}

}  // namespace

Simulation start(const Case& c) {
  Simulation s;
  s.steps_done = c.time.first;
  s.place = place_at(c.motion, time_of(c, s.steps_done));
  if (c.motion.kind == MotionKind::drilling) {
    s.drive = start_drive(c);
    s.place = place_of(c.drilling.system, s.drive->state);
  }
  s.start_turned = s.place.turned;
  if (c.forces.forces == Forces::on) reserve(s.trace, c.time.steps);
  s.bit = rock::prepare_cutting_bit(c.bit, c.update.cutting);
  s.cut_work.most_passes = c.update.most_passes;
  s.cut_work.list_margins = foresight_of(c.measure, c.rock.edge_length);
  if (c.measure.contact == ContactMeasure::on)
    s.cut_work.contact_gap = c.measure.contact_gap * c.rock.edge_length;
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
  const Place from = s.place;
  advance(c, s);
  const MeasuredStep moved = {c.bit,
                              s.bit,
                              s.cut_work,
                              s.cut,
                              over_rock(from),
                              over_rock(s.place),
                              c.time.step,
                              c.rock.edge_length,
                              revolution_of(from, s.place)};
  rock::cut_rock(s.rock, s.bit, moved.X_WB0, moved.X_WB1, s.cut_work, s.cut);
  note(moved.revolution, s);
  measure(s.rock, c.measure, moved, s.measures);
  if (c.forces.forces == Forces::on) ask_forces(c, moved, s);
  ++s.steps_done;
  if (c.maintenance.every > 0 && s.steps_done % c.maintenance.every == 0) {
    rock::maintain(s.rock, s.limits, s.maintenance_work, s.maintenance);
    s.ledger.trimmed.add(trim(c, moved.X_WB1.p.z(), s.limits, s.rock, s.trimming));
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
