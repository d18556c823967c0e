#pragma once

#include "calibration/fit/trust_region.hpp"

namespace tdbd::calibration {

/// Steps of Gauss and Newton over the free unknowns from where a search ended, to ten digits: it
/// goes by the sum of squares, and cannot tell values nearer than the root of rounding, so that the
/// order of records would show in the eighth digit. The steps are small, or the readings do not see
/// what they change: then they are left.
void polish(Search& search);

}  // namespace tdbd::calibration
