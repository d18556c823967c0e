#pragma once

#include "reference/literature/drag/spokes/spoke_path.hpp"
#include "reference/literature/drag/spokes/spoke_wall.hpp"
#include "reference/literature/surface/spokes.hpp"

namespace tdbd::reference {

/// Langeveld's rock: one depth for each node of each spoke (Spokes), and the wall's radius at each
/// spoke.
struct LangeveldRock {
  Spokes bottom;
  SpokeWall wall;
};

/// Makes the bottom that a bit at rest at `start` leaves after one rotation about its axis, so that
/// it drills steadily after one revolution. Beyond its reach the rock extends up to `top` (z, m).
/// `radius` (m): of the spokes; 0: the bit's reach.
LangeveldRock fitting_rock(const std::vector<SpokeCutter>& cutters, double start, double top,
                           int spokes, int nodes, double radius = 0.0);

/// Makes flat rock at `top`, with a wall of the bit's reach.
LangeveldRock flat_rock(const std::vector<SpokeCutter>& cutters, double top, int spokes, int nodes,
                        double radius = 0.0);

/// What counts as cut. `all_above`: all rock above a rim's lower branch, which a surface with one
/// depth per radius loses (in steady drilling the areas then sum to R d). `within_rim`: only what
/// lies between the rim's branches. They differ where a rim enters a wall: a column up to the
/// wall's top, against the rim's own section.
enum class CountedRock { all_above, within_rim };

/// What a rim would cut out of a spoke, without and with cutting it.
CrossingCut rim_in_rock(const LangeveldRock& rock, int spoke, const RimEllipse& rim,
                        CountedRock counted = CountedRock::all_above);
CrossingCut cut_rock(LangeveldRock& rock, int spoke, const RimEllipse& rim,
                     CountedRock counted = CountedRock::all_above);

}  // namespace tdbd::reference
