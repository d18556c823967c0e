#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/shape/convex.hpp"

namespace tdbd::rock {

/// Those planes of a convex solid that matter in a wedge about the solid's x axis, in the order of
/// the solid.
struct PlaneSector {
  /// Inward normals of the wedge's two sides in the y-z plane: lo_y, lo_z, hi_y, hi_z.
  std::array<double, 4> sides;
  std::vector<double> rows;          ///< nx, ny, nz, b of each plane
  std::vector<std::uint16_t> plane;  ///< per row: its number in the solid
  std::uint32_t ends = 0;  ///< bit i: the plane of row i is an end, nearly normal to the axis
};

/// A convex solid divided into wedges about its x axis, which passes through it (ours). A wedge is
/// convex, and few of the solid's planes bound what is in it. With the slack s = 1e-6 of the solid's size:
///
///   a point of the wedge that is outside no plane of the sector by more than s / 10, or besides outside
///   a single end by no more than `beyond`, is inside all other planes of the solid by s / 10
///
/// Proof: let a be a point of the axis inside all planes by more than s. The way from a to the point stays
/// in the wedge. If it came within s / 10 of a plane that the sector does not have, then at the first such
/// place that plane's facet, to within s, would be in the wedge, to within s; and a sector has all planes
/// with such facets, of the solid and of the solid with one end moved out by `beyond`. Points are within
/// three times `size` of the origin of P.
///
/// Points of the core, a cylinder about the axis, are inside all planes that any sector lacks.
///
/// So where a ray leaves the planes of a sector at such a point, it leaves the solid, bitwise there.
struct PlaneSectors {
  static constexpr int count = 64;
  static constexpr std::size_t most_rows = 32;
  std::vector<PlaneSector> sectors;
  std::size_t rows = 0;  ///< of each sector, with padding that excludes nothing
  double size = 0.0;     ///< m, of the solid
  double beyond = 0.0;   ///< m
  double core_lo = 0.0, core_hi = 0.0, core_radius = -1.0;  ///< m; a negative radius: no core

  /// The sector about the direction (y, z). Any is right for the axis itself.
  const PlaneSector& towards(double y, double z) const {
    const double sum = std::abs(y) + std::abs(z), p = sum > 0.0 ? z / sum : 0.0;
    const int k = static_cast<int>((y >= 0.0 ? 1.0 + p : 3.0 - p) * (0.25 * count));
    return sectors[static_cast<std::size_t>(k < count ? k : count - 1)];
  }
};

/// The sectors of a solid of this size (m, the diagonal of its box). None if the solid has few planes,
/// the x axis does not pass through it, or a sector would need more than `most_rows`.
PlaneSectors plane_sectors(const mesh::ConvexSolid& solid, double size);

}  // namespace tdbd::rock
