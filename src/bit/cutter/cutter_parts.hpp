#pragma once

#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// `graded`: fine at the rim, coarse at the centre (fig. 3.9). `uniform`: about equal edges
/// everywhere, the mesh that the dissertation names as a cause of noise (ch. 6); kept for
/// comparison.
enum class Grading { graded, uniform };

/// Meshing of a cutter's parts.
struct CutterMeshing {
  Grading grading = Grading::graded;
  int rim_segments = 64;       ///< graded only
  double uniform_edge = 2e-3;  ///< m, uniform only
};

/// Density of the polycrystalline diamond table and of the tungsten carbide body, kg/m3.
inline constexpr double table_density = 3500.0;
inline constexpr double carbide_density = 14500.0;

/// Makes the parts of a cutter, in this order, all in its frame and at its pose. They are closed,
/// convex, inscribed meshes with rim points at the same angles, one of them the tip:
///   cutter-N/face     cylinder, x in [-f, 0], radius D/2 - land - chamfer
///   cutter-N/land     frustum from there to radius D/2 - chamfer; absent without a land
///   cutter-N/chamfer  frustum from there to radius D/2 at x = -f; absent if the edge is sharp
///   cutter-N/body     cylinder, x in [-length, -f], radius D/2
/// f is the axial depth of the chamfers, or the thickness of the table if the edge is sharp. The
/// frustums enclose the face, whose density is then 0. The parts of a worn cutter end in the plane
/// normal to the profile's normal that is below the tip by the cutter's wear. A part that this
/// plane removes entirely is absent. The caller sets `group` and `cutter`. Thesis: 3.2.2, 3.3,
/// figs. 3.8 and 3.9.
std::vector<Part> cutter_parts(const Cutter& c, const CutterMeshing& meshing);

}  // namespace tdbd::bit
