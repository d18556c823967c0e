#pragma once

#include "rock/section/contact_area.hpp"

namespace tdbd::rock {

/// Whether a point (m) is in a box or within the gap (m) of its sides.
bool is_within(const mesh::Box& box, const Vec3& x, double gap);

/// Fills w.near for group i: what the step moved, and what is in the group's box at its end, that is,
/// what the step found there and what other groups moved there since; or, if that is not known, what
/// the index has. A vertex may appear twice.
void find_near(const Rock& rock, const CuttingBit& bit, const CutWorkspace& cut, std::size_t i,
               double gap, ContactScratch& w);

/// Adds to w.held what a solid of a part moved in the step or touches at its end. To be called for each
/// solid of the part, with its group's w.near and one stamp.
void hold(const Rock& rock, const CuttingGroup& g, const CuttingPart& part, double gap,
          ContactScratch& w);

}  // namespace tdbd::rock
