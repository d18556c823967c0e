#pragma once

#include <string>

#include "reference/compare/model.hpp"
#include "reference/literature/roller/roller_bit_of.hpp"
#include "reference/literature/roller/teeth/tooth_law.hpp"

/// Input of models of roller cone bits, taken from the case.
namespace tdbd::reference {

/// "cone-1/row-2", as in TDBD.
std::string row_name(const std::string& cone, std::size_t row);

/// Radius of a row's lowest place, m from the bit's axis.
double ring_radius(const RollerCone& cone, const RollerRow& row);

/// Returns the case's table of single-tooth tests. Without one, returns the table of a sphere with
/// the radius of the bit's largest tooth, pressed into flat rock under the case's law: crushing
/// pressure times projected area. Throws InputError that begins with `model` if the teeth have
/// another law.
ToothTable tooth_table_of(const CompareCase& c, const RollerBit& bit, const std::string& model);

/// Pressure under a tooth that crushes rock, Pa, in the same law.
double tooth_pressure(const CompareCase& c, const std::string& model);

/// Coefficient of friction between tooth and rock in the same law.
double tooth_friction(const CompareCase& c, const std::string& model);

/// Radius of the largest tooth, m.
double largest_tooth(const RollerBit& bit);

/// The ratio of cone speed to bit speed at which the outermost row does not slip.
double outer_rolling_ratio(const RollerBit& bit);

}  // namespace tdbd::reference
