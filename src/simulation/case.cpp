#include "simulation/case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "bit/tooth_directions.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "simulation/bit_file.hpp"
#include "simulation/path_table.hpp"

namespace tdbd::simulation {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// Reads another file; its mistakes join those of the case.
template <class Read>
void collect(Config& c, Read read) {
  try {
    read();
  } catch (const InputError& e) {
    c.other_file(e.what());
  }
}

RockStart read_rock(Config c) {
  RockStart r;
  r.shape = c.choice<RockShape>(
      "shape",
      {{"conforming", RockShape::conforming}, {"flat", RockShape::flat}, {"file", RockShape::file}},
      RockShape::conforming);
  r.edge_length = c.quantity("edge_length", "m", std::nullopt, Range::within(1e-5, 0.1));
  r.trim = c.quantity("trim", "m", 0.0, Range::non_negative());
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
    if (!file.empty()) collect(c, [&] { m.path = read_path_table(file); });
    return m;
  }
  m.rotary_speed = c.quantity("rotary_speed", "rad/s", std::nullopt, Range::non_negative());
  m.rate_of_penetration = c.quantity("rate_of_penetration", "m/s", std::nullopt);
  if (m.kind == MotionKind::whirl) m.whirl = read_whirl(c.table("whirl"), m.rotary_speed);
  return m;
}

/// How long: a duration, or a number of revolutions where the rotary speed is given; along a path
/// as long as the path.
double read_duration(Config& c, const Motion& m) {
  if (!c.has("revolutions")) {
    std::optional<double> fallback;
    if (m.kind == MotionKind::table) fallback = m.path.empty() ? 1.0 : m.path.back().time;
    return c.quantity("duration", "s", fallback, Range::positive());
  }
  const double turns = c.quantity("revolutions", "1", std::nullopt, Range::positive());
  if (c.has("duration")) {
    c.quantity("duration", "s", std::nullopt, Range::positive());
    c.problem("revolutions", "duration as well", "one of the two");
  }
  if (m.rotary_speed > 0.0) return turns * two_pi / m.rotary_speed;
  c.problem("revolutions", "a motion without rotary speed", "time.duration instead");
  return std::numeric_limits<double>::infinity();
}

/// A step is a small part of the motion: the rock is swept along straight lines in the bit's frame.
TimeGrid read_time(Config c, const Motion& m) {
  constexpr double largest_turn = 0.5;  // rad
  constexpr double most_steps = 1e15;
  TimeGrid t;
  t.step = c.quantity("step", "s", std::nullopt, Range::positive());
  const double duration = read_duration(c, m);
  t.steps = std::lround(std::min(duration / t.step, most_steps));
  if (!c.has("step")) return t;
  if (t.steps < 1)
    c.problem("step", fmt::format("{} s for a run of {} s", t.step, duration),
              "at most the duration");
  else if (m.rotary_speed * t.step > largest_turn)
    c.problem("step", fmt::format("a turn of {:.3g} rad in one step", m.rotary_speed * t.step),
              fmt::format("at most {} rad", largest_turn));
  return t;
}

MaintenancePlan read_maintenance(Config c) {
  MaintenancePlan p;
  p.every = c.integer("every", p.every, 0, 1'000'000);
  p.shortest_edge = c.quantity("shortest_edge", "1", p.shortest_edge, Range::within(0.0, 0.7));
  p.longest_edge = c.quantity("longest_edge", "1", p.longest_edge, Range::within(1.3, 100.0));
  p.worst_quality = c.quantity("worst_quality", "1", p.worst_quality, Range::within(0.0, 0.5));
  p.flip_quality = c.quantity("flip_quality", "1", p.flip_quality, Range::within(0.0, 1.0));
  p.smoothing = c.choice<rock::Smoothing>(
      "smoothing", {{"off", rock::Smoothing::off}, {"tangential", rock::Smoothing::tangential}},
      p.smoothing);
  p.smooth_quality = c.quantity("smooth_quality", "1", p.smooth_quality, Range::within(0.0, 1.0));
  return p;
}

MeasurePlan read_measure(Config c) {
  MeasurePlan p;
  p.section = c.choice<SectionMeasure>(
      "section", {{"ahead", SectionMeasure::ahead}, {"off", SectionMeasure::off}}, p.section);
  p.section_lead = c.quantity("section_lead", "1", p.section_lead, Range::within(0.1, 10.0));
  p.contact = c.choice<ContactMeasure>(
      "contact", {{"on", ContactMeasure::on}, {"off", ContactMeasure::off}}, p.contact);
  p.contact_gap = c.quantity("contact_gap", "1", p.contact_gap, Range::within(1e-6, 1.0));
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
  bit::GageRule gage;
};

/// The readings of eq. 4.2, and of its counterpart for roller cones (formulation 2.2, 2.3).
Directions read_directions(Config c) {
  using bit::DirectionRule;
  using bit::GageRule;
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
                               InsideRule::down),
          c.choice<GageRule>("gage_teeth",
                             {{"normal", GageRule::normal},
                              {"row", GageRule::row},
                              {"down", GageRule::down},
                              {"horizontal", GageRule::horizontal}},
                             GageRule::normal)};
}

/// The case's bit, once all else is read, so that the mistakes of both come together.
BitFile read_bit_of(Config& c) {
  const std::string file = c.path("bit.file", std::nullopt);
  const Directions directions = read_directions(c.table("update"));
  BitFile bit;
  if (!file.empty()) collect(c, [&] { bit = read_bit(file, directions.rule, directions.inside); });
  bit::direct_teeth(bit.bit, directions.gage);
  return bit;
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

/// "rolling", or one speed for each cone of the bit; a bit without parts could not be read.
void read_cone_speeds(Config c, const bit::Bit& bit, Motion& m) {
  if (c.is_text("cone_speeds")) return read_rolling(c, bit, m);
  m.cone_speeds = c.list("cone_speeds", "1", std::nullopt);
  if (m.cone_speeds.size() != bit.cones.size() && !bit.parts.empty())
    c.problem(
        "cone_speeds", fmt::format("{} speeds", m.cone_speeds.size()),
        fmt::format("one for each of the bit's {} cones, over the bit's speed", bit.cones.size()));
}

}  // namespace

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  Case result;
  result.path = path;
  result.rock = read_rock(c.table("rock"));
  result.motion = read_motion(c.table("motion"));
  result.time = read_time(c.table("time"), result.motion);
  result.maintenance = read_maintenance(c.table("maintenance"));
  result.measure = read_measure(c.table("measure"));
  result.output = read_output(c.table("output"));
  const BitFile bit = read_bit_of(c);
  if (!bit.bit.cones.empty() || c.has("motion.cone_speeds"))
    read_cone_speeds(c.table("motion"), bit.bit, result.motion);
  c.finish();
  result.bit = bit.bit;
  result.files = c.files();
  result.files.insert(result.files.end(), bit.files.begin(), bit.files.end());
  result.resolved = c.resolved();
  result.quantities = c.quantities();
  result.hash = fnv1a_hex(c.fingerprint() + bit.fingerprint);
  return result;
}

}  // namespace tdbd::simulation
