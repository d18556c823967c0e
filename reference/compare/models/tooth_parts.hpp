#pragma once

#include <vector>

#include "reference/compare/findings.hpp"
#include "reference/compare/models/roller_case.hpp"

/// Results for single teeth, their rows and their cones. `teeth`: one value per tooth in the order
/// of place_teeth, cone by cone and row by row.
namespace tdbd::reference {

/// "cone-1/row-2/tooth-3", the name of TDBD's part.
std::string tooth_name(const std::string& cone, std::size_t row, std::size_t tooth);

/// Divides each value by `count`: means of sums over steps or turns.
std::vector<double> over(std::vector<double> teeth, double count);

/// Sets the value of each tooth, at the radius of its row's ring.
void set_tooth_values(const CompareCase& c, const RollerBit& bit, PartQuantity q,
                      const std::vector<double>& teeth, Findings& f);

/// Sets the value of each tooth, and the sums of rows and cones.
void set_tooth_values_and_sums(const CompareCase& c, const RollerBit& bit, PartQuantity q,
                               const std::vector<double>& teeth, Findings& f);

/// Results of models with vertical tooth forces.
struct ToothNumbers {
  std::vector<double> force, largest;  ///< N: mean over all time; largest in a step
  std::vector<double> contacts;        ///< share of the time in contact
  std::vector<double> volume;          ///< m3 per revolution
};

/// Sets the results of teeth, rows and cones; largest forces only of teeth. The force along the
/// hole is also the force into the rock, because these models assume that the rock under a tooth is
/// horizontal.
void set_tooth_quantities(const CompareCase& c, const RollerBit& bit, const ToothNumbers& teeth,
                          Findings& f);

}  // namespace tdbd::reference
