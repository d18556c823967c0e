#include "reference/compare/compare_tables.hpp"

#include "reference/compare/compare_keys.hpp"

namespace tdbd::reference {

std::vector<KeyTable> compare_tables() {
  using namespace compare_keys;
  return {
      key_table("compare", table,
                rows(models, counted_revolutions, weight_on_bit, circle, circle_samples, outline)),
      key_table("compare", planes_table, rows(planes, nodes)),
      key_table("compare", spokes_table, rows(spokes, spoke_nodes, spacing)),
      key_table("compare", glowka_table,
                rows(power, reference_depth, flat_stress, wear_coefficient, distance, flat_friction,
                     rock_conductivity, rock_diffusivity, cutter_resistance)),
      key_table("compare", roller_table,
                rows(specific_energy, normal_ratio, half_angle, tooth_table, penetration,
                     cone_ratio, tooth_half_angle)),
      key_table("compare", winters_table, rows(weights, rates, strength))};
}

}  // namespace tdbd::reference
