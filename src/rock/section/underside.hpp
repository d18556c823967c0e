#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/simd.hpp"
#include "core/types.hpp"
#include "mesh/measures.hpp"
#include "mesh/triangle_mesh.hpp"
#include "rock/rock.hpp"

namespace tdbd::rock {

/// What is tested against an underside: a vertex, a cell of the rock's index, or a tile of cells.
enum class Around : std::size_t { vertex, cell, tile };

/// m, more than the rounding of places in single precision.
inline constexpr double single_place_margin = 1e-4;

/// The largest depth of a closed part along its z axis, as a function of the distance from that
/// axis and over a grid of square columns. Shows in a few operations that a place is below or
/// beside the part, and therefore outside. It does not classify places above the part's deepest
/// points. Lengths in m, in the part's frame.
struct Underside {
  double rings_per_m = 1.0, columns_per_m = 1.0;
  double x_lo = 0.0, y_lo = 0.0;
  int nx = 0, ny = 0;
  double margin = 0.0;  ///< m, margin within reach of the part rotated about its axis
  std::array<std::vector<Single>, 3>
      deepest_at;               ///< per ring, by Around: the largest z within reach
  std::vector<Single> deepest;  ///< per column
};

/// `cell`: cell size of the rock's index, m; its tiles are 4 x 4 x 4 cells. Not in the thesis.
Underside underside_of(const mesh::TriangleMesh& mesh_P, double cell);

/// Returns false only if all points of the vertex, cell or tile with the middle x_P are farther
/// than u.margin from the part rotated by any angle about its axis. `height`: half its extent along
/// z, m.
inline bool may_contain(const Underside& u, Around around, const Vec3& x_P, double height) {
  const std::vector<Single>& deepest_at = u.deepest_at[static_cast<std::size_t>(around)];
  const auto ring =
      static_cast<std::size_t>(std::sqrt(x_P.head<2>().squaredNorm()) * u.rings_per_m);
  return ring < deepest_at.size() &&
         x_P.z() - height - u.margin - single_place_margin <= deepest_at[ring];
}

/// The same for a vertex at this squared distance from the axis (m2) and depth z_P (m), both in
/// single precision, whose rounding single_place_margin covers.
inline bool may_contain(const Underside& u, Single r2, Single z_P) {
  const std::vector<Single>& deepest_at = u.deepest_at[static_cast<std::size_t>(Around::vertex)];
  const auto ring = static_cast<std::size_t>(std::sqrt(r2) * static_cast<Single>(u.rings_per_m));
  return ring < deepest_at.size() &&
         z_P - static_cast<Single>(u.margin + single_place_margin) <= deepest_at[ring];
}

/// Returns false only if the point x_P, known in single precision, is outside the part.
inline bool may_contain(const Underside& u, const Vec3& x_P) {
  const double i = (x_P.x() - u.x_lo) * u.columns_per_m, j = (x_P.y() - u.y_lo) * u.columns_per_m;
  if (!(i >= 0.0 && j >= 0.0 && i < u.nx && j < u.ny)) return false;
  const std::size_t column = at(static_cast<int>(j) * u.nx + static_cast<int>(i));
  return x_P.z() - single_place_margin <= u.deepest[column];
}

/// Buffers of find_around_box, kept between calls to avoid allocations.
struct BoxSidesWork {
  std::vector<int> chains;
  std::vector<int> known;           ///< vertices whose sides are known
  std::vector<std::uint8_t> sides;  ///< per vertex of the rock; 0, as between calls: not known
};

/// Bit mask of the sides of a box beyond which a point lies: bit 2 i for the lower, bit 2 i + 1 for
/// the upper side of axis i.
std::uint8_t sides_beyond(const mesh::Box& box, const Vec3& x);

/// Appends the vertices, of the cells that the region meets, around which a triangle may reach into
/// the box. A vertex is dropped only if it and all its neighbours lie beyond one side of the box,
/// because then all its triangles do, too. Fast if most vertices are dropped. The test uses places
/// in single precision; single_place_margin covers their rounding.
void find_around_box(const Rock& rock, const Region& region_W, const mesh::Box& box_P,
                     const Pose& X_PW, BoxSidesWork& work, std::vector<int>& near);

}  // namespace tdbd::rock
