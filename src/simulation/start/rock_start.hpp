#pragma once

#include <string>

#include "rock/rock.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Creates the rock of a case at t = 0 with its index. The surface conforms to the exposure profile
/// of the bit, is flat or rough, has a given meridian, or is read from a file. Throws InputError if
/// a file is not a single open oriented surface, if a file or meridian intersects itself (unless
/// the case disables this check), if the memory of the machine is too small, or if a file belongs
/// to another time than the start of the run (require_same_time).
rock::Rock start_rock(const Case& c);

/// The surface of the rock, with its area and box for estimates of memory.
struct StartSurface {
  mesh::Surface surface;
  double area = 0.0;  ///< m2
  mesh::Box box_W;
};

/// start_rock in two steps. Cases with the same start_surface_key have the same initial surface,
/// each with its own index.
StartSurface start_surface(const Case& c);
rock::Rock start_rock(const Case& c, StartSurface start);

/// A key of all inputs of start_surface except those that can only reject the case. Empty if the
/// surface is read from a file.
std::string start_surface_key(const Case& c);

/// Creates a rock from a surface of this case, with the index that start_rock makes.
rock::Rock indexed_rock(const Case& c, mesh::Surface surface);

}  // namespace tdbd::simulation
