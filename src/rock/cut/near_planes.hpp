#pragma once

#include <vector>

#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/relative_path.hpp"

namespace tdbd::rock {

/// Boxes around the places and the update directions of some paths.
struct PathBoxes {
  mesh::Box q_P, u_P;
};

/// Of those of the paths with these numbers.
PathBoxes boxes_around(const std::vector<RelativePath>& paths,
                       const std::vector<std::size_t>& which);

/// The planes of a convex solid that any path in some boxes can meet within a distance `t_max` (m)
/// along its update direction. An exit from these planes within t_max is the exit from the solid,
/// to the bit (find_exit): all other planes are beyond, so it does not matter for which boxes they
/// were found, and they can be kept from step to step.
struct NearPlanes {
  mesh::ConvexSolid solid_P;
  std::vector<std::size_t> plane;  ///< per plane: its number in the whole solid
  PathBoxes hold_for;
  double t_max = 0.0;
  double checksum = 0.0;  ///< of the solid
  int uses = 0;           ///< since they were found
};

/// A sum over the planes, to tell solids apart.
double checksum(const mesh::ConvexSolid& solid);

/// `near` is kept between calls so that none allocates once warm. `depth` as in find_exit.
void find_near_planes(const mesh::ConvexSolid& solid, const PathBoxes& boxes, double depth,
                      double t_max, NearPlanes& near);

/// The same, but keeps what `near` has if that holds for these boxes; else for somewhat wider ones.
/// `sum`: checksum of the solid.
void update_near_planes(const mesh::ConvexSolid& solid, double sum, const PathBoxes& boxes,
                        double depth, double t_max, NearPlanes& near);

}  // namespace tdbd::rock
