#pragma once

#include "rock/rock.hpp"

namespace tdbd::rock {

struct TrimReport {
  long triangles = 0;   ///< number of triangles removed
  double volume = 0.0;  ///< m3 by which mesh::hole_volume about W's origin decreases
};

/// Buffers of trim_wall.
struct TrimWorkspace {
  std::vector<int> chains, vertices, triangles;
};

/// Removes the triangles that lie wholly above the plane z = z_W (m, z down), from the boundary
/// loop inwards, one by one as long as a disc remains: M1 holds with a new boundary loop. Nothing
/// else changes. The boundary is searched only below z = from_z_W, so the run time of a trim that
/// continues the last one depends only on what it removes. For long runs; not in the thesis
/// (4.4.2).
void trim_wall(Rock& rock, double from_z_W, double z_W, TrimWorkspace& work, TrimReport& report);

}  // namespace tdbd::rock
