#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// @file
/// Open sheets: the surface of a rock. z points down, into the rock, and facets face up, out of the
/// rock. The outermost boundary of a sheet is its rim; every other boundary is a hole.

/// A boundary of a sheet.
struct Opening {
  std::vector<int> loop;       ///< vertices, see boundary_loops
  Vec3 centre = Vec3::Zero();  ///< m, mean of its corners
  double across = 0.0;         ///< m, diagonal of its bounding box
};

/// Returns the boundaries of a sheet, the rim first, then the holes by size.
std::vector<Opening> openings(const TriangleMesh& m);

/// "hole of 4 edges, 2.83 mm across, at (1.0000, 2.0000, 3.0000) mm"; `what`: "hole" or "rim".
std::string describe(const Opening& opening, const std::string& what);

/// Drops vertices of no triangle, then fills the holes of a sheet with the triangulations of least
/// area [CGAL]; the rim stays. Returns the number of holes; `refusal` names a hole that has no triangulation.
std::size_t fill_sheet_holes(TriangleMesh& m, std::string& refusal);

/// Reverses all facets, so that the sheet faces the other way. Positions are unchanged.
void flip(TriangleMesh& m);

/// Turns the mesh by half a turn about x: (x, y, z) becomes (x, -y, -z). A file whose z axis points
/// up then has z down, with facets on the same side of the surface.
void turn_about_x(TriangleMesh& m);

/// Whether the facets face down on average. Those of a rock face up, against z.
bool faces_down(const TriangleMesh& m);

/// What to do about a sheet that faces down, for messages.
inline constexpr const char* upside_down_question =
    "does z point down in the file? If z points up, tdbd mesh --sheet --z-up turns the sheet; if "
    "only the facets are reversed, tdbd mesh --sheet --flip flips them";

/// Why a mesh cannot be the rock of a case, one line per reason: it is not one open oriented
/// surface with one boundary (check_surface), faces down, or intersects itself. Empty if it can.
std::vector<std::string> sheet_faults(const TriangleMesh& m);

}  // namespace tdbd::mesh
