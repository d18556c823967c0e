#pragma once

#include <span>
#include <string_view>

namespace tdbd::reference {

/// The quantities of the comparison (one value per model), in the order of its tables.
enum class Quantity {
  weight,
  torque,
  work_of_a_turn_torque,
  rate_at_weight,
  torque_at_weight,
  imbalance,
  imbalance_direction,
  side_force,
  removed_per_revolution,
  cone_speed_ratio,
  teeth_in_contact,
  teeth_in_contact_variance,
  torque_noise,
  torque_noise_5ms,
  torque_noise_by_crossing,
  share_moved_backwards,
  resolution_at_gage,
  largest_wear_flat,
  hottest_flat,
  rate_of_penetration,
  whirl_radius
};
inline constexpr std::size_t quantity_count = 21;

/// Quantities of a part of the bit: a cutter, a tooth, a row of teeth or a cone.
enum class PartQuantity {
  area,
  volume_per_revolution,
  force_into_rock,
  drag,
  wear_flat,
  temperature,
  bending_moment,
  cone_speed_ratio,
  teeth_in_contact,
  weight,
  largest_weight
};
inline constexpr std::size_t part_quantity_count = 11;

/// Name, unit and meaning of a quantity.
struct QuantityText {
  std::string_view name, unit, meaning;
};

/// In the order of the enumerations.
std::span<const QuantityText> quantity_texts();
std::span<const QuantityText> part_quantity_texts();

const QuantityText& text_of(Quantity q);
const QuantityText& text_of(PartQuantity q);

}  // namespace tdbd::reference
