#pragma once

#include <vector>

#include "reference/compare/findings.hpp"
#include "reference/compare/models/roller_case.hpp"

/// Findings of single teeth, of their rows and of their cones. `teeth`: a value for each tooth in the order of
/// place_teeth, cone by cone and row by row.
namespace tdbd::reference {

/// "cone-1/row-2/tooth-3", the name of TDBD's part.
std::string tooth_name(const std::string& cone, std::size_t row, std::size_t tooth);

/// Each value over a number: means of sums over steps or turns.
std::vector<double> over(std::vector<double> teeth, double count);

/// Each tooth, at the radius of its row's ring.
void say_teeth(const CompareCase& c, const RollerBit& bit, PartQuantity q,
               const std::vector<double>& teeth, Findings& f);

/// Each tooth, and the sums of rows and cones.
void say_teeth_and_sums(const CompareCase& c, const RollerBit& bit, PartQuantity q,
                        const std::vector<double>& teeth, Findings& f);

/// What models of vertical tooth forces find.
struct ToothNumbers {
  std::vector<double> force, largest;  ///< N: mean over all time; of a step
  std::vector<double> contacts;        ///< share of the time in contact
  std::vector<double> volume;          ///< m3 a revolution
};

/// Teeth, rows and cones; the largest forces of teeth alone. The force along the hole is also the force into the rock:
/// these models take the rock under a tooth as level.
void say_tooth_numbers(const CompareCase& c, const RollerBit& bit, const ToothNumbers& teeth,
                       Findings& f);

}  // namespace tdbd::reference
