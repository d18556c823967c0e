#pragma once

#include <array>
#include <cstddef>

#include "rock/cut/plane_sectors.hpp"
#include "rock/cut/swept_convex.hpp"
#include "rock/cut/wide_paths.hpp"

namespace tdbd::rock {

/// The exits of four vertices from a solid. Bit l refers to vertex l.
struct WideExits {
  unsigned missed = 0;  ///< not swept
  unsigned found = 0;   ///< exits at these tau, t and row of the sector; the others are undecided
  std::array<double, lanes> tau, t, row;
  std::array<const PlaneSector*, lanes> sector;
};

/// find_exit (swept_convex.hpp) for four vertices at once, each with the planes of its own sector,
/// with the same formulas in the same order. Missed and found vertices have bitwise the result of
/// find_exit with all planes, because the planes of the sector are sufficient at every place that
/// the search examines (plane_sectors.hpp). A vertex whose search examines any other place is in
/// neither mask. `depth`: as in find_exit.
void find_exits(const PlaneSectors& sectors, const WidePaths& paths, double depth,
                WideExits& exits);

/// The exit of a found vertex l, with the plane's index in the solid.
inline Crossing crossing_of(const WideExits& exits, std::size_t l) {
  return {exits.tau[l], exits.t[l], exits.sector[l]->plane[static_cast<std::size_t>(exits.row[l])]};
}

}  // namespace tdbd::rock
