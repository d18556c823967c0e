#pragma once

#include "mesh/triangle_mesh.hpp"
#include "rock/rock.hpp"

namespace tdbd::simulation {

/// The rock at the end of a level, for comparisons between levels.
struct Hole {
  mesh::TriangleMesh rock;  ///< the whole surface
  mesh::TriangleMesh cut;   ///< triangles with a corner that the bit moved in this run
  double edge = 0.0;        ///< m, median edge length of the cut triangles; 0: nothing was cut
};

Hole hole_of(const rock::Rock& rock);

/// Distance between two holes, and the radius for relative distances.
struct HoleDifference {
  double largest = 0.0;  ///< m: symmetric Hausdorff distance of the cut parts
  double volume = 0.0;   ///< m3, between the surfaces: mean of the integrals in both directions
  double radius = 0.0;   ///< m: half the largest width of the cut parts
};

/// Sampled at half the smaller edge length. Zero if neither was cut.
HoleDifference difference(const Hole& a, const Hole& b);

}  // namespace tdbd::simulation
