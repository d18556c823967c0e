#pragma once

#include <span>
#include <vector>

#include "mesh/surface.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Height of rock above a point, m: from the highest rock face directly above it (against z) down
/// to the point. 0 for a point in the open, which has as many faces above it that point up as faces
/// that point down.
double rock_height_above(const mesh::Surface& rock, const Vec3& x_W);

/// The same for many points in one pass over the faces; bitwise identical.
std::vector<double> rock_heights_above(const mesh::Surface& rock, std::span<const Vec3> points_W);

/// Throws InputError if the bit of a case starts deeper in the rock than the radius of a cutter,
/// that is, if the centre of a cutting part is below the rock's surface.
void require_start_outside_rock(const Case& c, const mesh::Surface& rock);

}  // namespace tdbd::simulation
