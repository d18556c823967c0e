#pragma once

#include "mesh/measures.hpp"
#include "rock/rock.hpp"
#include "verification/battery/generators.hpp"
#include "verification/battery/rock_surfaces.hpp"

namespace tdbd::rock {

/// A mesh of edges of about 0.3 as rock.
inline Rock rock_of(const mesh::TriangleMesh& m) {
  return make_rock(mesh::make_surface(m), 0.5, mesh::bounding_box(m));
}

/// A random square sheet, edges of 0.3; `bump` in cells, in all directions.
inline mesh::TriangleMesh any_sheet(double bump) {
  return battery::bumpy_rock(1.5, 10, bump, static_cast<std::uint64_t>(*battery::integer(0, 999)));
}

}  // namespace tdbd::rock
