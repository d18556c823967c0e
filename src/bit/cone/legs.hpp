#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The table of a bit file to which a fault of legs belongs.
enum class LegTable { legs, shank, cone };

/// One reason why legs cannot be made: the key, its value, and what is expected.
struct LegFault {
  LegTable table = LegTable::legs;
  std::size_t cone = 0;  ///< index of the cone whose leg has the fault
  std::string key;
  std::string found;
  std::string expected;
};

/// Returns what prevents legs on a bit that has its cones and shank: no shank, a journal that is
/// too steep, a leg wider than its shirttail or the shank, a shirttail or an insert that reaches
/// outside the gage, a leg that does not meet the shank, heights out of order, too many inserts,
/// legs whose azimuths overlap. Empty if there is nothing. Does not test cones (leg_clearances).
std::vector<LegFault> leg_faults(const Bit& bit, const Legs& legs);

/// Number of slices across the width of a leg, besides those at the corners of the shank.
inline constexpr int usual_leg_slices = 24;

/// Appends the legs leg-1, leg-2, ... to the parts of a bit, one for each cone, and after each leg
/// its inserts leg-1/insert-1, ..., from the tip upwards. leg_faults must be empty.
///
/// A leg is the solid between the plane across the journal at `clearance` outside the shell's base,
/// the gage cylinder reduced by `under_gage`, two planes parallel to the journal at half the width
/// from it, and the cylinder of tip_radius about the journal below it. Above `shoulder` the outer
/// side inclines inwards to the shank, which it meets at `top`. The leg touches the mesh of the
/// shank, below it and at its side, without sharing volume. Frame P: x along the horizontal
/// projection of the journal, outwards; z down. Curved sides are inscribed; the error of the volume
/// is of order 2 in the number of slices.
///
/// An insert is a carbide cylinder along the radius, with a flat face. Its density is 0 because its
/// volume is counted in the leg. Thesis: 1.2 (gage pads of roller cones); the shape is not in the
/// thesis.
void add_legs(Bit& bit, const Legs& legs, int slices = usual_leg_slices);

}  // namespace tdbd::bit
