#include "simulation/case/case_drilling.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bit/cone/cone_measures.hpp"
#include "core/error.hpp"
#include "dynamics/drilling/chained_string.hpp"
#include "dynamics/momenta.hpp"
#include "simulation/case/drilling_keys.hpp"
#include "simulation/case/read_chain.hpp"
#include "string/statics.hpp"

namespace tdbd::simulation {
namespace {

/// The same in both lateral directions.
Mat3 about_z(double lateral, double axial) { return Vec3(lateral, lateral, axial).asDiagonal(); }

/// m above the bit's origin; 0 without a mass.
double height_of_centre(const bit::Bit& bit) {
  const double height = -bit::mass_properties(bit).centre.z();
  return std::isfinite(height) ? height : 0.0;
}

dynamics::DrillString read_string(Config& c, const bit::Bit& bit) {
  using namespace string_keys;
  dynamics::DrillString s;
  s.attachment_B.z() = -c.read(attachment_height, height_of_centre(bit));
  s.stiffness = about_z(c.read(lateral_stiffness), c.read(axial_stiffness));
  s.damping = about_z(c.read(lateral_damping), c.read(axial_damping));
  s.turn_stiffness = about_z(c.read(bending_stiffness), c.read(torsional_stiffness));
  s.turn_damping = about_z(c.read(bending_damping), c.read(torsional_damping));
  s.damper_end = c.read(dampers_to);
  return s;
}

/// What of the string moves with the bit, and the bearings of the cones.
struct MovingString {
  double mass, bearing_damping;  // kg, N m s/rad
  Mat3 inertia;                  // kg m2
};

MovingString read_moving_string(Config& c) {
  using namespace string_keys;
  return {c.read(mass), c.read(bearing_damping),
          about_z(c.read(bending_inertia), c.read(torsional_inertia))};
}

/// A wall of rock takes none of the keys of a ring.
void refuse_ring(Config& c) {
  using namespace wall_keys;
  const auto refuse = [&](const QuantityKey& key) {
    if (!c.has(key)) return;
    c.read(key);
    c.problem(key, "a key of a ring", "wall.model = \"ring\", or only friction and slip_speed");
  };
  for (const QuantityKey& key : {stiffness, clearance, ring_radius, ring_height, restitution})
    refuse(key);
}

dynamics::Wall read_wall(Config c, double gage_radius) {
  using namespace wall_keys;
  dynamics::Wall w;
  if (c.read(model) == WallModel::rock) {
    refuse_ring(c);
    w.ring_radius = gage_radius;  // what rolls
    return w;
  }
  w.stiffness = c.read(stiffness);
  w.clearance = c.read(clearance);
  w.ring_radius = c.read(ring_radius, gage_radius);
  w.ring_z_B = -c.read(ring_height);
  w.restitution = c.read(restitution);
  w.friction = c.read(friction);
  w.slip_speed = c.read(slip_speed);
  return w;
}

dynamics::RockMount read_rock_mount(Config c) {
  using namespace rock_mount_keys;
  return {c.read(mass), c.read(stiffness), c.read(damping)};
}

/// Bit and string as one body.
void add_bodies(const MovingString& string, const bit::Bit& bit, dynamics::DrillingSystem& s) {
  const bit::MassProperties body = bit::mass_properties(bit);
  s.mass = body.mass + string.mass;
  s.centre_B = body.centre;
  std::vector<dynamics::Cone> cones;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    cones.push_back(
        {bit.cones[k].X_BK.R.col(2), bit::cone_mass(bit, static_cast<int>(k)).axial_inertia});
  s.bearing_damping.assign(cones.size(), string.bearing_damping);
  s.gyrostat = dynamics::make_gyrostat(body.inertia + string.inertia, cones);
}

/// The string must be able to carry what the case says that it carries at the start.
void check_start(Config c, const TopPlan& driven, const dynamics::DrillString& string) {
  if (driven.weight_at_start > 0.0 && string.stiffness(2, 2) == 0.0)
    c.problem(motion_keys::weight_at_start, fmt::format("{} N", driven.weight_at_start),
              "an axial stiffness that carries it");
  if (driven.torque_at_start > 0.0 && string.turn_stiffness(2, 2) == 0.0)
    c.problem(motion_keys::torque_at_start, fmt::format("{} N m", driven.torque_at_start),
              "a torsional stiffness that carries it");
}

/// How the bit moves at the start.
struct StartMotion {
  double rate = 0.0, rotary_speed = 0.0;  ///< m/s, rad/s
};

/// The bit turns and goes down with its top; its cones roll; the string already carries its weight
/// and torque at the start.
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

/// A chain is lowered at a rate, hangs from a force, or has an autodriller for the weight.
void check_axial_drive(Config& whole, const string::Chain& chain, const TopPlan& driven) {
  if (chain.directions != string::Directions::both)
    whole.table(chain_keys::table)
        .problem(chain_keys::directions, "one direction for a bit that drills", "both");
  const bool drills_itself = chain.top.axial == string::Top::Axial::autodriller;
  Config c = whole.table(motion_keys::table);
  if (drills_itself == (driven.top.axial == dynamics::AxialMode::load)) return;
  if (drills_itself)
    c.problem(motion_keys::rate_of_penetration, "a rate with string.top.axial = \"autodriller\"",
              "weight_on_bit, at the surface: the autodriller finds the rate");
  else
    c.problem(motion_keys::weight_on_bit, "a weight on a string with model = \"chain\"",
              "rate_of_penetration, or string.top.axial = \"autodriller\"");
}

/// The dampers at the bit have no top to follow.
void refuse_dampers_to_top(Config& c, const dynamics::DrillString& s) {
  if (s.damper_end != dynamics::DamperEnd::top) return;
  for (const QuantityKey& key : {string_keys::axial_damping, string_keys::torsional_damping})
    if (c.read(key) != 0.0)
      c.problem(key, "a damper to the top with model = \"chain\"",
                "dampers_to = \"space\", or the damping of [string.friction]");
}

/// The chain ends at the springs of the bit, which are its last element. Its last cell moves with the
/// bit, and both weigh what their masses weigh along the hole. Across it only the bit and what is rigid
/// with it: the wall bears the cell at the node above.
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
  // The dampers at the bit end in space: they carry a part of its weight, and need torque.
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
  Config string = whole.table(string_keys::table);
  const bool is_chain = string.read(chain_keys::model) == StringModel::chain;
  p.system.string = read_string(string, bit);
  const MovingString moving = read_moving_string(string);
  p.system.gravity = string.read(string_keys::gravity);
  if (whole.has(wall_keys::table))
    p.system.wall = read_wall(whole.table(wall_keys::table), bit.gage_radius);
  if (whole.has(rock_mount_keys::table))
    p.system.rock = read_rock_mount(whole.table(rock_mount_keys::table));
  if (!is_chain) check_start(whole.table(motion_keys::table), m.driven, p.system.string);
  if (bit.parts.empty()) return p;  // its own mistakes are told
  const std::size_t mistakes = whole.problem_count();
  try {
    add_bodies(moving, bit, p.system);
    if (is_chain) {
      refuse_dampers_to_top(string, p.system.string);
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
