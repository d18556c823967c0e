#pragma once

#include <vector>

#include "reference/compare/findings.hpp"
#include "reference/compare/models/roller_case.hpp"

/// Findings of single teeth and of their rows. `teeth`: a value for each tooth in the order of place_teeth, cone by
/// cone and row by row.
namespace tdbd::reference {

/// "cone-1/row-2/tooth-3", the name of TDBD's part.
std::string tooth_name(const std::string& cone, std::size_t row, std::size_t tooth);

/// Each value over a number: means of sums over steps or turns.
std::vector<double> over(std::vector<double> teeth, double count);

/// The sum of the teeth of each row.
void say_rows(const CompareCase& c, const RollerBit& bit, PartQuantity q,
              const std::vector<double>& teeth, Findings& f);

/// Each tooth, at the radius of its row's ring.
void say_teeth(const CompareCase& c, const RollerBit& bit, PartQuantity q,
               const std::vector<double>& teeth, Findings& f);

}  // namespace tdbd::reference
