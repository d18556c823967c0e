#pragma once

#include "bit/bit.hpp"
#include "dynamics/drilling/stability.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// How steeply the laws' forces rise as the bit goes into the rock, all cutters and one tooth of
/// each row of a cone together: the secant of a cut of 1 mm along the profile's normal, of a
/// circular segment by a face, of a spherical cap by a tooth. An estimate, for the step's limit.
dynamics::ContactSlopes contact_slopes(const bit::Bit& bit, const ForcePlan& plan);

}  // namespace tdbd::simulation
