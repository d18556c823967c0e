#pragma once

#include "mesh/measures.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// What a rock needs, before any of it is made: triangles at the start and those that the wall
/// gains while the hole grows, cells of the index, and bytes for both.
struct RockNeed {
  double triangles = 0.0, cells = 0.0, bytes = 0.0;
};

/// A surface of this area (m2) within a box under an index of cells of two edge lengths.
RockNeed need_of(double area, const mesh::Box& box_W, double edge_length);

/// Bytes of so many triangles, without the index.
double bytes_of_triangles(double triangles);

/// What the wall that the run adds needs, and the index along the bit's way.
RockNeed need_of_new_wall(const Case& c);

/// Where the bit's axis goes during the run, widened by the bit: start, end and a path's rows.
mesh::Box reach_W(const Case& c);

/// Throws InputError, naming rock.edge_length, if a rock of this area and box, with the wall that
/// the run adds, needs more than the machine's memory or more than 32-bit numbers count; says how
/// much it needs and which edge length would do.
void require_memory(const Case& c, double area, mesh::Box box_W);

}  // namespace tdbd::simulation
