#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/pdc/pdc_design.hpp"

namespace tdbd::bit {

/// The cutters of a design, or why there are none.
struct Layout {
  std::vector<Cutter> cutters;
  std::vector<DesignProblem> problems;
};

/// Order in which neighbouring cutters go to n blades, so that they stand far apart: opposite
/// blades for even n (0, 3, 1, 4, 2, 5), every (n/2)-th for odd n (0, 2, 4, 1, 3).
std::vector<int> blade_order(int n);

/// Lays out a PDC bit: face cutters from the axis to the end of the shoulder, each on the next
/// blade where its solid stays clear of all others; gage cutters on every blade; back-up cutters
/// behind the face cutters. Every tip lies on the profile, a back-up's under its under-exposure
/// inside. Cutters are numbered in that order and hold values that a table can hold, so writing
/// and reading changes no bit of them. Problems: those of design_problems; a cutter that fits on no
/// blade; a gage or back-up cutter in another's way or beyond the gage; a blade without cutters.
/// Formulation 1; the rules are ours.
Layout lay_out(const PdcDesign& d);

}  // namespace tdbd::bit
