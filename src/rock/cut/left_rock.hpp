#pragma once

#include <vector>

#include "rock/cut/group_motion.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// @file
/// Parts that remove a share of the rock in their way and leave the rest [+] (thesis: rates of
/// removal by area). For a vertex of the surface, the pass of a group begins when the group sweeps
/// the vertex. It ends when neither the vertex nor a neighbour in the same pass is inside a part of
/// the group any more. (Neighbours count because maintenance creates vertices between one inside
/// and one ahead of the part.) During the pass the group sees the vertex at
///   y = x + left,  where it would be if the group removed all,                           rock (22)
/// and a part with the share s that moves y by d moves x by s d, so left grows by (1 - s) d. After
/// the pass x has moved s times the way of y, whatever the step size was. Rock::left is part of the
/// rock's state. Where two groups are in the same rock, each removes its share of it, together at
/// most all.

/// Offset of the place at which a group sees vertex v; zero if it sees the vertex where it is.
Vec3 left_before(const Rock& rock, const CuttingGroup& g, int v);

/// Records that a part of the group moved v by d_W. Other groups in the same rock see v at the same
/// place as before, or at its new place if that is beyond.
void note_left(Rock& rock, const CuttingGroup& g, const CuttingPart& part, int v, const Vec3& d_W);

/// Buffers of begin_passes.
struct PassWork {
  std::vector<int> group_of_part, parts;
  std::vector<std::uint8_t> is_inside, goes_on;  ///< per vertex of Rock::left
};

/// Updates Rock::left at the beginning of a step: applies the operations of maintenance since the
/// last cut, and ends the passes that are over. `motions`: per group of the bit. Clears
/// Rock::carried if nothing else needs it.
void begin_passes(Rock& rock, const CuttingBit& bit, const std::vector<GroupMotion>& motions,
                  PassWork& work);

/// Assigns Rock::left to the groups of a bit that was prepared again with more cutting parts.
void regroup_left(Rock& rock, const CuttingBit& bit);

/// Moves the vertices of Rock::left to where their group sees them, on the surface alone, and
/// stores their original places in `places_W`. put_back undoes it.
void show_passed(Rock& rock, std::vector<Vec3>& places_W);
void put_back(Rock& rock, const std::vector<Vec3>& places_W);

}  // namespace tdbd::rock
