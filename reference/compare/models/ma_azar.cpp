#include "reference/literature/roller/teeth/ma_azar.hpp"

#include <fmt/format.h>

#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/roller_case.hpp"
#include "reference/literature/roller/teeth/contact_statistics.hpp"

namespace tdbd::reference {

Findings answer_of_ma_azar(const Question& q) {
  const CompareCase& c = q.asked;
  const RollerBit bit = roller_bit_of(c.ours.bit, "Ma and Azar");
  const double ratio = c.options.roller.cone_ratio.value_or(outer_rolling_ratio(bit));
  const double depth = c.options.roller.penetration.value_or(c.advance);
  Findings f;
  std::vector<RowContact> contacts;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t r = 0; r < bit.cones[k].rows.size(); ++r) {
      const RollerRow& row = bit.cones[k].rows[r];
      contacts.push_back(
          row_contact(bit.cones[k], row, {depth, ratio, c.ours.motion.rotary_speed}));
      f.parts.push_back({row_name(c.ours.bit.cones[k].name, r), ring_radius(bit.cones[k], row),
                         PartQuantity::teeth_in_contact, contacts.back().mean});
    }
  const ContactStatistics all = together(contacts);
  say(f, Quantity::teeth_in_contact, all.mean);
  say(f, Quantity::teeth_in_contact_variance, all.variance);
  f.notes.push_back(fmt::format(
      "given, not found: cones at {:.4f} of the bit's speed, all rows {:.3g} mm in a flat bottom",
      ratio, 1e3 * depth));
  cannot_say(f, {Quantity::weight, Quantity::torque, Quantity::work_of_a_turn_torque},
             "kinematics and counting: it has no forces");
  cannot_say(f, of_weight, "kinematics and counting: it has no forces");
  cannot_say(f, lateral, "kinematics and counting: it has no forces");
  cannot_say(f, noises, "kinematics and counting: it has no forces");
  cannot_say(f, Quantity::torque_noise_by_crossing, no_spokes);
  cannot_say(f, Quantity::removed_per_revolution, "its bottom is flat and stays so");
  cannot_say(f, Quantity::cone_speed_ratio, "cone speeds are its input");
  cannot_say(f, Quantity::resolution_at_gage, "it keeps no bottom");
  cannot_say(f, Quantity::share_moved_backwards, no_cutters);
  cannot_say(f, flats, no_wear);
  return f;
}

}  // namespace tdbd::reference
