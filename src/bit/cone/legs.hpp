#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The table of a bit file that a fault of legs belongs to.
enum class LegTable { legs, shank, cone };

/// One reason why legs cannot be made: which value, what it is, what it should be.
struct LegFault {
  LegTable table = LegTable::legs;
  std::size_t cone = 0;  ///< index of the cone whose leg has the fault
  std::string key;
  std::string found;
  std::string expected;
};

/// What prevents legs on a bit that has its cones and shank: no shank, a journal that is too steep,
/// a leg wider than its shirttail or the shank, a shirttail or an insert that reaches outside the
/// gage, a leg that does not meet the shank, heights out of order, too many inserts, legs whose
/// azimuths overlap. Empty if there are none. Cones are not looked at (leg_clearances).
std::vector<LegFault> leg_faults(const Bit& bit, const Legs& legs);

/// Slices in which a leg is drawn across its width, besides those at the corners of the shank.
inline constexpr int usual_leg_slices = 24;

/// Appends the legs to the parts of a bit, leg-1, leg-2, ..., one for each cone, and after each leg its
/// inserts leg-1/insert-1, ..., from the tip upwards. leg_faults must be empty.
///
/// A leg is the solid between the plane across the journal at `clearance` outside the shell's base, the
/// gage cylinder less `under_gage`, two planes parallel to the journal at half the width from it,
/// and the cylinder of tip_radius about the journal below it. Above `shoulder` the outer side
/// leans in to the shank, at `top`. The leg touches the mesh of the shank, below it and at its
/// side, without sharing volume. Frame P: x along the journal's horizontal, outwards; z down.
/// Curved sides are inscribed: the volume's error is of order 2 in the number of slices.
///
/// An insert is a cylinder of carbide along the radius, with a flat face. Its density is 0: its
/// volume counts in the leg. Thesis: 1.2 (gage pads of roller cones); the form is ours.
void add_legs(Bit& bit, const Legs& legs, int slices = usual_leg_slices);

}  // namespace tdbd::bit
