#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/error.hpp"

namespace tdbd::bit {

/// Reports why given cones do not make a bit: the cone, the key, what was found and what is
/// expected.
struct ConeBitError : InputError {
  ConeBitError(std::size_t of_cone, std::string of_key, std::string was, std::string wanted);

  std::size_t cone;  ///< index into the given cones
  std::string key;   ///< of the cone
  std::string found, expected;
};

/// Makes a roller cone bit from the layouts of its cones: their parts (cone_parts), cone by cone,
/// then the shank. With `gage_radius` (m), every cone with a gage row is moved along its journal
/// until that row reaches it (apex_for_gage). Then all cones are moved along z until the deepest
/// reach of their teeth is z = 0, the bit's origin. Any number and arrangement of cones is
/// possible. The caller checks cone_faults first. Throws InputError without cones or teeth, and
/// ConeBitError if a row cannot reach the gage or if a cone's body extends beyond it. Thesis: 1.2,
/// 3.1, fig. 3.5.
Bit cone_bit(std::string name, std::vector<ConeLayout> cones, std::optional<double> gage_radius,
             const Shank& shank);

}  // namespace tdbd::bit
