#include "simulation/step/late_start.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bit/cone/part_pose.hpp"
#include "core/error.hpp"
#include "core/wildcard.hpp"
#include "rock/cut/left_rock.hpp"
#include "simulation/start/start_check.hpp"
#include "simulation/step/drive.hpp"

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
  const double cover = cover_above(state.rock.surface, X_WP * middle_P(part));
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

bool any_waits(const bit::Bit& bit, const std::vector<std::uint8_t>& started) {
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
  rock::regroup_left(state.rock, work.cutting);
  work.waits = any_waits(c.bit, state.started) ? Waits::some : Waits::none;
}

}  // namespace tdbd::simulation
