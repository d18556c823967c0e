#pragma once

#include <array>
#include <cstddef>

#include "rock/cut/plane_sectors.hpp"
#include "rock/cut/swept_convex.hpp"
#include "rock/cut/wide_paths.hpp"

namespace tdbd::rock {

/// The exits of four vertices from a solid. Bit l stands for vertex l.
struct WideExits {
  unsigned missed = 0;  ///< not swept
  unsigned found = 0;   ///< left at these tau, t, and row of their sector; the others are not known
  std::array<double, lanes> tau, t, row;
  std::array<const PlaneSector*, lanes> sector;
};

/// find_exit (swept_convex.hpp) for four vertices at once, each with the planes of its own sector: the
/// same formulas in the same order. What is missed or found is bitwise what find_exit gives with all
/// planes, because each place at which the search looks is one for which the planes of the sector are
/// enough (plane_sectors.hpp). A vertex whose search looks elsewhere is neither missed nor found.
/// `depth`: as in find_exit.
void find_exits(const PlaneSectors& sectors, const WidePaths& paths, double depth,
                WideExits& exits);

/// The exit of vertex l, which was found, with the plane's number in the solid.
inline Crossing crossing_of(const WideExits& exits, std::size_t l) {
  return {exits.tau[l], exits.t[l], exits.sector[l]->plane[static_cast<std::size_t>(exits.row[l])]};
}

}  // namespace tdbd::rock
