#pragma once

#include <vector>

#include "rock/cut/group_motion.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// @file
/// Parts that remove a share of the rock in their way and leave the rest inside themselves (ours;
/// thesis: rates of removal by area). For a vertex of the surface the pass of a group begins when the
/// group sweeps it and ends when neither it nor a neighbour in the same pass is inside a part of the
/// group any more (maintenance makes vertices between one inside and one ahead of the part). During the pass the
/// group sees it at
///   y = x + left,  where it would be if the group removed all,                               rock (22)
/// and a move of y by d by a part with the share s moves x by s d, so left grows by (1 - s) d. After
/// the pass x has come s of the way of y, whatever the steps were. left is part of the rock's state
/// (Rock::left). Where two groups are in the same rock, each removes its share of it, together at
/// most all.

/// How far beyond its place a group sees vertex v; zero: there.
Vec3 left_before(const Rock& rock, const CuttingGroup& g, int v);

/// Notes that a part of the group has moved v by d_W. Other groups in the same rock see v where they
/// did before, or at its new place if that is beyond.
void note_left(Rock& rock, const CuttingGroup& g, const CuttingPart& part, int v, const Vec3& d_W);

/// Buffers of begin_passes.
struct PassWork {
  std::vector<int> group_of_part, parts;
  std::vector<std::uint8_t> is_inside, goes_on;  ///< per vertex of Rock::left
};

/// Carries left along by what maintenance did since the last cut, and ends the passes that are over at
/// the beginning of the step. `motions`: per group of the bit. Clears Rock::carried if nothing else
/// needs it.
void begin_passes(Rock& rock, const CuttingBit& bit, const std::vector<GroupMotion>& motions,
                  PassWork& work);

/// Gives what is left to the groups of a bit that was prepared again, of which more parts cut.
void regroup_left(Rock& rock, const CuttingBit& bit);

/// Moves the vertices of Rock::left to where their group sees them, on the surface alone, and notes
/// their places; put_back undoes it.
void show_passed(Rock& rock, std::vector<Vec3>& places_W);
void put_back(Rock& rock, const std::vector<Vec3>& places_W);

}  // namespace tdbd::rock
