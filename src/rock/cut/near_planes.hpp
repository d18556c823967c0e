#pragma once

#include <vector>

#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/relative_path.hpp"

namespace tdbd::rock {

/// Bounds of the places and of the update directions of some paths.
struct PathBoxes {
  mesh::Box q_P, u_P;
};

/// Bounds of the paths with these indices.
PathBoxes boxes_around(const std::vector<RelativePath>& paths,
                       const std::vector<std::size_t>& which);

/// The planes of a convex solid that any path in some boxes can meet within a distance `t_max` (m)
/// along its update direction. An exit from these planes within t_max is bitwise the exit from the
/// solid (find_exit), because all other planes are farther away. The result does not depend on the
/// boxes for which the planes were found, so they can be kept from step to step.
struct NearPlanes {
  mesh::ConvexSolid solid_P;
  std::vector<std::size_t> plane;  ///< per plane: its index in the solid
  PathBoxes hold_for;
  double t_max = 0.0;
  double checksum = 0.0;  ///< of the solid
  int uses = 0;           ///< since the planes were found
};

/// A sum over the planes that distinguishes solids.
double checksum(const mesh::ConvexSolid& solid);

/// Finds the near planes of a solid. `near` is a reused buffer. `depth`: as in find_exit.
void find_near_planes(const mesh::ConvexSolid& solid, const PathBoxes& boxes, double depth,
                      double t_max, NearPlanes& near);

/// Keeps the planes in `near` if they are valid for these boxes; otherwise finds the planes for
/// somewhat wider boxes. `sum`: checksum of the solid.
void update_near_planes(const mesh::ConvexSolid& solid, double sum, const PathBoxes& boxes,
                        double depth, double t_max, NearPlanes& near);

}  // namespace tdbd::rock
