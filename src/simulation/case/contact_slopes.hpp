#pragma once

#include "bit/bit.hpp"
#include "dynamics/drilling/stability.hpp"
#include "simulation/case/force_settings.hpp"

namespace tdbd::simulation {

/// The axial force of flat rock on parts that are pressed into it. It is linear in the depth d:
/// at_touch + slope d.
struct PartBearing {
  double at_touch = 0.0;  ///< N: all of the force of a flat part
  double slope = 0.0;     ///< N/m, derivative of the axial force with respect to the axial depth
  double lateral_slope = 0.0;  ///< N/m, along x and y, averaged over azimuths
};

/// Returns the unit direction in which a part meets the rock, in the bit frame: its update
/// direction at its own azimuth. For a part of a cone: the direction that points down when the part
/// is at its lowest position.
Vec3 contact_direction_B(const bit::Bit& bit, const bit::Part& part);

/// Returns the area (m2) of the section of a part by the plane at a distance `depth` (m) behind its
/// farthest point along a direction (unit, bit frame).
double area_at_depth(const bit::Part& part, const Vec3& direction_B, double depth);

/// Sums the forces of all parts with a law, except faces, other parts of a cutter whose face has a
/// law, and teeth of designed cones. Each part is pressed 1 mm into flat rock along
/// contact_direction_B, at the full stress of its law. Only one tooth of each row of a cone counts.
PartBearing bearing_of_parts(const bit::Bit& bit, const ForcePlan& plan,
                             const forces::Strength& strength);

/// Estimates how steeply the forces of the laws increase with the depth of the bit, summed over all
/// parts that have a law: the secant of a cut of 1 mm. Cutters: a circular segment cut by the face,
/// along the profile's normal. Designed cones: a spherical cap for one tooth of each row. All other
/// parts: from their meshes (bearing_of_parts), without the force at touch, which does not depend
/// on depth. Used for the largest stable time step.
dynamics::ContactSlopes contact_slopes(const bit::Bit& bit, const ForcePlan& plan);

/// Estimates the weight (N) that the bit carries with all parts that cut or rub at this depth (m)
/// in rock. 0 if no part has a law that carries weight.
double weight_borne(const bit::Bit& bit, const ForcePlan& plan, double depth_of_bit);

}  // namespace tdbd::simulation
