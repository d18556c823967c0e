#include "simulation/step/step.hpp"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bit/cone/cone_bit.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "dynamics/drilling/stability.hpp"
#include "rock/cut/cut_rock.hpp"
#include "simulation/start/start_check.hpp"
#include "simulation/step/drive.hpp"
#include "simulation/step/wear_step.hpp"

namespace tdbd::simulation {
namespace {

/// z of the origin of the bit at the start of its motion, m.
double depth_at_begin(const Case& c) {
  const Place place = c.motion.kind == MotionKind::drilling
                          ? place_of(c.drilling.system, start_drive(c).state)
                          : place_at(c.motion, 0.0);
  return over_rock(place).p.z();
}

/// The flats are those of the last wear step.
bool has_worn(const bit::Bit& bit, const WearState& wear, const bit::LateStart& start) {
  return std::ranges::any_of(bit.parts, [&](const bit::Part& part) {
    return part.cutter >= 0 && wear.pieces[at(part.cutter)].height >= start.from &&
           fits(start.worn_names, part.name);
  });
}

bool is_due(const Case& c, const State& state, const bit::LateStart& start) {
  constexpr double middle = 0.5;  // of the step, so that rounding of times does not matter
  if (start.event == bit::StartEvent::wear) return has_worn(c.bit, *state.wear, start);
  if (start.event == bit::StartEvent::time)
    return time_at(c.time, state.steps_done) + middle * c.time.step > start.from;
  return over_rock(state.place).p.z() - depth_at_begin(c) >= start.from;
}

Vec3 middle_P(const bit::Part& part) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x_P : part.mesh_P.positions) sum += x_P;
  return sum / static_cast<double>(part.mesh_P.positions.size());
}

void require_outside(const Case& c, const State& state, const bit::Part& part) {
  const Pose X_WP = over_rock(state.place) * bit::part_pose(c.bit, part, angles_of(state.cones));
  const double cover = rock_height_above(state.rock.surface, X_WP * middle_P(part));
  if (cover > 0.0)
    throw RunError(fmt::format(
        "the middle of {} is {:.3f} mm below the rock's surface after {:g} s, when it starts to "
        "cut; rock can leave a part only if its middle is outside of it",
        part.name, 1e3 * cover, time_at(c.time, state.steps_done)));
}

}  // namespace

bit::Bit started_bit(bit::Bit bit, const std::vector<std::uint8_t>& started) {
  for (std::size_t i = 0; i < started.size(); ++i)
    if (started[i] != 0 && bit.parts[i].start) bit.parts[i].cutting = bit.parts[i].start->then;
  return bit;
}

bool any_part_waits(const bit::Bit& bit, const std::vector<std::uint8_t>& started) {
  for (std::size_t i = 0; i < started.size(); ++i)
    if (started[i] == 0 && bit.parts[i].start) return true;
  return false;
}

void start_due_parts(const Case& c, State& state, Work& work) {
  bool any = false;
  for (std::size_t i = 0; i < state.started.size(); ++i) {
    const bit::Part& part = c.bit.parts[i];
    if (!part.start || state.started[i] != 0 || !is_due(c, state, *part.start)) continue;
    if (part.start->then == bit::Cutting::cuts) require_outside(c, state, part);
    state.started[i] = 1;
    any = true;
  }
  if (!any) return;
  state.rock.near_lists.clear();  // they are stored per group of cutting parts
  const bit::Bit now = started_bit(c.bit, state.started);
  prepare_parts(c, state, now, rock::prepare_cutting_bit(now, c.update.cutting), work);
  rock::reassign_residues(state.rock, work.cutting);
  work.waits = any_part_waits(c.bit, state.started) ? Waits::some : Waits::none;
}

namespace {

/// Number of the revolution between two positions; the middle decides.
std::size_t revolution_of(const Place& from, const Place& to) {
  const double middle = 0.5 * (from.turned + to.turned);
  return static_cast<std::size_t>(std::abs(middle) / (2.0 * std::numbers::pi));
}

/// Position at the end of the step, by prescribed or free motion.
Place next_place(const Case& c, State& state, Work& work) {
  if (!state.drive) return place_at(c.motion, time_at(c.time, state.steps_done + 1));
  work.drive_before = *state.drive;
  dynamics::open_step(c.drilling.system, c.time.step, *state.drive, work.drive);
  return place_of(c.drilling.system, state.drive->state);
}

void add_to_volume_ledger(std::size_t revolution, const rock::CutReport& cut, VolumeLedger& l) {
  const std::size_t parts = cut.removed_by_part.size();
  if (l.removed_by_revolution.size() <= revolution)
    l.removed_by_revolution.resize(revolution + 1, std::vector<double>(parts, 0.0));
  for (std::size_t i = 0; i < parts; ++i) {
    const double v = cut.removed_by_part[i];
    if (v == 0.0) continue;
    l.removed.add(v);
    l.removed_by_part[i].add(v);
    l.removed_by_revolution[revolution][i] += v;
  }
}

MeasuredStep measured(const Case& c, const Move& move, const State& state, const Work& work) {
  return {c.bit,        work.cutting,       work.cut_work,    state.cut,
          move,         c.rock.edge_length, state.steps_done, state.face_paths,
          work.contacts};
}

/// Removes the component of a patch's normal along the rotation. On the leading and trailing sides
/// of a rubbing body there is rock inside it only because of the helical advance; this must not
/// change its contact force.
rock::ContactPatch without_rotational_normal(rock::ContactPatch patch, const Pose& X_WB) {
  const Vec3 axis_W = X_WB.R.col(2), around_W = axis_W.cross(patch.centroid_W - X_WB.p);
  const double length2 = around_W.squaredNorm();
  if (length2 > 0.0) patch.area_vector_W -= patch.area_vector_W.dot(around_W) / length2 * around_W;
  return patch;
}

/// Velocity at the momenta predicted from the last forces. The speed of cones is not predicted: if
/// their teeth press, the step is implicit (stand).
BitVelocity predicted_velocity(const Case& c, const Move& move, const State& state, Work& work) {
  const dynamics::DrillingSystem& system = c.drilling.system;
  return velocity_of(system, dynamics::predicted(system, move.dt, *state.drive, work.drive));
}

/// Throws RunError if the step diverged, and restores the motion before it.
void require_convergence(const Case& c, State& state, const Work& work) {
  const std::string what = dynamics::divergence(c.drilling.system, *state.drive, work.drive);
  if (what.empty()) return;
  state.drive = work.drive_before;
  state.place = place_of(c.drilling.system, state.drive->state);
  throw RunError("the motion diverges: " + what);
}

void record_loads(const Case& c, const Move& move, const State& state, const Work& work,
                  Statistics& to) {
  const std::vector<PartLoad>& parts = work.loads.parts;
  add(work.standing, to.standing);
  to.energy_by_part.resize(parts.size(), 0.0);
  for (std::size_t i = 0; i < parts.size(); ++i) to.energy_by_part[i] += parts[i].power * move.dt;
  const double since = c.time.step * static_cast<double>(state.steps_done + 1 - c.time.first);
  if (since <= c.output.means_from) return;
  const LoadedStep loaded{work.loads, work.velocity, move.X_WB1, state.cut.removed_by_part,
                          move.dt,    work.rates};
  add(loaded, to.loads);
  add(loaded, to.trace);
}

}  // namespace

void step(const Case& of_run, Simulation& s) {
  if (s.work.wear) wear_if_due(of_run, s);
  const Case& c = case_now(of_run, s.work);
  if (s.work.waits == Waits::some) start_due_parts(c, s.state, s.work);
  const Move move = drift(c, s.state, s.work);
  if (s.state.spalling)
    place_breakouts(c, move.X_WB1, s.work.breakouts, *s.state.spalling, s.work.cutting);
  cut(move, s.state, s.work);
  measure(c, move, s.state, s.work);
  if (s.state.spalling) follow_breakouts(c.bit, s.state.cut, s.work.measures, *s.state.spalling);
  apply_forces(c, move, s.state, s.work);
  kick(c, move, s.state, s.work);
  record(c, move, s);
  if (s.work.wear) measure_wear(c, move, s.state, s.work);
  ++s.state.steps_done;
  maintain(c, s.state, s.work);
  renumber(c, s.state, s.work);
}

Move drift(const Case& c, State& state, Work& work) {
  const Place from = state.place;
  const std::vector<double> angles = angles_of(state.cones);
  state.place = next_place(c, state, work);
  const Move move{over_rock(from), over_rock(state.place), c.time.step,
                  state.place.turned - from.turned, revolution_of(from, state.place)};
  if (state.drive)
    follow_cones(state.drive->state, move.dt, state.cones);
  else
    turn_cones(c, state.steps_done, state.cut, state.cones);
  rock::turn_cones(work.cutting, c.bit, angles, angles_of(state.cones));
  return move;
}

void cut(const Move& move, State& state, Work& work) {
  rock::cut_rock(state.rock, work.cutting, move.X_WB0, move.X_WB1, work.cut_work, state.cut);
  add_to_volume_ledger(move.revolution, state.cut, state.ledger);
}

void measure(const Case& c, const Move& move, State& state, Work& work) {
  if (state.drive) follow(c.bit, move, work.creep, state.face_paths);
  measure_cut(state.rock, c.measure, work.faces, measured(c, move, state, work), work.measure_work,
              work.measures);
  measure_rubbing(c, move.X_WB1, state, work);
  if (c.measure.section_every > 1 || state.drive) state.sections = work.measures.sections;
}

void measure_rubbing(const Case& c, const Pose& X_WB, const State& state, Work& work) {
  work.measures.patches.clear();
  if (c.measure.contact == ContactMeasure::off) return;
  const double edge = work.limits.longest_edge;
  const std::vector<double> angles = angles_of(state.cones);
  work.rubbing_patches.resize(work.rubbing.size());
  parallel_for(static_cast<int>(work.rubbing.size()), [&](int i) {
    rock::RubbingPart& rubbing = work.rubbing[at(i)];
    const bit::Part& part = c.bit.parts[at(rubbing.part)];
    const Pose X_WP = X_WB * bit::part_pose(c.bit, part, angles);
    // Isolated: otherwise a thread that waits within one part could start another part with the
    // same buffer.
    tbb::this_task_arena::isolate([&] {
      rock::RubbingWork& scratch = work.rubbing_work.local();
      work.measures.contacts[at(rubbing.part)].below =
          rock::rubbing_contact(state.rock, rubbing, X_WP, edge, work.cut_work, scratch);
      work.rubbing_patches[at(i)] = scratch.patches;
    });
  });
  for (std::size_t i = 0; i < work.rubbing.size(); ++i)
    for (const rock::ContactPatch& patch : work.rubbing_patches[i]) {
      const int part = work.rubbing[i].part;
      work.measures.patches.push_back(
          {part, c.bit.parts[at(part)].cone < 0 ? without_rotational_normal(patch, X_WB) : patch});
    }
}

void apply_forces(const Case& c, const Move& move, const State& state, Work& work) {
  if (c.forces.forces == Forces::off) return;
  gather_cuts(c.forces, measured(c, move, state, work), work.measures, work.cuts);
  work.standing = {};
  if (state.drive)
    work.standing = solve_implicitly({c, move.X_WB1, move.dt, *state.drive, work.cuts}, work.drive,
                                     work.standing_work, work.loads, work.velocity);
  if (work.standing.is_implicit) return;
  work.velocity = state.drive ? predicted_velocity(c, move, state, work)
                              : velocity_of(move, speeds_of(state.cones));
  sum_loads(c.forces, c.bit, move.X_WB1, work.velocity, move.dt, work.cuts, work.loads);
}

void apply_opening_forces(const Case& c, State& state, Work& work) {
  if (!state.drive || c.forces.forces == Forces::off || c.measure.contact == ContactMeasure::off)
    return;
  const Pose X_WB = over_rock(state.place);
  rock::begin_at_rest(work.cutting, X_WB, work.cut_work);
  rock::contact_areas(state.rock, work.cutting, work.cut_work,
                      {c.measure.contact_gap * c.rock.edge_length, work.contacts},
                      work.measure_work.contact, work.measures.contacts);
  measure_rubbing(c, X_WB, state, work);
  gather_touching(c.forces, c.bit, work.measures.contacts, work.cuts);
  if (work.cuts.empty()) return;
  opening_loads({c, X_WB, c.time.step, *state.drive, work.cuts}, work.drive, work.standing_work,
                work.loads);
  state.drive->wrench = wrench_of(c.drilling.system, work.loads, X_WB);
  state.drive->wrench.cone_impulse = dynamics::ConeImpulse::halves;
  work.cuts.clear();  // they belong to no step
  work.loads = {};
}

void kick(const Case& c, const Move& move, State& state, Work& work) {
  if (!state.drive) return;
  const dynamics::DrillingSystem& system = c.drilling.system;
  dynamics::close_step(system, move.dt, wrench_of(system, work.loads, move.X_WB1), *state.drive,
                       work.drive);
  require_convergence(c, state, work);
}

void record(const Case& c, const Move& move, Simulation& s) {
  add(move, s.work.measures, s.statistics.faces);
  add(move.turn, s.state.cones, s.statistics.cones);
  s.statistics.node_steps_at_rest += s.work.drive.chain.resting;
  if (c.forces.forces == Forces::off) return;
  s.work.rates = s.state.drive ? rates_of(move) : rates_of(s.work.velocity, move.X_WB1);
  record_loads(c, move, s.state, s.work, s.statistics);
}

void maintain(const Case& c, State& state, Work& work) {
  if (c.maintenance.every == 0 || state.steps_done % c.maintenance.every != 0) return;
  rock::maintain(state.rock, work.limits, work.maintenance_work, state.maintenance);
  if (work.trim_height == 0.0) return;
  const double plane_W = over_rock(state.place).p.z() - work.trim_height;
  state.ledger.trimmed.add(
      trim(c.rock.edge_length, plane_W, work.limits, state.rock, state.trimming, work.trim_work));
}

void renumber(const Case& c, State& state, Work& work) {
  constexpr double cube_over_edge = 8.0;
  const long every = c.maintenance.renumber_every;
  if (every == 0 || state.steps_done % every != 0) return;
  rock::renumber(state.rock, cube_over_edge * c.rock.edge_length, work.renumber_work);
}

}  // namespace tdbd::simulation
