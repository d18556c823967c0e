#pragma once

#include "reference/literature/drag/spokes/spoke_path.hpp"
#include "reference/literature/drag/spokes/spoke_wall.hpp"
#include "reference/literature/surface/spokes.hpp"

namespace tdbd::reference {

/// Langeveld's rock: one depth for each node of each spoke (Spokes), and the wall's radius at each.
struct LangeveldRock {
  Spokes bottom;
  SpokeWall wall;
};

/// The bottom that a bit at rest at `start` fits, turned once about its axis, so that it drills
/// steadily after one revolution; beyond its reach rock stands to `top` (z, m). `radius` (m) is that
/// of the spokes; 0: the bit's reach.
LangeveldRock fitting_rock(const std::vector<SpokeCutter>& cutters, double start, double top,
                           int spokes, int nodes, double radius = 0.0);

/// Flat rock at `top`, with a wall of the bit's reach.
LangeveldRock flat_rock(const std::vector<SpokeCutter>& cutters, double top, int spokes, int nodes,
                        double radius = 0.0);

/// What counts as cut: all rock above a rim's lower branch, which a surface of one depth for each radius loses
/// (in steady drilling the areas then sum to R d), or only what lies between the rim's branches. They differ where
/// a rim goes into a wall: a column up to the wall's top, against the rim's own section.
enum class CountedRock { all_above, within_rim };

/// What a rim would cut out of a spoke; what it does cut out.
CrossingCut rim_in_rock(const LangeveldRock& rock, int spoke, const RimEllipse& rim,
                        CountedRock counted = CountedRock::all_above);
CrossingCut cut_rock(LangeveldRock& rock, int spoke, const RimEllipse& rim,
                     CountedRock counted = CountedRock::all_above);

}  // namespace tdbd::reference
