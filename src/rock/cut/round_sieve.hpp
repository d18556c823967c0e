#pragma once

#include <cstddef>
#include <vector>

#include "rock/cut/group_motion.hpp"
#include "rock/cut/hull_sieve.hpp"
#include "rock/index/near_list.hpp"

namespace tdbd::rock {

/// A cylinder about the x axis of P in single precision.
struct SingleCylinder {
  Single x_lo, x_hi, radius;
  Single radius2;  ///< negative if the radius is: the cylinder holds nothing
};

/// Selects what a round group may sweep between its two poses, and what it may touch at the end. A
/// vertex goes straight from q0 to q1 in the group's frame; the group sweeps none that stays
/// outside one end of its cylinder, or never comes to the axis as near as its radius.
struct RoundSieve {
  SingleFrame start, end;
  SingleCylinder near;          ///< holds at the end all that the others may hold
  SingleCylinder swept, inner;  ///< widened and narrowed by twice the bound of rounding
  SingleBox inner_end;          ///< the motion's region about P at the end, narrowed as well
  SingleCylinder touched;       ///< at the end; holds nothing if the gap is negative
};

/// For a list that covers the group's motion. The group must be round. `gap`: m, of what is touched.
RoundSieve make_round_sieve(const CuttingGroup& g, const GroupMotion& m, const NearList& list,
                            double gap);

/// Eight places of a list, from `begin` on. Bits: what may be swept, what certainly passes
/// keeps_outside in spite of rounding, and what may be touched.
struct SievedPack {
  int begin;
  unsigned swept, certain, touched;
};

/// Writes the packs in which something passes to the first of `packs`, in the order of the list.
/// Returns how many.
std::size_t sieve_round(const NearList& list, const RoundSieve& s, std::vector<SievedPack>& packs);

/// Whether the segment from q0 to q1 stays outside one end of a round group's cylinder, or comes
/// nowhere nearer to its axis than its radius and `slack` (m).
bool misses_cylinder(const CuttingGroup& g, const Vec3& q0_P, const Vec3& q1_P, double slack);

}  // namespace tdbd::rock
