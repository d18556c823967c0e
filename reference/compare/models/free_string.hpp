#pragma once

#include <string>

#include "reference/compare/compare_case.hpp"
#include "reference/literature/drag/spokes/hanson_hansen.hpp"

namespace tdbd::reference {

/// The case's string in the form of models with an upright bit: constants, W, SI. Dampers act
/// relative to space. Dampers of the case that end at the top are equivalent with a shifted top,
/// because the top's speeds are constant.
struct FreeString {
  double mass = 0.0, inertia = 0.0;  ///< kg; kg m2 about the axis
  double lateral_stiffness = 0.0, axial_stiffness = 0.0, twist_stiffness = 0.0;  ///< N/m, N m/rad
  double lateral_damping = 0.0, axial_damping = 0.0, twist_damping = 0.0;  ///< N s/m, N m s/rad
  double rate = 0.0, speed = 0.0;       ///< of the top: m/s, rad/s
  double top_z = 0.0, top_angle = 0.0;  ///< position of the top at t = 0: m, rad
  double z = 0.0, start_rate = 0.0;     ///< of the bit at t = 0: m, m/s
};

/// The terms of the string that the equations of a model contain. The others are omitted and
/// reported.
enum class StringTerms { springs, springs_and_dampers };

/// The rock in which a model can start: rock that fits the bit, or the model's own rock,
/// independent of the case.
enum class StartRock { fits_bit, own };

/// Throws InputError that begins with the model's name. A prescribed load at the top is replaced by
/// a spring so soft that its force changes by 1e-5 of itself in a centimetre.
FreeString free_string(const CompareCase& c, StringTerms terms, const std::string& model,
                       StartRock rock = StartRock::fits_bit);

/// The same as terms of eqs. (2.1) to (2.3), with the case's rock on its spring. The position of
/// the top is omitted.
DrillStringAndRock hanson_hansen_system(const CompareCase& c, const FreeString& s);

/// A sentence that lists the terms of the case's string and wall that such models omit.
std::string left_out(const CompareCase& c, StringTerms terms);

}  // namespace tdbd::reference
