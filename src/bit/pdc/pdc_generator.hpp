#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/pdc/pdc_design.hpp"

namespace tdbd::bit {

/// The cutters of a design, or the reasons why there are none.
struct Layout {
  std::vector<Cutter> cutters;
  std::vector<DesignProblem> problems;
};

/// The order in which neighbouring cutters are dealt to n blades, so that they stand far apart:
/// opposite blades for even n (0, 3, 1, 4, 2, 5), every (n/2)-th for odd n (0, 2, 4, 1, 3).
std::vector<int> blade_order(int n);

/// Lays out a PDC bit, bit (3) to (5): face cutters from the axis to the end of the shoulder, each
/// on the next blade where its solid stays clear of all others; gage cutters on every blade;
/// back-up cutters behind the face cutters. Every tip lies on the profile, a back-up's inside it by
/// its under-exposure. Cutters are numbered in that order and hold values that a table can hold, so
/// writing and reading changes no bit of them. Problems: those of design_problems; a cutter that
/// fits on no blade; a gage or back-up cutter in another's way or beyond the gage; a blade without
/// cutters. Ours.
Layout lay_out(const PdcDesign& d);

}  // namespace tdbd::bit
