#include "simulation/case.hpp"

#include <cmath>
#include <numbers>

#include "core/hash.hpp"
#include "simulation/bit_file.hpp"
#include "simulation/path_table.hpp"

namespace tdbd::simulation {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

RockStart read_rock(Config c) {
  RockStart r;
  r.shape = c.choice<RockShape>(
      "shape",
      {{"conforming", RockShape::conforming}, {"flat", RockShape::flat}, {"file", RockShape::file}},
      RockShape::conforming);
  r.edge_length = c.quantity("edge_length", "m", std::nullopt, Range::within(1e-5, 0.1));
  if (r.shape == RockShape::file) {
    r.file = c.path("file", std::nullopt);
    r.unit = c.quantity("unit", "m", 1e-3, Range::positive());
    return r;
  }
  r.wall = c.quantity("wall", "m", 0.03, Range::non_negative());
  if (r.shape == RockShape::flat) r.radius = c.quantity("radius", "m", 0.0, Range::non_negative());
  return r;
}

Whirl read_whirl(Config c, double rotary_speed) {
  Whirl w;
  w.radius = c.quantity("radius", "m", std::nullopt, Range::non_negative());
  w.frequency = c.quantity("frequency", "rad/s", std::nullopt, Range::non_negative());
  w.sense = c.choice<WhirlSense>(
      "sense", {{"forward", WhirlSense::forward}, {"backward", WhirlSense::backward}},
      WhirlSense::backward);
  const double one_turn = rotary_speed > 0.0 ? two_pi / rotary_speed : 0.0;
  w.ramp = c.quantity("ramp", "s", one_turn, Range::non_negative());
  return w;
}

Motion read_motion(Config c) {
  Motion m;
  m.kind = c.choice<MotionKind>(
      "kind",
      {{"steady", MotionKind::steady}, {"whirl", MotionKind::whirl}, {"table", MotionKind::table}},
      MotionKind::steady);
  if (m.kind == MotionKind::table) {
    const std::string file = c.path("file", std::nullopt);
    if (!file.empty()) m.path = read_path_table(file);
    return m;
  }
  m.rotary_speed = c.quantity("rotary_speed", "rad/s", std::nullopt, Range::non_negative());
  m.rate_of_penetration = c.quantity("rate_of_penetration", "m/s", std::nullopt);
  if (m.kind == MotionKind::whirl) m.whirl = read_whirl(c.table("whirl"), m.rotary_speed);
  return m;
}

/// How long: a duration, or a number of revolutions where the rotary speed is given.
TimeGrid read_time(Config c, const Motion& m) {
  TimeGrid t;
  t.step = c.quantity("step", "s", std::nullopt, Range::positive());
  double duration = m.path.empty() ? 0.0 : m.path.back().time;
  if (c.has("revolutions") && c.has("duration"))
    c.problem("revolutions", "duration as well", "one of the two");
  if (c.has("revolutions")) {
    const double turns = c.quantity("revolutions", "1", std::nullopt, Range::positive());
    if (m.rotary_speed > 0.0)
      duration = turns * two_pi / m.rotary_speed;
    else
      c.problem("revolutions", "a motion without rotary speed", "time.duration instead");
  } else {
    const std::optional<double> fallback = m.path.empty() ? std::nullopt : std::optional(duration);
    duration = c.quantity("duration", "s", fallback, Range::positive());
  }
  if (t.step > 0.0) t.steps = std::lround(std::min(duration / t.step, 1e15));
  return t;
}

MaintenancePlan read_maintenance(Config c) {
  MaintenancePlan p;
  p.every = c.integer("every", p.every, 0, 1'000'000);
  p.shortest_edge = c.quantity("shortest_edge", "1", p.shortest_edge, Range::within(0.0, 0.7));
  p.longest_edge = c.quantity("longest_edge", "1", p.longest_edge, Range::within(1.3, 100.0));
  p.worst_quality = c.quantity("worst_quality", "1", p.worst_quality, Range::within(0.0, 0.5));
  return p;
}

OutputPlan read_output(Config c) {
  OutputPlan p;
  p.history_every = c.integer("history_every", p.history_every, 1, 1'000'000'000);
  p.frames_every = c.integer("frames_every", p.frames_every, 0, 1'000'000'000);
  return p;
}

struct Directions {
  bit::DirectionRule rule;
  bit::InsideRule inside;
};

/// The readings of eq. 4.2 (formulation 2.2).
Directions read_directions(Config c) {
  using bit::DirectionRule;
  using bit::InsideRule;
  return {c.choice<DirectionRule>("directions",
                                  {{"hybrid", DirectionRule::hybrid},
                                   {"all-down", DirectionRule::all_down},
                                   {"along-profile", DirectionRule::along_profile}},
                                  DirectionRule::hybrid),
          c.choice<InsideRule>("inside_cutters",
                               {{"down", InsideRule::down},
                                {"plus-x", InsideRule::plus_x},
                                {"minus-x", InsideRule::minus_x}},
                               InsideRule::down)};
}

}  // namespace

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  Case result;
  result.path = path;
  const std::string bit_file = c.path("bit.file", std::nullopt);
  const Directions directions = read_directions(c.table("update"));
  result.rock = read_rock(c.table("rock"));
  result.motion = read_motion(c.table("motion"));
  result.time = read_time(c.table("time"), result.motion);
  result.maintenance = read_maintenance(c.table("maintenance"));
  result.output = read_output(c.table("output"));
  c.finish();
  result.bit = read_bit(bit_file, directions.rule, directions.inside);
  result.resolved = c.resolved();
  result.hash = fnv1a_hex(result.resolved);
  return result;
}

}  // namespace tdbd::simulation
