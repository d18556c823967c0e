#pragma once

#include "rock/rock.hpp"

namespace tdbd::rock {

struct TrimReport {
  long triangles = 0;   ///< removed
  double volume = 0.0;  ///< m3 by which mesh::hole_volume about W's origin falls
};

/// Buffers of a trim.
struct TrimWorkspace {
  std::vector<int> chains, vertices, triangles;
};

/// Removes the triangles that lie wholly above the plane z = z_W (m, z down), from the boundary
/// loop inwards, one by one where a disc remains: M1 holds with a new boundary loop. Nothing else
/// changes. Searches for the boundary only below z = from_z_W, so a trim that continues the last
/// one costs only what it removes. Ours, for long runs; thesis: 4.4.2.
void trim_wall(Rock& rock, double from_z_W, double z_W, TrimWorkspace& work, TrimReport& report);

}  // namespace tdbd::rock
