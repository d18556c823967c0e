#pragma once

#include <vector>

#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/relative_path.hpp"

namespace tdbd::rock {

/// The planes of a convex solid that any of some paths can meet within a distance `t_max` (m) along
/// its update direction. An exit from these planes within t_max is the exit from the solid: all
/// other planes are beyond.
struct NearPlanes {
  mesh::ConvexSolid solid_P;
  double t_max = 0.0;
};

/// `near` is kept between calls so that none allocates once warm. `depth` as in exit_distance.
void find_near_planes(const mesh::ConvexSolid& solid, const std::vector<RelativePath>& paths,
                      double depth, double t_max, NearPlanes& near);

}  // namespace tdbd::rock
