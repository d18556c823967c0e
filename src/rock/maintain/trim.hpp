#pragma once

#include "rock/rock.hpp"

namespace tdbd::rock {

struct TrimReport {
  long triangles = 0;   ///< removed
  double volume = 0.0;  ///< m3 that mesh::hole_volume about W's origin loses with them
};

/// What a trim looks through.
struct TrimWorkspace {
  std::vector<int> chains, vertices, triangles;
};

/// Removes the triangles that lie wholly above the plane z = z_W (m, z down), from the boundary
/// loop on, one after another where a disc stays a disc: M1 holds with one boundary loop, which is
/// another one then. Nothing else changes. Looks for the boundary below z = from_z_W only: a trim
/// that goes on from the last one costs what it removes. Formulation 3 [+]: long runs; thesis:
/// 4.4.2.
void trim_wall(Rock& rock, double from_z_W, double z_W, TrimWorkspace& work, TrimReport& report);

}  // namespace tdbd::rock
