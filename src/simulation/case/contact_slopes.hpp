#pragma once

#include "bit/bit.hpp"
#include "dynamics/drilling/stability.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// How steeply the laws' forces rise as the bit goes into the rock, summed over all parts that have a
/// law: the secant of a cut of 1 mm. Cutters: a circular segment cut by the face, along the profile's
/// normal. Designed cones: a spherical cap for one tooth of each row. All other parts: from their
/// meshes (bearing_of_parts), less the force at touch, which does not rise with depth. An estimate,
/// for the largest stable time step.
dynamics::ContactSlopes contact_slopes(const bit::Bit& bit, const ForcePlan& plan);

/// Estimate of the weight (N) that the bit carries when all that cuts or rubs is this deep in rock
/// (m). 0: no part has a law that carries weight.
double weight_borne(const bit::Bit& bit, const ForcePlan& plan, double depth_of_bit);

}  // namespace tdbd::simulation
