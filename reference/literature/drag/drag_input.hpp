#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// What a model of drag bits can take. `model`: its name as the literature has it, with which each
/// message begins. They throw InputError.

/// At least one cutter, each with a positive diameter.
void require_cutters(const std::string& model, const std::vector<bit::Cutter>& cutters);

/// Cutters, and no cones.
void require_drag_bit(const std::string& model, const bit::Bit& bit);

/// A number above 0; `what` names it with its unit.
void require_positive(const std::string& model, const std::string& what, double found);

/// Numbers for none or for each of the cutters.
void require_one_each(const std::string& model, const std::string& what, std::size_t found,
                      std::size_t cutters);

}  // namespace tdbd::reference
