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

/// The entry of a vertex in a sorted list, or null.
const PressedVertex* find_pressed(const std::vector<PressedVertex>& pressed, int v);

/// Fills work.carried: of what maintenance did, that which concerns a vertex of any part's list.
void keep_concerned(const Rock& rock, ContactWork& work);

/// Notes what the part holds and by how much it has pressed it: w.inherited is what it pressed after the
/// last cut, carried along by what maintenance did since; w.pressed and w.places have the held vertices.
void take_held(const Rock& rock, const GroupMotion& m, const GroupCut& cut, int part,
               std::span<const CarriedDisplacement> carried, ContactScratch& w);

}  // namespace tdbd::rock
