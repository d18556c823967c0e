#pragma once

#include "rock/section/contact_area.hpp"

namespace tdbd::rock {

/// Whether a point (m) is in a box or within the gap (m) of its sides.
bool is_within(const mesh::Box& box, const Vec3& x, double gap);

/// Fills w.near for group i with the vertices that the step moved and those in the group's box at
/// the end of the step: the ones that the step found there and the ones that other groups moved
/// there. If these are not known, the index is searched. A vertex may appear twice.
void find_near(const Rock& rock, const CuttingBit& bit, const CutWorkspace& cut, std::size_t i,
               double gap, ContactScratch& w);

/// Adds to w.held the vertices that a solid of a part moved in the step or touches at its end. Must
/// be called for each solid of the part, with the w.near of its group and the same stamp.
void hold(const Rock& rock, const CuttingGroup& g, const CuttingPart& part, double gap,
          ContactScratch& w);

/// Returns the entry of a vertex in a sorted list, or null.
const PressedVertex* find_pressed(const std::vector<PressedVertex>& pressed, int v);

/// Fills work.carried with those operations of maintenance that concern a vertex in any part's
/// list.
void keep_relevant_operations(const Rock& rock, ContactWork& work);

/// Computes the vertices that the part holds and how far it has pressed them. w.inherited: what it
/// pressed after the last cut, updated by the operations of maintenance since. w.pressed and
/// w.places: the held vertices.
void update_held(const Rock& rock, const GroupMotion& m, const GroupCut& cut, int part,
                 std::span<const InterpolatedDisplacement> carried, ContactScratch& w);

}  // namespace tdbd::rock
