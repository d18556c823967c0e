#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/single.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::rock {

/// What is tested against an underside: a vertex, a cell of the rock's index, or a tile of cells.
enum class Around : std::size_t { vertex, cell, tile };

/// m, more than the rounding of places in single precision.
inline constexpr double of_single_places = 1e-4;

/// The largest depth of a closed part along its z axis, as a function of the distance from that
/// axis and over a grid of square columns. Shows in a few operations that a place is below or
/// beside the part, and therefore outside. It does not classify places above the part's deepest
/// points. Lengths in m, in the part's frame.
struct Underside {
  double rings_per_m = 1.0, columns_per_m = 1.0;
  double x_lo = 0.0, y_lo = 0.0;
  int nx = 0, ny = 0;
  double room = 0.0;  ///< m, margin within reach of the part rotated about its axis
  std::array<std::vector<Single>, 3>
      deepest_at;               ///< per ring, by Around: the largest z within reach
  std::vector<Single> deepest;  ///< per column
};

/// `cell`: cell size of the rock's index, m; its tiles are 4 x 4 x 4 cells. Not in the thesis.
Underside underside_of(const mesh::TriangleMesh& mesh_P, double cell);

/// Returns false only if all points of the vertex, cell or tile with the middle x_P are farther
/// than u.room from the part rotated by any angle about its axis. `height`: half its extent along
/// z, m.
inline bool may_hold(const Underside& u, Around around, const Vec3& x_P, double height) {
  const std::vector<Single>& deepest_at = u.deepest_at[static_cast<std::size_t>(around)];
  const auto ring =
      static_cast<std::size_t>(std::sqrt(x_P.head<2>().squaredNorm()) * u.rings_per_m);
  return ring < deepest_at.size() &&
         x_P.z() - height - u.room - of_single_places <= deepest_at[ring];
}

/// The same for a vertex at this squared distance from the axis (m2) and depth z_P (m), both in
/// single precision, whose rounding of_single_places covers.
inline bool may_hold(const Underside& u, Single r2, Single z_P) {
  const std::vector<Single>& deepest_at = u.deepest_at[static_cast<std::size_t>(Around::vertex)];
  const auto ring = static_cast<std::size_t>(std::sqrt(r2) * static_cast<Single>(u.rings_per_m));
  return ring < deepest_at.size() &&
         z_P - static_cast<Single>(u.room + of_single_places) <= deepest_at[ring];
}

/// Returns false only if the point x_P, known in single precision, is outside the part.
inline bool may_hold(const Underside& u, const Vec3& x_P) {
  const double i = (x_P.x() - u.x_lo) * u.columns_per_m, j = (x_P.y() - u.y_lo) * u.columns_per_m;
  if (!(i >= 0.0 && j >= 0.0 && i < u.nx && j < u.ny)) return false;
  const std::size_t column = at(static_cast<int>(j) * u.nx + static_cast<int>(i));
  return x_P.z() - of_single_places <= u.deepest[column];
}

}  // namespace tdbd::rock
