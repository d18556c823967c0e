#pragma once

#include <cmath>
#include <numbers>
#include <tuple>

#include "reference/literature/roller/roller_bit.hpp"
#include "reference/literature/roller/teeth/tooth_law.hpp"

/// The roller bit of the comparison, and laws of its teeth: three equal cones of two rows.
namespace tdbd::reference::example {

inline RollerRow even_row(double along, double radius, int teeth, double first) {
  RollerRow row;
  row.along = along;
  row.radius = radius;
  row.tooth_radius = 6e-3;
  for (int i = 0; i < teeth; ++i) row.angles.push_back(first + 2.0 * std::numbers::pi * i / teeth);
  return row;
}

/// Rows (80, 60) mm of 25 teeth and (45, 40) mm of 15, journals at 36 deg; the cones' teeth stand a third of
/// a pitch apart.
inline RollerBit roller_bit(double offset) {
  RollerBit bit;
  for (int k = 0; k < 3; ++k) {
    RollerCone cone;
    cone.azimuth = 2.0 * std::numbers::pi * k / 3.0;
    cone.journal_angle = 36.0 * std::numbers::pi / 180.0;
    cone.offset = offset;
    cone.inertia = 0.005;
    for (const auto& [along, radius, teeth] :
         {std::tuple{80e-3, 60e-3, 25}, std::tuple{45e-3, 40e-3, 15}})
      cone.rows.push_back(even_row(along, radius, teeth, 2.0 * std::numbers::pi * k / 3.0 / teeth));
    bit.cones.push_back(cone);
  }
  return bit;
}

/// 5000 N at 1 mm, with the power 3/2.
inline PowerTooth power_tooth() { return {5000.0 / std::pow(1e-3, 1.5), 1.5, 6e-3}; }

/// A worked table: 0 to 2.5 mm, 0 to 20 kN, craters of 0 to 5 mm.
inline ToothTable tooth_table() {
  return {{0, 0.5e-3, 1e-3, 1.5e-3, 2e-3, 2.5e-3},
          {0, 2e3, 5e3, 9e3, 14e3, 20e3},
          {0, 1.5e-3, 2.6e-3, 3.5e-3, 4.3e-3, 5e-3}};
}

}  // namespace tdbd::reference::example
