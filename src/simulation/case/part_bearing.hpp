#pragma once

#include "bit/bit.hpp"
#include "simulation/case/plans.hpp"

namespace tdbd::simulation {

/// The axial force of flat rock on parts that are pressed into it, linear in the depth d:
/// at_touch + slope d.
struct PartBearing {
  double at_touch = 0.0;       ///< N: of a flat part, all of its force
  double slope = 0.0;          ///< N/m, of the axial force over the axial depth
  double lateral_slope = 0.0;  ///< N/m, along x and along y, averaged over azimuths
};

/// The direction in which a part meets the rock, unit, in the bit frame: its update direction at its
/// own azimuth. For a part of a cone: the direction that points down when the cone has turned the
/// part to its lowest place.
Vec3 contact_direction_B(const bit::Bit& bit, const bit::Part& part);

/// Area (m2) of the section of a part by the plane at a distance `depth` (m) behind its farthest
/// point along a direction (unit, bit frame).
double area_at_depth(const bit::Part& part, const Vec3& direction_B, double depth);

/// Sum over all parts with a law, except faces, other parts of a cutter whose face has a law, and
/// teeth of designed cones: each part is pressed 1 mm into flat rock along contact_direction_B, at the
/// full stress of its law. Of the teeth of a cone's row, one counts.
PartBearing bearing_of_parts(const bit::Bit& bit, const ForcePlan& plan,
                             const forces::Strength& strength);

}  // namespace tdbd::simulation
