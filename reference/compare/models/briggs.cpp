#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/roller_case.hpp"
#include "reference/literature/roller/wheel/briggs_bit.hpp"

namespace tdbd::reference {
namespace {

/// The outermost row of the bit's first cone, as a sprocket of wedges.
BriggsBit sprockets_of(const CompareCase& c, const RollerBit& bit) {
  const RollerCone& cone = bit.cones.front();
  const auto row = std::max_element(cone.rows.begin(), cone.rows.end(),
                                    [&](const RollerRow& a, const RollerRow& b) {
                                      return ring_radius(cone, a) < ring_radius(cone, b);
                                    });
  const auto index = static_cast<std::size_t>(row - cone.rows.begin());
  return briggs_bit(bit, 0, index, c.options.roller.tooth_half_angle, 2.0 * row->tooth_radius);
}

/// Mohr-Coulomb cohesion of the case's rock, with its strength under the case's pressure.
CoulombRock coulomb_rock_of(const CompareCase& c) {
  const forces::Strength& s = c.ours.forces.rock.strengths.front();
  CoulombRock rock;
  rock.friction_angle = s.friction_angle;
  rock.cohesion =
      s.confined * (1.0 - std::sin(s.friction_angle)) / (2.0 * std::cos(s.friction_angle));
  return rock;
}

void say_drilling(const BriggsDrilling& d, Findings& f) {
  say(f, Quantity::rate_at_weight, d.rate);
  say(f, Quantity::torque_at_weight, d.torque);
  say(f, Quantity::cone_speed_ratio, d.cone_ratio);
  f.notes.push_back(fmt::format(
      "one row a cone, the outermost, of wedges; it goes {:.3g} mm into the rock under the weight",
      1e3 * d.penetration));
}

}  // namespace

Findings run_briggs_model(const Question& q) {
  const CompareCase& c = q.asked;
  Findings f;
  if (q.weight > 0.0)
    say_drilling(briggs_under_weight(sprockets_of(c, roller_bit_of(c.ours.bit, "Briggs")),
                                     coulomb_rock_of(c), q.weight, c.ours.motion.rotary_speed),
                 f);
  else
    set_missing(f, Quantity::cone_speed_ratio, no_weight);
  set_missing(f, of_weight, no_weight);
  set_missing(f, {Quantity::weight, Quantity::torque, Quantity::work_of_a_turn_torque},
              "it finds the rate of a weight, not the weight of a rate");
  set_missing(f, lateral, "two-dimensional: it has no lateral forces");
  set_missing(f, noises, "a wheel's load goes up and down by teeth; three wheels have no phases");
  set_missing(f, Quantity::torque_noise_by_crossing, no_spokes);
  set_missing(f, Quantity::removed_per_revolution,
              "one row in a plane: what others leave is unknown");
  set_missing(f, of_cones, "one row: the teeth of others are unknown");
  set_missing(f, Quantity::resolution_at_gage, "it knows no hole");
  set_missing(f, Quantity::share_moved_backwards, no_cutters);
  set_missing(f, flats, no_wear);
  return f;
}

}  // namespace tdbd::reference
