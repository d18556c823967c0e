#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Makes the part bit-body: a solid of revolution about the bit's axis, in the bit frame, that
/// never cuts. Its meridian connects the tips, each moved into the bit along the profile's normal
/// by `setback` times its cutter's diameter; above them are the gage and the shank. It fills blades
/// and waterways, so its mass (`density` in kg/m3) is an upper estimate. `gage_radius` in m.
/// Thesis: 3.1; the shape is not in the thesis.
Part bit_body(const std::vector<Cutter>& cutters, double setback, double density,
              double gage_radius);

/// Volume (m3) that a closed convex mesh shares with any closed, outward-oriented mesh in the same
/// frame. A point is inside the second mesh if a ray from it along +z leaves that mesh once more
/// often than it enters. So the volume is a sum over the second mesh's triangles, with the sign of
/// the z component of their normals, of the part of the convex mesh that is vertically above each
/// triangle (one clip by four planes). Exact for the meshes.
double common_volume(const mesh::TriangleMesh& convex, const mesh::TriangleMesh& closed);

/// Volume (m3) of the cutters' parts with a density that lies inside the bit's bodies. It counts
/// twice in the mass because bodies have no pockets.
double cutters_in_body(const Bit& bit);

/// Returns pairs (inner, outer) of indices into Bit::parts. Both parts have a density, and every
/// vertex of the inner part lies inside the outer part's mesh, so its volume counts twice in the
/// mass. Sorted by the inner part, then the outer part.
std::vector<std::pair<int, int>> enclosed_parts(const Bit& bit);

/// The distance of a part from the rock that the cutters leave in steady drilling.
struct Rubbing {
  double clearance = 0.0;        ///< m, smallest, along the axis; negative: the part is in the rock
  Vec3 clearance_at_B{0, 0, 0};  ///< m, the point with the least clearance
  double touching_advance = 0.0;  ///< m per revolution, smallest advance at which a point touches
  Vec3 touching_at_B{0, 0, 0};    ///< m, that point
  std::size_t points = 0;         ///< number of measured points
  std::size_t over_uncut = 0;     ///< number of points omitted: no cutter cuts at their radius
};

/// Radial-plane analysis (bit_analysis.hpp) for a surface that does not cut, bit (7). `advance` (m
/// per revolution) determines the clearance. The smallest touching advance is the depth of cut that
/// the body controls. Measured at all vertices and, every millimetre, on those facets that face the
/// rock and have a corner that touches early. Rims are interpolated between columns of at most
/// `column_width` (m). The result of a part without points over cut rock is zero. Not in the
/// thesis.
Rubbing rubbing(const std::vector<Cutter>& cutters, const Part& part, double advance,
                double column_width);

/// Areas (m2) of the part that lie in the rock at steady advances (m per revolution), projected
/// along the axis, bit (7): for its facets that face the rock, the part below which there is rock,
/// with depths linear over each facet. Facets over rock that no cutter cuts do not count. Not in
/// the thesis.
std::vector<double> rubbing_areas(const std::vector<Cutter>& cutters, const Part& part,
                                  const std::vector<double>& advances, double column_width);

}  // namespace tdbd::bit
