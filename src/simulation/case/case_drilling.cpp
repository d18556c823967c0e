#include "simulation/case/case_drilling.hpp"

#include <fmt/format.h>

#include "bit/cone/cone_measures.hpp"
#include "bit/cone/cone_rolling.hpp"
#include "core/error.hpp"
#include "dynamics/momenta.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::AxialMode;
using dynamics::Schedule;

/// A quantity, or a table of them over time: times, values, between.
Schedule read_schedule(Config& c, const std::string& key, const std::string& unit, Range range) {
  if (!c.has(key + ".values"))
    return dynamics::constant(c.quantity(key, unit, std::nullopt, range));
  using dynamics::Interpolation;
  Config table = c.table(key);
  const std::vector<double> times = table.list("times", "s", std::nullopt);
  const std::vector<double> values = table.list("values", unit, std::nullopt);
  const auto between = table.choice<Interpolation>(
      "between", {{"stepwise", Interpolation::stepwise}, {"linear", Interpolation::linear}},
      Interpolation::stepwise);
  for (const double v : values)
    if (!range.contains(v)) table.problem("values", fmt::format("{}", v), unit + range.text());
  const std::string wrong = dynamics::schedule_problem(times, values);
  if (wrong.empty()) return dynamics::make_schedule(between, times, values);
  table.problem("times", wrong, "ascending times, and as many values");
  return dynamics::constant(0.0);
}

/// The same in both lateral directions.
Mat3 about_z(double lateral, double axial) { return Vec3(lateral, lateral, axial).asDiagonal(); }

dynamics::DrillString read_string(Config c) {
  using dynamics::DamperEnd;
  const auto stiffness = [&c](const char* key, const char* unit) {
    return c.quantity(key, unit, 0.0, Range::non_negative());
  };
  dynamics::DrillString s;
  s.attachment_B.z() = -c.quantity("attachment_height", "m", 0.0);
  s.stiffness = about_z(stiffness("lateral_stiffness", "N/m"), stiffness("axial_stiffness", "N/m"));
  s.damping = about_z(stiffness("lateral_damping", "N s/m"), stiffness("axial_damping", "N s/m"));
  s.turn_stiffness = about_z(stiffness("bending_stiffness", "N m/rad"),
                             stiffness("torsional_stiffness", "N m/rad"));
  s.turn_damping = about_z(stiffness("bending_damping", "N m s/rad"),
                           stiffness("torsional_damping", "N m s/rad"));
  s.damper_end = c.choice<DamperEnd>(
      "dampers_to", {{"top", DamperEnd::top}, {"space", DamperEnd::space}}, DamperEnd::top);
  return s;
}

dynamics::Wall read_wall(Config c, double gage_radius) {
  dynamics::Wall w;
  w.stiffness = c.quantity("stiffness", "N/m", std::nullopt, Range::positive());
  w.clearance = c.quantity("clearance", "m", std::nullopt, Range::non_negative());
  w.ring_radius = c.quantity("ring_radius", "m", gage_radius, Range::positive());
  w.ring_z_B = -c.quantity("ring_height", "m", 0.0);
  w.restitution = c.quantity("restitution", "1", 1.0, Range::within(0.0, 1.0));
  w.friction = c.quantity("friction", "1", 0.0, Range::non_negative());
  w.slip_speed = c.quantity("slip_speed", "m/s", w.slip_speed, Range::non_negative());
  return w;
}

dynamics::RockMount read_rock_mount(Config c) {
  dynamics::RockMount r;
  r.mass = c.quantity("mass", "kg", std::nullopt, Range::positive());
  r.stiffness = c.quantity("stiffness", "N/m", 0.0, Range::non_negative());
  r.damping = c.quantity("damping", "N s/m", 0.0, Range::non_negative());
  return r;
}

/// Bit and string as one body.
void add_bodies(Config& c, const bit::Bit& bit, dynamics::DrillingSystem& s) {
  const bit::MassProperties body = bit::mass_properties(bit);
  const double mass = c.quantity("mass", "kg", 0.0, Range::non_negative());
  const double lateral = c.quantity("bending_inertia", "kg m2", 0.0, Range::non_negative());
  const double axial = c.quantity("torsional_inertia", "kg m2", 0.0, Range::non_negative());
  const double bearing = c.quantity("bearing_damping", "N m s/rad", 0.0, Range::non_negative());
  s.mass = body.mass + mass;
  s.centre_B = body.centre;
  std::vector<dynamics::Cone> cones;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    cones.push_back(
        {bit.cones[k].X_BK.R.col(2), bit::cone_mass(bit, static_cast<int>(k)).axial_inertia});
  s.bearing_damping.assign(cones.size(), bearing);
  s.gyrostat = dynamics::make_gyrostat(body.inertia + about_z(lateral, axial), cones);
}

/// The bit turns and goes down with its top; its cones roll; the string already carries what the
/// case says of the start.
void set_start(Config c, const bit::Bit& bit, const Motion& m, DrillingPlan& p) {
  dynamics::DrillingSystem& s = p.system;
  const double weight = c.quantity("weight_at_start", "N", 0.0, Range::non_negative());
  const double torque = c.quantity("torque_at_start", "N m", 0.0, Range::non_negative());
  const double kz = s.string.stiffness(2, 2), kt = s.string.turn_stiffness(2, 2);
  if (weight > 0.0 && kz == 0.0)
    c.problem("weight_at_start", fmt::format("{} N", weight), "an axial stiffness that carries it");
  if (torque > 0.0 && kt == 0.0)
    c.problem("torque_at_start", fmt::format("{} N m", torque),
              "a torsional stiffness that carries it");
  s.string.rest_W = m.start_W + s.string.attachment_B;
  if (kz > 0.0) s.string.rest_W.z() += (weight - s.mass * s.gravity) / kz;
  if (kt > 0.0) s.top.start_angle = torque / kt;
  std::vector<double> spins, angles(bit.cones.size(), 0.0);
  for (const bit::Cone& cone : bit.cones)
    spins.push_back(-bit::rolling_ratio_of_gage_row(cone) * m.rotary_speed);
  p.start.rotation = dynamics::make_state(s.gyrostat, Mat3::Identity(),
                                          m.rotary_speed * Vec3::UnitZ(), spins, angles);
  p.start.c_W = m.start_W + s.centre_B;
  p.start.momentum_W = s.mass * (m.rate_of_penetration * Vec3::UnitZ() +
                                 (m.rotary_speed * Vec3::UnitZ()).cross(s.centre_B));
}

}  // namespace

void read_top(Config c, dynamics::TopDrive& top, Motion& m) {
  top.speed = read_schedule(c, "rotary_speed", "rad/s", Range::non_negative());
  const bool weight = c.has("weight_on_bit");
  if (weight == c.has("rate_of_penetration"))
    c.problem("", weight ? "weight_on_bit and rate_of_penetration" : "neither",
              "weight_on_bit or rate_of_penetration");
  top.axial = weight ? AxialMode::load : AxialMode::rate;
  if (weight) top.load = read_schedule(c, "weight_on_bit", "N", Range::non_negative());
  top.rate = weight ? dynamics::constant(c.quantity("expected_rate", "m/s", 0.0))
                    : read_schedule(c, "rate_of_penetration", "m/s", {});
  m.rotary_speed = dynamics::value_at(top.speed, 0.0);
  m.rate_of_penetration = dynamics::value_at(top.rate, 0.0);
}

DrillingPlan read_drilling(Config& whole, const bit::Bit& bit, const dynamics::TopDrive& top,
                           const Motion& m) {
  DrillingPlan p;
  p.system.top = top;
  Config string = whole.table("string");
  p.system.string = read_string(string);
  p.system.gravity = whole.quantity("string.gravity", "m/s2", 9.80665);
  if (whole.has("wall")) p.system.wall = read_wall(whole.table("wall"), bit.gage_radius);
  if (whole.has("rock_mount")) p.system.rock = read_rock_mount(whole.table("rock_mount"));
  if (bit.parts.empty()) return p;  // its own mistakes are told
  try {
    add_bodies(string, bit, p.system);
    set_start(whole.table("motion"), bit, m, p);
    p.system = dynamics::make_drilling_system(p.system);
  } catch (const InputError& e) {
    string.problem("", e.what(), "a body that can move");
  }
  return p;
}

}  // namespace tdbd::simulation
