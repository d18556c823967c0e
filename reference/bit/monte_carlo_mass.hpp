#pragma once

#include <cstdint>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Mass properties of a solid of unit density, with their standard errors.
struct EstimatedMass {
  double volume = 0.0, volume_error = 0.0;                    ///< m3
  Vec3 first = Vec3::Zero(), first_error = Vec3::Zero();      ///< integral of x, m4
  Mat3 inertia = Mat3::Zero(), inertia_error = Mat3::Zero();  ///< about the origin, m5
};

/// Estimates the mass properties from random points in the bounding box (core/random, from the
/// seed). Each point counts for the box's volume divided by their number if a ray along +x crosses
/// the closed mesh an odd number of times. Uses neither tetrahedra nor normals. Errors decrease
/// with the square root of the number of points.
EstimatedMass monte_carlo_mass(const mesh::TriangleMesh& m, long points, std::uint64_t seed);

}  // namespace tdbd::reference
