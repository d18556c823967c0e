#pragma once

#include <span>
#include <vector>

#include "mesh/surface.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Height of rock above a point, m: from the highest face of rock straight above it (against z)
/// down to the point. 0 for a point in the open: one that has as many of the rock's faces turned up
/// above it as turned down.
double cover_above(const mesh::Surface& rock, const Vec3& x_W);

/// The same, to the bit, of many points in one pass over the rock's faces.
std::vector<double> covers_above(const mesh::Surface& rock, std::span<const Vec3> points_W);

/// Throws InputError when the bit of a case starts inside the rock by more than a cutter's radius:
/// then the centre of a cutting part lies below the rock's surface.
void require_free_start(const Case& c, const mesh::Surface& rock);

}  // namespace tdbd::simulation
