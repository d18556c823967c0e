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
  Single radius2;  ///< negative if the radius is negative: the cylinder is empty
};

/// Selects the vertices that a round group may sweep between its two poses, and those that it may
/// touch at the end. A vertex moves straight from q0 to q1 in the group's frame. The group sweeps
/// no vertex that stays outside one end of its cylinder or never comes within its radius of the
/// axis.
struct RoundSieve {
  SingleFrame start, end;
  SingleCylinder near;          ///< at the end; contains all places of the other cylinders
  SingleCylinder swept, inner;  ///< widened and narrowed by twice the rounding bound
  SingleBox inner_end;          ///< the motion's region in P at the end, narrowed as well
  SingleCylinder touched;       ///< at the end; empty if the gap is negative
};

/// Makes the sieve for a list that covers the group's motion. The group must be round. `gap`: m,
/// for touched vertices.
RoundSieve make_round_sieve(const CuttingGroup& g, const GroupMotion& m, const NearList& list,
                            double gap);

/// Eight places of a list, from `begin` on. Bit masks: places that may be swept, places that pass
/// keeps_outside for certain in spite of rounding, and places that may be touched.
struct SievedPack {
  int begin;
  unsigned swept, certain, touched;
};

/// Writes the packs in which any place passes to the front of `packs`, in the order of the list.
/// Returns their number.
std::size_t sieve_round(const NearList& list, const RoundSieve& s, std::vector<SievedPack>& packs);

/// Whether the segment from q0 to q1 stays outside one end of a round group's cylinder, or never
/// comes within its radius plus `slack` (m) of the axis.
bool misses_cylinder(const CuttingGroup& g, const Vec3& q0_P, const Vec3& q1_P, double slack);

}  // namespace tdbd::rock
