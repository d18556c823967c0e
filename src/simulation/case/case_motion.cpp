#include "simulation/case/case_motion.hpp"

#include <fmt/format.h>

#include <numbers>

#include "core/error.hpp"
#include "simulation/case/path_table.hpp"

namespace tdbd::simulation {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

const std::vector<std::pair<std::string, WhirlSense>> senses{{"forward", WhirlSense::forward},
                                                             {"backward", WhirlSense::backward}};

double one_turn(double rotary_speed) { return rotary_speed > 0.0 ? two_pi / rotary_speed : 0.0; }

Whirl read_whirl(Config c, double rotary_speed) {
  Whirl w;
  w.radius = c.quantity("radius", "m", std::nullopt, Range::non_negative());
  w.frequency = c.quantity("frequency", "rad/s", std::nullopt, Range::non_negative());
  w.sense = c.choice<WhirlSense>("sense", senses, WhirlSense::backward);
  w.ramp = c.quantity("ramp", "s", one_turn(rotary_speed), Range::non_negative());
  return w;
}

Tilt read_tilt(Config c, double rotary_speed) {
  constexpr double largest = 0.5;  // rad
  Tilt t;
  t.angle = c.quantity("angle", "rad", std::nullopt, Range::within(0.0, largest));
  t.azimuth = c.quantity("azimuth", "rad", 0.0);
  t.frequency = c.quantity("frequency", "rad/s", 0.0, Range::non_negative());
  t.sense = c.choice<WhirlSense>("sense", senses, WhirlSense::forward);
  t.ramp = c.quantity("ramp", "s", one_turn(rotary_speed), Range::non_negative());
  return t;
}

Leg read_leg(Config& c) {
  Leg leg;
  leg.duration = c.quantity("duration", "s", std::nullopt, Range::positive());
  leg.velocity_W = c.vector("velocity", "m/s", Vec3(Vec3::Zero()));
  leg.rotary_speed = c.quantity("rotary_speed", "rad/s", 0.0);
  return leg;
}

/// At least one leg; legs that could not be read make no path.
void read_legs(Config& c, Motion& m) {
  std::vector<Config> tables = c.tables("legs");
  if (tables.empty()) c.problem("legs", "none", "one [[motion.legs]] or more");
  std::vector<Leg> legs;
  legs.reserve(tables.size());
  const std::size_t before = c.problem_count();
  for (Config& table : tables) legs.push_back(read_leg(table));
  if (!legs.empty() && c.problem_count() == before) m.path = path_of(legs, m.start_W);
}

void read_table(Config& c, Motion& m) {
  m.path_file = c.path("file", std::nullopt);
  if (m.path_file.empty()) return;
  try {
    m.path = read_path_table(m.path_file);
  } catch (const InputError& e) {
    c.other_file(e.what());
  }
}

void read_rolling(Config& c, const bit::Bit& bit, Motion& m) {
  constexpr double remembered_turn = 0.1;  // rad of the bit, a third of a gage row's pitch
  m.cone_drive =
      c.choice<ConeDrive>("cone_speeds", {{"rolling", ConeDrive::rolling}}, std::nullopt);
  const double usual = m.rotary_speed > 0.0 ? remembered_turn / m.rotary_speed : 0.0;
  m.cone_memory = c.quantity("cone_memory", "s", usual, Range::non_negative());
  if (bit.cones.empty() && !bit.parts.empty())
    c.problem("cone_speeds", "\"rolling\"", "a bit with cones");
}

}  // namespace

Motion read_motion(Config c) {
  Motion m;
  m.kind = c.choice<MotionKind>("kind",
                                {{"steady", MotionKind::steady},
                                 {"whirl", MotionKind::whirl},
                                 {"legs", MotionKind::legs},
                                 {"table", MotionKind::table},
                                 {"drilling", MotionKind::drilling}},
                                MotionKind::steady);
  if (m.kind == MotionKind::table) {
    read_table(c, m);
    return m;
  }
  m.start_W = c.vector("start", "m", Vec3(Vec3::Zero()));
  if (m.kind == MotionKind::legs) {
    read_legs(c, m);
    return m;
  }
  if (m.kind == MotionKind::drilling) return m;  // read_top reads the rest
  m.rotary_speed = c.quantity("rotary_speed", "rad/s", std::nullopt, Range::non_negative());
  m.rate_of_penetration = c.quantity("rate_of_penetration", "m/s", std::nullopt);
  if (m.kind == MotionKind::whirl) m.whirl = read_whirl(c.table("whirl"), m.rotary_speed);
  if (c.has("tilt")) m.tilt = read_tilt(c.table("tilt"), m.rotary_speed);
  return m;
}

void read_cone_speeds(Config c, const bit::Bit& bit, Motion& m) {
  if (c.is_text("cone_speeds")) return read_rolling(c, bit, m);
  m.cone_speeds = c.list("cone_speeds", "1", std::nullopt);
  if (m.cone_speeds.size() != bit.cones.size() && !bit.parts.empty())
    c.problem(
        "cone_speeds", fmt::format("{} speeds", m.cone_speeds.size()),
        fmt::format("one for each of the bit's {} cones, over the bit's speed", bit.cones.size()));
}

}  // namespace tdbd::simulation
