#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/shape/convex.hpp"

namespace tdbd::rock {

/// The planes of a convex solid that matter in a wedge about the solid's x axis, in the solid's
/// order.
struct PlaneSector {
  /// Inward normals of the wedge's two sides in the y-z plane: lo_y, lo_z, hi_y, hi_z.
  std::array<double, 4> sides;
  std::vector<double> rows;          ///< nx, ny, nz, b of each plane
  std::vector<std::uint16_t> plane;  ///< per row: the plane's index in the solid
  std::uint32_t ends = 0;  ///< bit i: plane of row i is an end (nearly normal to the axis)
};

/// A convex solid divided into wedges about its x axis, which passes through it. Not in the thesis.
/// A wedge is convex, and few of the solid's planes bound its part of the solid. With the slack s =
/// 1e-6 of the solid's size:
///
///   If a point of the wedge is outside no plane of the sector by more than s / 10, except that it
///   may be outside a single end by up to `beyond`, then it is inside all other planes of the solid
///   by s / 10.
///
/// Proof: let a be a point of the axis inside all planes by more than s. The segment from a to the
/// point stays in the wedge. Suppose that it came within s / 10 of a plane that is not in the
/// sector. At the first such place that plane's facet would be in the wedge, to within s. But a
/// sector has all planes with such facets, of the solid and of the solid with one end moved out by
/// `beyond`. Points are within three times `size` of the origin of P.
///
/// Points of the core, a cylinder about the axis, are inside all planes that any sector lacks.
///
/// Therefore a ray that leaves the planes of a sector at such a point leaves the solid at bitwise
/// the same place.
struct PlaneSectors {
  static constexpr int count = 64;
  static constexpr std::size_t most_rows = 32;
  std::vector<PlaneSector> sectors;
  std::size_t rows = 0;  ///< per sector, including padding rows that exclude nothing
  double size = 0.0;     ///< m, of the solid
  double beyond = 0.0;   ///< m
  double core_lo = 0.0, core_hi = 0.0, core_radius = -1.0;  ///< m; a negative radius: no core

  /// Returns the sector that contains the direction (y, z). Any sector is valid for the axis
  /// itself.
  const PlaneSector& towards(double y, double z) const {
    const double sum = std::abs(y) + std::abs(z), p = sum > 0.0 ? z / sum : 0.0;
    const int k = static_cast<int>((y >= 0.0 ? 1.0 + p : 3.0 - p) * (0.25 * count));
    return sectors[static_cast<std::size_t>(k < count ? k : count - 1)];
  }
};

/// Computes the sectors of a solid of this size (m, the diagonal of its box). Returns none if the
/// solid has few planes, if the x axis does not pass through it, or if a sector would need more
/// than `most_rows` planes.
PlaneSectors plane_sectors(const mesh::ConvexSolid& solid, double size);

}  // namespace tdbd::rock
