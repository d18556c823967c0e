#pragma once

#include "mesh/measures.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Estimated needs of a rock before it is created: triangles at the start and those that the wall
/// gains as the hole grows, cells of the index, and memory for both.
struct RockNeed {
  double triangles = 0.0, cells = 0.0, bytes = 0.0;
};

/// Needs of a surface of this area (m2) within a box, with an index whose cells are two edge
/// lengths wide.
RockNeed need_of(double area, const mesh::Box& box_W, double edge_length);

/// Memory of a number of triangles, bytes, without the index.
double bytes_of_triangles(double triangles);

/// Needs of the wall that the run adds, and of the index along the path of the bit.
RockNeed need_of_new_wall(const Case& c);

/// Box of the path of the bit's axis during the run, enlarged by the bit: start, end and the rows
/// of a path.
mesh::Box reach_W(const Case& c);

/// Checks that a rock with this area and box, including the wall that the run adds, fits into the
/// memory of the machine and 32-bit indices. Otherwise throws InputError that names
/// rock.edge_length, the need and a suitable edge length.
void require_memory(const Case& c, double area, mesh::Box box_W);

}  // namespace tdbd::simulation
