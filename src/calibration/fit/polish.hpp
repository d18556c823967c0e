#pragma once

#include "calibration/fit/trust_region.hpp"

namespace tdbd::calibration {

/// Refines the result of a search to ten digits by Gauss-Newton steps over the free unknowns. The
/// search minimizes the sum of squares and cannot resolve values closer than the square root of
/// rounding, so the order of records would affect the eighth digit. If a step is not small, the
/// readings do not determine the direction, and the refinement stops.
void polish(Search& search);

}  // namespace tdbd::calibration
