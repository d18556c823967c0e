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

/// The order in which neighbouring cutters are assigned to n blades, so that they are far apart:
/// opposite blades for even n (0, 3, 1, 4, 2, 5), every (n/2)-th blade for odd n (0, 2, 4, 1, 3).
std::vector<int> blade_order(int n);

/// Makes the layout of a PDC bit, bit (3) to (5): face cutters from the axis to the end of the
/// shoulder, each on the next blade on which its solid is clear of all others; gage cutters on
/// every blade; back-up cutters behind the face cutters. Every tip lies on the profile, except that
/// a back-up's tip is inside it by its under-exposure. Cutters are numbered in that order, and
/// their values are rounded to those that a table can represent, so that writing and reading is
/// lossless. Problems: those of design_problems; a cutter that fits on no blade; a gage or back-up
/// cutter that collides with another one or is beyond the gage; a blade without cutters. Not in the
/// thesis.
Layout make_layout(const PdcDesign& d);

}  // namespace tdbd::bit
