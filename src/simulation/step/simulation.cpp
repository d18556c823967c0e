#include "simulation/step/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bit/cone/swept_parts.hpp"
#include "bit/cutter/cutter.hpp"
#include "core/error.hpp"
#include "simulation/start/start_check.hpp"
#include "simulation/step/step.hpp"
#include "simulation/step/wear_step.hpp"

namespace tdbd::simulation {
namespace {

bool rock_breaks_out_at(const Case& c, const Vec3& x_W) {
  if (c.forces.forces == Forces::off) return true;
  return c.spalling.beds[forces::layer_at(c.forces.rock, x_W)] != 0;
}

}  // namespace

std::optional<SpallingState> start_spalling(const SpallingPlan& plan) {
  if (!spalls(plan)) return std::nullopt;
  SpallingState s;
  s.ends.resize(plan.rules.size());
  s.broken_out.resize(plan.rules.size());
  return s;
}

std::vector<rock::Breakout> breakouts_of(const Case& c, const bit::Bit& bit,
                                         const MeasuredFaces& faces, rock::CuttingBit& cutting) {
  if (!spalls(c.spalling)) return {};
  std::vector<rock::FaceOutline> outlines;
  for (const rock::SectionFace& face : faces.faces) outlines.push_back(face.outline);
  const double beyond_sections = list_margins_for(c.measure, c.rock.edge_length).ahead;
  return rock::add_breakouts(bit, {c.spalling.rules, outlines, beyond_sections}, c.update.cutting,
                             cutting);
}

void place_breakouts(const Case& c, const Pose& X_WB, const std::vector<rock::Breakout>& breakouts,
                     const SpallingState& state, rock::CuttingBit& cutting) {
  for (const rock::Breakout& b : breakouts) {
    const bool breaks = rock_breaks_out_at(c, X_WB * bit::tip_B(c.bit.cutters[at(b.cutter)]));
    rock::place_breakout(b, breaks ? state.ends[at(b.cutter)] : rock::EngagedEnds{}, cutting);
  }
}

void follow_breakouts(const bit::Bit& bit, const rock::CutReport& cut, const Measures& measures,
                      SpallingState& state) {
  state.ends = measures.ends;
  for (std::size_t p = 0; p < cut.broken_out_by_part.size(); ++p)
    if (cut.broken_out_by_part[p] != 0.0)
      state.broken_out[at(bit.parts[p].cutter)].add(cut.broken_out_by_part[p]);
}

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
        "{}: rock.trim: found {:.4g} mm, expected at least {:.4g} mm: the height of the cutting "
        "parts and some edge lengths of wall",
        c.path, 1e3 * c.rock.trim, 1e3 * least));
  return c.rock.trim - lowest;
}

double trim(double edge_length, double plane_W, const rock::MaintenanceLimits& limits,
            rock::Rock& rock, Trimming& trimming, rock::TrimWorkspace& work) {
  if (plane_W < trimming.done_W + edge_length) return 0.0;
  rock::TrimReport report;
  rock::trim_wall(rock, trimming.done_W - 2.0 * limits.longest_edge, plane_W, work, report);
  trimming.triangles += report.triangles;
  trimming.done_W = plane_W;
  return report.volume;
}

namespace {

State start_state(const Case& c, rock::Rock rock) {
  State s;
  s.steps_done = c.time.first;
  s.place = place_at(c.motion, time_at(c.time, s.steps_done));
  if (c.motion.kind == MotionKind::drilling) {
    s.drive = start_drive(c);
    s.place = place_of(c.drilling.system, s.drive->state);
  }
  s.start_turned = s.place.turned;
  s.cones = start_cones(c);
  s.rock = std::move(rock);
  require_start_outside_rock(c, s.rock.surface);
  s.start_triangles = s.rock.surface.triangle_count();
  s.ledger.hole_start = mesh::hole_volume(s.rock.surface, Vec3::Zero());
  s.ledger.removed_by_part.resize(c.bit.parts.size());
  if (std::ranges::any_of(c.bit.parts, [](const bit::Part& p) { return p.start.has_value(); }))
    s.started.resize(c.bit.parts.size());
  s.wear = start_wear(c);
  s.spalling = start_spalling(c.spalling);
  return s;
}

}  // namespace

void prepare_parts(const Case& c, const State& state, const bit::Bit& bit, rock::CuttingBit cutting,
                   Work& work) {
  work.cutting = std::move(cutting);
  rock::turn_cones(work.cutting, c.bit, angles_of(state.cones), angles_of(state.cones));
  work.faces = prepare_measured_faces(bit, work.cutting, c.measure, c.forces.flat);
  work.breakouts = breakouts_of(c, bit, work.faces, work.cutting);
  work.rubbing = rubbing_parts(bit, c.forces, state.rock.grid.cell());
}

Work start_work(const Case& c, const State& state, rock::CuttingBit cutting) {
  Work w;
  w.limits = rock::limits_for(c.rock.edge_length, c.maintenance);
  w.trim_height = trim_height(c);
  prepare_parts(c, state, state.started.empty() ? c.bit : started_bit(c.bit, state.started),
                std::move(cutting), w);
  w.waits = any_part_waits(c.bit, state.started) ? Waits::some : Waits::none;
  w.cut_work.most_passes = c.update.most_passes;
  if (!w.faces.faces.empty())
    w.cut_work.list_margins = list_margins_for(c.measure, c.rock.edge_length);
  if (c.measure.contact == ContactMeasure::on)
    w.cut_work.contact_gap = c.measure.contact_gap * c.rock.edge_length;
  w.measures.sections = state.sections;
  if (state.spalling) w.measures.ends = state.spalling->ends;
  w.creep = creep_speeds(c.bit, c.forces);
  w.contacts = contacts_of(c.bit, c.forces);
  if (state.drive) w.drive = dynamics::drilling_work(c.drilling.system, *state.drive);
  return w;
}

Statistics start_statistics(const Case& c) {
  Statistics s;
  const double turned = angle_turned(c.motion, time_at(c.time, c.time.first));
  s.cones.assign(c.bit.cones.size(), ConeStatistics{turned, {}, 0.0, 0.0});
  if (c.measure.section != SectionMeasure::off) s.faces.revolution.resize(c.bit.cutters.size());
  if (c.forces.forces == Forces::on) reserve(s.trace, c.time.steps);
  return s;
}

Simulation start(const Case& c) {
  Simulation s = resume(c, start_state(c, start_rock(c)), start_statistics(c));
  apply_opening_forces(c, s.state, s.work);
  return s;
}

Simulation start(const Case& c, rock::CuttingBit prepared, const StartSurface& surface) {
  Simulation s;
  s.state = start_state(c, start_rock(c, surface));
  s.work = start_work(c, s.state, std::move(prepared));
  s.work.wear = wear_work(c, s.state);
  s.statistics = start_statistics(c);
  apply_opening_forces(c, s.state, s.work);
  return s;
}

Simulation resume(const Case& c, State state, Statistics statistics) {
  Simulation s;
  s.state = std::move(state);
  std::optional<WearWork> wear = wear_work(c, s.state);
  const Case& now = wear ? wear->worn : c;
  s.work = start_work(now, s.state,
                      rock::prepare_cutting_bit(
                          s.state.started.empty() ? now.bit : started_bit(now.bit, s.state.started),
                          c.update.cutting));
  s.work.wear = std::move(wear);
  s.statistics = std::move(statistics);
  return s;
}

double ledger_defect(const Simulation& simulation) {
  const State& s = simulation.state;
  const double now = mesh::hole_volume(s.rock.surface, Vec3::Zero());
  const double removed = s.ledger.removed.value(), trimmed = s.ledger.trimmed.value();
  const double scale = std::max(
      {std::abs(now), std::abs(s.ledger.hole_start), std::abs(removed), std::abs(trimmed), 1e-30});
  return std::abs(s.ledger.hole_start + removed + s.maintenance.volume_change - trimmed - now) /
         scale;
}

}  // namespace tdbd::simulation
