#include "reference/compare/models/free_string.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

using dynamics::AxialMode;
using dynamics::DamperEnd;
using dynamics::DrillingSystem;

constexpr double soft = 1e3;  // m, elongation of a spring that replaces a load

bool is_constant(const dynamics::Schedule& s) { return s.values.size() <= 1; }

/// Checks what all such models require of the case.
void check_string(const CompareCase& c, const std::string& model, StartRock rock) {
  const DrillingSystem& s = c.ours.drilling.system;
  const auto refuse = [&](const char* found, const char* needs) {
    throw InputError(fmt::format("{}: found {}, needs {}", model, found, needs));
  };
  if (!(is_constant(s.top.speed) && is_constant(s.top.rate) && is_constant(s.top.load)))
    refuse("a top whose speed, rate or load changes", "one that keeps them");
  if (c.ours.motion.start_W.head<2>().norm() > 0.0)
    refuse("motion.start beside the hole's axis", "a bit that starts on it");
  if (rock == StartRock::fits_bit && c.ours.rock.shape != simulation::RockShape::conforming)
    refuse("a rock that does not fit the bit", "rock.shape = \"conforming\"");
  if (!(s.string.turn_stiffness(2, 2) > 0.0))
    refuse("string.torsional_stiffness = 0", "a spring that turns the bit");
  if (s.top.axial == AxialMode::rate && !(s.string.stiffness(2, 2) > 0.0))
    refuse("string.axial_stiffness = 0", "a spring or motion.weight_on_bit");
}

/// Sets the axial spring and the position of its top, so that it starts with the case's load.
void set_axial(const CompareCase& c, FreeString& f) {
  const DrillingSystem& s = c.ours.drilling.system;
  const double rate = dynamics::value_at(s.top.rate, 0.0),
               load = dynamics::value_at(s.top.load, 0.0);
  double stretch = c.ours.motion.driven.weight_at_start;
  if (s.top.axial == AxialMode::load) {
    f.axial_stiffness = load / soft;
    stretch = load;
  } else {
    f.axial_stiffness = s.string.stiffness(2, 2);
    f.rate = rate;
  }
  if (s.string.damper_end == DamperEnd::top) stretch += f.axial_damping * rate;
  f.top_z = f.z + stretch / f.axial_stiffness;
}

void set_twist(const CompareCase& c, FreeString& f) {
  const DrillingSystem& s = c.ours.drilling.system;
  f.twist_stiffness = s.string.turn_stiffness(2, 2);
  f.speed = dynamics::value_at(s.top.speed, 0.0);
  double moment = c.ours.motion.driven.torque_at_start;
  if (s.string.damper_end == DamperEnd::top) moment += f.twist_damping * f.speed;
  f.top_angle = moment / f.twist_stiffness;
}

}  // namespace

FreeString free_string(const CompareCase& c, StringTerms terms, const std::string& model,
                       StartRock rock) {
  check_string(c, model, rock);
  const DrillingSystem& s = c.ours.drilling.system;
  FreeString f;
  f.mass = s.mass;
  f.inertia = s.gyrostat.inertia_B(2, 2);
  f.lateral_stiffness = s.string.stiffness(0, 0);
  f.axial_damping = s.string.damping(2, 2);
  if (terms == StringTerms::springs_and_dampers) {
    f.lateral_damping = s.string.damping(0, 0);
    f.twist_damping = s.string.turn_damping(2, 2);
  }
  f.z = c.ours.motion.start_W.z();
  f.start_rate = c.ours.motion.rate_of_penetration;
  set_axial(c, f);
  set_twist(c, f);
  return f;
}

DrillStringAndRock hanson_hansen_system(const CompareCase& c, const FreeString& s) {
  DrillStringAndRock d;
  d.mass = s.mass, d.inertia = s.inertia;
  d.damping = Vec3(s.lateral_damping, s.lateral_damping, s.axial_damping).asDiagonal();
  d.stiffness = Vec3(s.lateral_stiffness, s.lateral_stiffness, s.axial_stiffness).asDiagonal();
  d.turn_damping = s.twist_damping, d.turn_stiffness = s.twist_stiffness;
  d.rate = s.rate, d.speed = s.speed;
  const dynamics::RockMount& rock = c.ours.drilling.system.rock;
  d.rock_mass = rock.mass, d.rock_stiffness = rock.stiffness, d.rock_damping = rock.damping;
  return d;
}

std::string left_out(const CompareCase& c, StringTerms terms) {
  const DrillingSystem& s = c.ours.drilling.system;
  std::string text = "an upright bit: bending and where the string holds it are left out";
  const auto leave = [&](bool there, const char* what) {
    if (there) text += fmt::format(", {}", what);
  };
  const bool bare = terms == StringTerms::springs;
  leave(bare && s.string.damping(0, 0) > 0.0, "lateral damping");
  leave(bare && s.string.turn_damping(2, 2) > 0.0, "torsional damping");
  leave(bare && s.rock.mass > 0.0, "the rock's motion");
  const bool walled = s.wall.stiffness > 0.0;
  leave(bare && walled && s.wall.restitution < 1.0, "the wall's restitution");
  leave(walled && s.wall.friction > 0.0, "the wall's friction");
  return text;
}

}  // namespace tdbd::reference
