#include "reference/compare/compare_tables.hpp"

#include "reference/compare/compare_keys.hpp"

namespace tdbd::reference {

std::vector<KeyTable> compare_tables() {
  using namespace compare_keys;
  return {
      key_table("compare", table,
                rows(models, counted_revolutions, weight_on_bit, circle, circle_samples, outline)),
      key_table("compare", planes_table, rows(planes, nodes)),
      key_table("compare", spokes_table, rows(spokes, spoke_nodes, spacing))};
}

}  // namespace tdbd::reference
