
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/cone/cone_measures.hpp"
#include "core/error.hpp"
#include "dynamics/drilling/chained_string.hpp"
#include "dynamics/momenta.hpp"
#include "simulation/case/drilling_settings.hpp"
#include "simulation/case/read_chain.hpp"
#include "string/statics.hpp"

namespace tdbd::simulation {
namespace {

/// Equal in both lateral directions.
Mat3 about_z(double lateral, double axial) { return Vec3(lateral, lateral, axial).asDiagonal(); }

/// m above the bit's origin; 0 without mass.
double height_of_centre(const bit::Bit& bit) {
  const double height = -bit::mass_properties(bit).centre.z();
  return std::isfinite(height) ? height : 0.0;
}

/// Makes the springs and dampers.
dynamics::DrillString springs_of(const LumpedString& s) {
  dynamics::DrillString springs;
  springs.attachment_B.z() = -s.attachment_height;
  springs.stiffness = about_z(s.lateral_stiffness, s.axial_stiffness);
  springs.damping = about_z(s.lateral_damping, s.axial_damping);
  springs.turn_stiffness = about_z(s.bending_stiffness, s.torsional_stiffness);
  springs.turn_damping = about_z(s.bending_damping, s.torsional_damping);
  springs.damper_end = s.dampers_to;
  return springs;
}

dynamics::Wall read_wall(Config& whole, double gage_radius) {
  WallSettings s;
  s.wall.ring_radius = gage_radius;  // the radius of rolling contact with a wall of rock
  s = read_table(whole, s);
  if (s.model == WallModel::ring) s.wall.ring_z_B = -s.ring_height;
  return s.wall;
}

/// Combines bit and string into one body.
void add_bodies(const LumpedString& string, const bit::Bit& bit, dynamics::DrillingSystem& s) {
  const bit::MassProperties body = bit::mass_properties(bit);
  s.mass = body.mass + string.mass;
  s.centre_B = body.centre;
  std::vector<dynamics::Cone> cones;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    cones.push_back(
        {bit.cones[k].X_BK.R.col(2), bit::cone_mass(bit, static_cast<int>(k)).axial_inertia});
  s.bearing_damping.assign(cones.size(), string.bearing_damping);
  s.gyrostat = dynamics::make_gyrostat(
      body.inertia + about_z(string.bending_inertia, string.torsional_inertia), cones);
}

/// A string that turns a bit of 8.5 in, for messages. `tdbd new drilling` writes a case with it.
constexpr const char* typical_string =
    "mass = \"1000 kg\", torsional_inertia = \"10 kg m2\", bending_inertia = \"10 kg m2\", "
    "lateral_stiffness = \"5e7 N/m\", lateral_damping = \"2e5 N s/m\", "
    "axial_damping = \"2e5 N s/m\", torsional_stiffness = \"5000 N m/rad\", "
    "torsional_damping = \"50 N m s/rad\", bending_stiffness = \"1e6 N m/rad\", "
    "bending_damping = \"1e3 N m s/rad\"";

bool turns(const dynamics::Schedule& speed) {
  return std::ranges::any_of(speed.values, [](double w) { return w != 0.0; });
}

/// Records a mistake if the case omits what connects the bit to a top that moves: all stiffnesses
/// are 0 by default, and such a bit would neither turn nor advance. A 0 that the case gives is
/// accepted.
void require_connection(Config& whole, const LumpedString& s, const dynamics::TopDrive& top) {
  const bool has_string = whole.has(LumpedString::table);
  const auto require = [&](Config& string, const char* key, const std::string& typical) {
    string.problem(key, "none, so that the string would not move the bit",
                   fmt::format("{}, or 0 if nothing connects them; `tdbd new drilling NAME` writes "
                               "a complete case",
                               typical));
  };
  const bool damped = s.dampers_to == dynamics::DamperEnd::top;
  const bool is_turned = turns(top.speed) && !(damped && s.torsional_damping > 0.0);
  const bool is_pushed = top.axial == dynamics::AxialMode::rate && turns(top.rate) &&
                         !(damped && s.axial_damping > 0.0);
  if (!has_string && (is_turned || is_pushed))
    return whole.problem(LumpedString::table.name,
                         "no table [string], so that nothing would turn the bit",
                         fmt::format("the string between the bit and its top drive, for example "
                                     "{}; `tdbd new drilling NAME` writes a complete case",
                                     typical_string));
  Config string = whole.table(LumpedString::table);
  if (is_turned && !string.has("torsional_stiffness"))
    require(string, "torsional_stiffness",
            "the stiffness through which the top turns the bit, for example \"5000 N m/rad\" "
            "(500 to 10 000 N m/rad)");
  if (is_pushed && !string.has("axial_stiffness"))
    require(string, "axial_stiffness",
            "the stiffness through which the top, lowered at a rate, loads the bit, for example "
            "\"1e6 N/m\" (2e5 to 1e7 N/m)");
}

/// Records a mistake if the string cannot carry the initial load that the case gives.
void check_start(Config c, const TopPlan& driven, const dynamics::DrillString& string) {
  if (driven.weight_at_start > 0.0 && string.stiffness(2, 2) == 0.0)
    c.problem("weight_at_start", fmt::format("{} N", driven.weight_at_start),
              "an axial stiffness that carries it");
  if (driven.torque_at_start > 0.0 && string.turn_stiffness(2, 2) == 0.0)
    c.problem("torque_at_start", fmt::format("{} N m", driven.torque_at_start),
              "a torsional stiffness that carries it");
}

/// The initial motion of the bit.
struct StartMotion {
  double rate = 0.0, rotary_speed = 0.0;  ///< m/s, rad/s
};

/// The bit turns and advances with its top, and its cones roll. The string already carries its
/// weight and torque at the start.
void set_start(const bit::Bit& bit, const Motion& m, const StartMotion& at, DrillingPlan& p) {
  dynamics::DrillingSystem& s = p.system;
  const double kz = s.string.stiffness(2, 2), kt = s.string.turn_stiffness(2, 2);
  s.string.rest_W = m.start_W + s.string.attachment_B;
  if (kz > 0.0) s.string.rest_W.z() += (m.driven.weight_at_start - s.mass * s.gravity) / kz;
  if (kt > 0.0) s.top.start_angle = m.driven.torque_at_start / kt;
  std::vector<double> spins, angles(bit.cones.size(), 0.0);
  for (const bit::Cone& cone : bit.cones)
    spins.push_back(-bit::rolling_ratio_of_gage_row(cone) * at.rotary_speed);
  p.start.rotation = dynamics::make_state(s.gyrostat, Mat3::Identity(),
                                          at.rotary_speed * Vec3::UnitZ(), spins, angles);
  p.start.c_W = m.start_W + s.centre_B;
  p.start.top_rate = at.rate;
  p.start.momentum_W =
      s.mass * (at.rate * Vec3::UnitZ() + (at.rotary_speed * Vec3::UnitZ()).cross(s.centre_B));
}

/// A chain is lowered at a rate, hangs from a force, or has an autodriller that keeps the weight.
void check_axial_drive(Config& whole, const string::Chain& chain, const TopPlan& driven) {
  if (chain.directions != string::Directions::both)
    whole.table(ChainSettings::table)
        .problem("directions", "one direction for a bit that drills", "both");
  const bool drills_itself = chain.top.axial == string::Top::Axial::autodriller;
  Config c = whole.table(Motion::table);
  if (drills_itself == (driven.top.axial == dynamics::AxialMode::load)) return;
  if (drills_itself)
    c.problem("rate_of_penetration", "a rate with string.top.axial = \"autodriller\"",
              "weight_on_bit, at the surface: the autodriller determines the rate");
  else
    c.problem("weight_on_bit", "a weight on a string with model = \"chain\"",
              "rate_of_penetration, or string.top.axial = \"autodriller\"");
}

/// There is no top motion that the dampers at the bit could follow.
void refuse_dampers_to_top(Config& c, const LumpedString& s) {
  if (s.dampers_to != dynamics::DamperEnd::top) return;
  const auto refuse = [&](const char* key, double damping) {
    if (damping != 0.0)
      c.problem(key, "a damper to the top with model = \"chain\"",
                "dampers_to = \"space\", or the damping of [string.friction]");
  };
  refuse("axial_damping", s.axial_damping);
  refuse("torsional_damping", s.torsional_damping);
}

/// The last element of the chain ends at the springs of the bit, and its last cell moves with the
/// bit. Along the hole, both have the weight of their masses. Across it only the bit and what is
/// rigidly connected to it has weight, because the wall carries the cell at the node above.
void add_chain(Config& whole, const Motion& m, ChainAbove above, DrillingPlan& p) {
  dynamics::DrillingSystem& s = p.system;
  s.chained = dynamics::ChainedString{std::move(above.chain)};
  const string::Chain& chain = s.chained->chain;
  const auto& e = chain.elements;
  s.string.stiffness(2, 2) = e.axial.back();
  s.string.turn_stiffness(2, 2) = e.torsional.back();
  s.top.axial = dynamics::AxialMode::rate;
  s.chained->surface_weight = dynamics::value_at(m.driven.top.load, 0.0);
  const Vec3 along =
      string::tangent_at(above.string.survey, string::total_length(above.string.sections));
  const double own = s.mass * s.gravity;
  const double weight = own * along.z() + chain.contact.weight.back();
  const double across = own * along.head<2>().norm();
  s.mass += e.mass.back();
  s.gravity = weight / s.mass;
  s.gravity_across = across / s.mass;
  Mat3 inertia_B = s.gyrostat.inertia_B;
  inertia_B(2, 2) += e.inertia.back();
  s.gyrostat = dynamics::make_gyrostat(inertia_B, s.gyrostat.cones);
  const bool steady = above.start == ChainStart::steady;
  const double rate = steady ? m.rate_of_penetration : 0.0, speed = steady ? m.rotary_speed : 0.0;
  // The dampers at the bit end in space. They carry a part of its weight and require torque.
  const string::SteadyMotion motion{
      rate, speed, weight - m.driven.weight_at_start - s.string.damping(2, 2) * rate,
      m.driven.torque_at_start + s.string.turn_damping(2, 2) * speed};
  const double usual = string::steady_load(chain, motion).surface.hook_load;
  const dynamics::Schedule& logged = m.driven.hook_load;
  const double hook_load = read_hook_load(whole, logged, chain, usual);
  s.chained->hook_load = is_given(logged) ? logged : dynamics::constant(hook_load);
  string::SteadyMotion off = motion;
  off.rate = 0.0;
  off.pull = weight;
  off.torque = 0.0;
  s.chained->chain.top.tare = string::steady_load(chain, off).surface.hook_load;
  p.start_motion = motion;
  p.string = std::move(above.string);
}

}  // namespace

DrillingPlan read_drilling(Config& whole, const bit::Bit& bit, const Motion& m, double step,
                           std::vector<CaseWarning>& warnings) {
  DrillingPlan p;
  p.system.top = m.driven.top;
  Config string = whole.table(LumpedString::table);
  const bool is_chain = read_string_model(string) == StringModel::chain;
  const auto lumped = read_table(whole, LumpedString{.attachment_height = height_of_centre(bit)});
  p.system.string = springs_of(lumped);
  p.system.gravity = lumped.gravity;
  if (whole.has(WallSettings::table)) p.system.wall = read_wall(whole, bit.gage_radius);
  if (whole.has(RockMountSettings::table))
    p.system.rock = read_table<RockMountSettings>(whole).rock;
  if (!is_chain) {
    require_connection(whole, lumped, m.driven.top);
    check_start(whole.table(Motion::table), m.driven, p.system.string);
  }
  if (bit.parts.empty()) return p;  // its mistakes are already recorded
  const std::size_t mistakes = whole.problem_count();
  try {
    add_bodies(lumped, bit, p.system);
    if (is_chain) {
      refuse_dampers_to_top(string, lumped);
      ChainAbove above = read_chain_above(whole, step, p.system.gyrostat.inertia_B(2, 2), warnings);
      check_axial_drive(whole, above.chain, m.driven);
      if (whole.problem_count() != mistakes) return p;
      add_chain(whole, m, std::move(above), p);
      check_chain_step(whole, step, p.system.chained->chain, p.system.mass,
                       p.system.gyrostat.inertia_B(2, 2));
    }
    const StartMotion at = is_chain ? StartMotion{p.start_motion.rate, p.start_motion.rotary_speed}
                                    : StartMotion{m.rate_of_penetration, m.rotary_speed};
    set_start(bit, m, at, p);
    if (is_chain) dynamics::start_chain(p.start_motion, p.system, p.start, p.chain);
    p.system = dynamics::make_drilling_system(p.system);
  } catch (const InputError& e) {
    string.problem("", e.what(), "a body that can move");
  }
  return p;
}

}  // namespace tdbd::simulation
