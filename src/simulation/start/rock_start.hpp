#pragma once

#include <string>

#include "rock/rock.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// The rock of a case at t = 0, under its index: conforming to the bit's exposure profile, flat,
/// rough, of any meridian, or read from a file. Throws InputError for a file that is no single open
/// oriented surface, for one (or a meridian) that intersects itself, unless the case waives that
/// check, for a rock that the machine's memory does not hold, and for one of another time than the run begins at
/// (require_same_time).
rock::Rock start_rock(const Case& c);

/// The surface of that rock, and what bounds its need of memory.
struct StartSurface {
  mesh::Surface surface;
  double area = 0.0;  ///< m2
  mesh::Box box_W;
};

/// The same in two steps: cases of the same start_surface_key begin with the same surface, each
/// under an index of its own.
StartSurface start_surface(const Case& c);
rock::Rock start_rock(const Case& c, StartSurface start);

/// All that start_surface looks at, but for what may refuse the case; empty for a mesh file.
std::string start_surface_key(const Case& c);

/// A surface of this case's rock, under the index that start_rock makes.
rock::Rock indexed_rock(const Case& c, mesh::Surface surface);

}  // namespace tdbd::simulation
