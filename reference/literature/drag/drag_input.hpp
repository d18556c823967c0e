#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// Checks of the input of drag-bit models. `model`: its name as in the literature, with which each
/// message begins. All throw InputError.

/// Requires at least one cutter, each with a positive diameter.
void require_cutters(const std::string& model, const std::vector<bit::Cutter>& cutters);

/// Requires cutters, and no cones.
void require_drag_bit(const std::string& model, const bit::Bit& bit);

/// Requires a number above 0. `what`: its name and unit.
void require_positive(const std::string& model, const std::string& what, double found);

/// Requires numbers for none or for each of the cutters.
void require_one_each(const std::string& model, const std::string& what, std::size_t found,
                      std::size_t cutters);

}  // namespace tdbd::reference
