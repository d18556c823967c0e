#include "simulation/case/case_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "simulation/case/motion_keys.hpp"
#include "simulation/case/path_table.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::AxialMode;
using dynamics::Schedule;

double time_of_turn(double angle, double rotary_speed) {
  return rotary_speed > 0.0 ? angle / rotary_speed : 0.0;
}

double one_turn(double rotary_speed) { return time_of_turn(2.0 * std::numbers::pi, rotary_speed); }

Whirl read_whirl(Config c, double rotary_speed) {
  Whirl w;
  w.radius = c.read(whirl_keys::radius);
  w.frequency = c.read(whirl_keys::frequency);
  w.sense = c.read(whirl_keys::sense);
  w.ramp = c.read(whirl_keys::ramp, one_turn(rotary_speed));
  return w;
}

Tilt read_tilt(Config c, double rotary_speed) {
  Tilt t;
  t.angle = c.read(tilt_keys::angle);
  t.azimuth = c.read(tilt_keys::azimuth);
  t.frequency = c.read(tilt_keys::frequency);
  t.sense = c.read(tilt_keys::sense);
  t.ramp = c.read(tilt_keys::ramp, one_turn(rotary_speed));
  return t;
}

Leg read_leg(Config& c) {
  Leg leg;
  leg.duration = c.read(leg_keys::duration);
  leg.velocity_W = c.read(leg_keys::velocity);
  leg.rotary_speed = c.read(leg_keys::rotary_speed);
  return leg;
}

/// Notes the leg at whose end the bit has turned too often: a path has a row for every quarter of a
/// turn (path_of), and this many take 0.1 GB.
void check_turns(const std::vector<Leg>& legs, std::vector<Config>& tables) {
  constexpr double most_turns = 250'000.0;
  double turns = 0.0;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    turns += std::abs(legs[i].rotary_speed * legs[i].duration) / (2.0 * std::numbers::pi);
    if (!(turns > most_turns)) continue;
    return tables[i].problem(leg_keys::duration,
                             fmt::format("{:.4g} revolutions at the end of this leg", turns),
                             fmt::format("at most {} in all legs", most_turns));
  }
}

/// At least one leg; legs that could not be read make no path.
void read_legs(Config& c, Motion& m) {
  std::vector<Config> tables = c.tables(leg_keys::table);
  if (tables.empty()) c.problem("legs", "none", "one [[motion.legs]] or more");
  std::vector<Leg> legs;
  legs.reserve(tables.size());
  const std::size_t before = c.problem_count();
  for (Config& table : tables) legs.push_back(read_leg(table));
  if (c.problem_count() == before) check_turns(legs, tables);
  if (!legs.empty() && c.problem_count() == before) m.path = path_of(legs, m.start_W);
}

void read_table(Config& c, Motion& m) {
  m.path_file = c.read(motion_keys::file);
  if (m.path_file.empty()) return;
  try {
    m.path = read_path_table(m.path_file);
  } catch (const InputError& e) {
    c.other_file(e.what());
  }
}

void read_steady(Config& c, Motion& m) {
  m.rotary_speed = c.read(motion_keys::rotary_speed);
  m.rate_of_penetration = c.read(motion_keys::rate_of_penetration);
  if (m.kind == MotionKind::whirl) m.whirl = read_whirl(c.table(whirl_keys::table), m.rotary_speed);
  if (c.has(tilt_keys::table)) m.tilt = read_tilt(c.table(tilt_keys::table), m.rotary_speed);
}

/// A quantity, or a table of it over time.
Schedule read_schedule(Config& c, const QuantityKey& key) {
  const ListKey values = schedule_keys::values(key);
  if (!c.has(fmt::format("{}.{}", key.name, values.name))) return dynamics::constant(c.read(key));
  Config table = c.table(key);
  const std::vector<double> t = table.read(schedule_keys::times);
  const std::vector<double> v = table.read(values);
  const auto between = table.read(schedule_keys::between);
  for (const double x : v)
    if (!key.range.contains(x))
      table.problem(values, fmt::format("{}", x), std::string(key.unit) + key.range.text());
  const std::string wrong = dynamics::schedule_problem(t, v);
  if (wrong.empty()) return dynamics::make_schedule(between, t, v);
  table.problem(schedule_keys::times, wrong, "ascending times, and as many values");
  return dynamics::constant(0.0);
}

double fastest(const Schedule& speed) {
  return speed.values.empty() ? 0.0
                              : std::abs(*std::ranges::max_element(
                                    speed.values, {}, [](double v) { return std::abs(v); }));
}

/// The top's speed, and its rate or its weight. A prescribed motion in `m` is what the bit would do
/// if it followed its top.
void read_top(Config& c, const RigLog& log, Motion& m) {
  dynamics::TopDrive& top = m.driven.top;
  refuse_logged(c, motion_keys::rotary_speed, log.rotary_speed);
  refuse_logged(c, motion_keys::rate_of_penetration, log.block_speed);
  m.driven.hook_load = log.hook_load;
  top.speed =
      is_given(log.rotary_speed) ? log.rotary_speed : read_schedule(c, motion_keys::rotary_speed);
  const bool weight = c.has(motion_keys::weight_on_bit);
  if (weight == (c.has(motion_keys::rate_of_penetration) || is_given(log.block_speed)))
    c.problem("", weight ? "weight_on_bit and rate_of_penetration" : "neither",
              "weight_on_bit or rate_of_penetration");
  top.axial = weight ? AxialMode::load : AxialMode::rate;
  m.rotary_speed = dynamics::value_at(top.speed, 0.0);
  if (weight) {
    top.load = read_schedule(c, motion_keys::weight_on_bit);
    top.following_time = c.read(motion_keys::rate_memory, one_turn(fastest(top.speed)));
  }
  if (is_given(log.block_speed))
    top.rate = log.block_speed;
  else
    top.rate = weight ? dynamics::constant(c.read(motion_keys::expected_rate))
                      : read_schedule(c, motion_keys::rate_of_penetration);
  m.driven.weight_at_start = c.read(motion_keys::weight_at_start);
  m.driven.torque_at_start = c.read(motion_keys::torque_at_start);
  m.rate_of_penetration = dynamics::value_at(top.rate, 0.0);
}

void read_rolling(Config& c, const bit::Bit& bit, Motion& m) {
  constexpr double remembered_turn = 0.1;  // rad of the bit, well below a gage row's pitch
  m.cone_drive = c.read(motion_keys::cone_drive);
  m.cone_memory = c.read(motion_keys::cone_memory, time_of_turn(remembered_turn, m.rotary_speed));
  if (bit.cones.empty() && !bit.parts.empty())
    c.problem(motion_keys::cone_drive, "\"rolling\"", "a bit with cones");
}

/// In the rock's frame, whose origin is near the rock.
Vec3 read_start(Config& c) {
  constexpr double farthest = 1e5;  // m, more than any borehole
  const Vec3 start_W = c.read(motion_keys::start);
  if (!(start_W.cwiseAbs().maxCoeff() <= farthest))
    c.problem(motion_keys::start,
              fmt::format("[{}, {}, {}] m", start_W.x(), start_W.y(), start_W.z()),
              fmt::format("a place within {:.0e} m", farthest));
  return start_W;
}

/// "rolling", or one speed for each cone of the bit.
void read_cone_speeds(Config& c, const bit::Bit& bit, Motion& m) {
  if (bit.cones.empty() && !c.has(motion_keys::cone_speeds)) return;
  if (c.is_text(motion_keys::cone_speeds)) return read_rolling(c, bit, m);
  m.cone_speeds = c.read(motion_keys::cone_speeds);
  if (m.cone_speeds.size() != bit.cones.size() && !bit.parts.empty())
    c.problem(
        motion_keys::cone_speeds, fmt::format("{} speeds", m.cone_speeds.size()),
        fmt::format("one for each of the bit's {} cones, over the bit's speed", bit.cones.size()));
}

}  // namespace

Motion read_motion(Config c, const bit::Bit& bit, const RigLog& log) {
  Motion m;
  m.kind = c.read(motion_keys::kind);
  if (m.kind != MotionKind::table) m.start_W = read_start(c);
  switch (m.kind) {
    case MotionKind::table:
      read_table(c, m);
      break;
    case MotionKind::legs:
      read_legs(c, m);
      break;
    case MotionKind::drilling:
      read_top(c, log, m);
      return m;
    case MotionKind::steady:
    case MotionKind::whirl:
      read_steady(c, m);
  }
  read_cone_speeds(c, bit, m);
  return m;
}

}  // namespace tdbd::simulation
