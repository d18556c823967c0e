#include "reference/literature/drag/drag_input.hpp"

#include <cmath>

#include "core/error.hpp"

namespace tdbd::reference {

void require_cutters(const std::string& model, const std::vector<bit::Cutter>& cutters) {
  if (cutters.empty())
    throw InputError(model + ": found a bit without cutters, expected at least one cutter");
  for (const bit::Cutter& c : cutters)
    require_positive(model, "diameter of cutter " + std::to_string(c.id) + " (m)", c.diameter);
}

void require_drag_bit(const std::string& model, const bit::Bit& bit) {
  if (!bit.cones.empty())
    throw InputError(model + ": found a bit with " + std::to_string(bit.cones.size()) +
                     " cones, expected a drag bit: its cutters are fixed to it");
  require_cutters(model, bit.cutters);
}

void require_positive(const std::string& model, const std::string& what, double found) {
  if (found > 0.0 && std::isfinite(found)) return;
  throw InputError(model + ": " + what + ": found " + std::to_string(found) +
                   ", expected a number above 0");
}

void require_one_each(const std::string& model, const std::string& what, std::size_t found,
                      std::size_t cutters) {
  if (found == 0 || found == cutters) return;
  throw InputError(model + ": " + what + ": found " + std::to_string(found) +
                   " numbers, expected none or one for each of " + std::to_string(cutters) +
                   " cutters");
}

}  // namespace tdbd::reference
