#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Whether the gap between the solids of two cutters is less than `clearance` (m, > 0). A solid is
/// the cylinder of the cutter's diameter and length behind its face. The method projects
/// alternately onto one and the other. The distance of the projections never increases, and the
/// planes normal to it that touch both solids bound the gap from below. Cutters that are still
/// undecided after many iterations count as closer; this occurs only if the gap is within a
/// micrometre of the clearance. Reads sizes and poses.
bool closer_than(const Cutter& a, const Cutter& b, double clearance);

/// Two cutters whose solids share volume, which counts twice in the mass.
struct CutterOverlap {
  int a = 0, b = 0;     ///< indices into Bit::cutters, a < b
  double volume = 0.0;  ///< m3
};

/// Returns every pair of cutters that overlap, sorted by index. A cutter's solid is the union of
/// its parts that have a density, which are convex and disjoint. So the volume is a sum over pairs
/// of parts, each part clipped by the planes of the other (mesh/shape/clip_convex.hpp). Exact for
/// the meshes, which are inscribed. Solids that only touch do not overlap.
std::vector<CutterOverlap> cutter_overlaps(const Bit& bit);

}  // namespace tdbd::bit
