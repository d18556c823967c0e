#pragma once

#include "mesh/triangle_mesh.hpp"
#include "rock/rock.hpp"

namespace tdbd::simulation {

/// The rock at the end of a level, for comparing levels.
struct Hole {
  mesh::TriangleMesh rock;  ///< all of the surface
  mesh::TriangleMesh cut;   ///< triangles with a corner that the bit moved in this run
  double edge = 0.0;        ///< m, median length of the cut triangles' edges; 0: nothing was cut
};

Hole hole_of(const rock::Rock& rock);

/// How far two holes lie apart, and what that is relative to.
struct HoleDifference {
  double largest = 0.0;  ///< m: Hausdorff distance of what was cut, both ways
  double volume = 0.0;   ///< m3 between the surfaces: the mean of both ways' integrals
  double radius = 0.0;   ///< m: half the greatest width of what was cut
};

/// Sampled at half the smaller of both edges. Zero where neither was cut.
HoleDifference difference(const Hole& a, const Hole& b);

}  // namespace tdbd::simulation
