#pragma once

#include "calibration/fit/trust_region.hpp"

namespace tdbd::calibration {

/// A search that goes by the sum of squares cannot tell values nearer than the root of rounding:
/// the order of records would show in the eighth digit. Steps of Gauss and Newton over the free
/// unknowns go on from there, to ten digits. They are small, or the readings do not see what they
/// change: then they are left.
void polish(Search& search);

}  // namespace tdbd::calibration
