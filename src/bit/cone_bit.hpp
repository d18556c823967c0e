#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The steel above the cones: a cylinder about the bit's axis that never cuts and stands for legs
/// and shank alike. Lengths in m.
struct Shank {
  double radius = 0.0;  ///< 0: none
  double length = 0.0;
  double height = 0.0;  ///< of its lower end above the bit's origin
  double density = 7850.0;
};

/// A roller cone bit from its drawn cones: their parts (cone_parts), cone after cone, then the
/// shank. With `gage_radius` every cone that has a row at the gage is moved along its journal until
/// that row reaches it (apex_for_gage). Then all cones are moved along z until the deepest reach of
/// their teeth is z = 0, the bit's origin. Any number of cones in any arrangement; cone_faults are
/// the caller's to ask for. Throws InputError without cones or teeth, when a row cannot reach the
/// gage, or when a cone's body stands out beyond the gage. Thesis: 1.2, 3.1, fig. 3.5.
Bit cone_bit(std::string name, std::vector<ConeLayout> cones, std::optional<double> gage_radius,
             const Shank& shank);

}  // namespace tdbd::bit
