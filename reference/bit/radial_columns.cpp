#include "reference/bit/radial_columns.hpp"

#include <algorithm>
#include <cmath>

#include "core/types.hpp"

namespace tdbd::reference {
namespace {

/// A point relative to the fixed half-plane.
struct Passing {
  double r, phi, depth;  ///< radius, m; azimuth, rad; z - advance phi / (2 pi), m
};

bool takes_part(const bit::Part& part) {
  return part.cutter >= 0 && part.cutting == bit::Cutting::cuts;
}

double largest_radius(const bit::Bit& bit) {
  double reach = 0.0;
  for (const bit::Part& part : bit.parts)
    if (takes_part(part))
      for (const Vec3& x_P : part.mesh_P.positions)
        reach = std::max(reach, (part.X_BP * x_P).head<2>().norm());
  return reach;
}

/// The azimuth is unwrapped to within half a turn of the cutter's own, which is in [0, 2 pi).
Passing passing(const Vec3& x_B, double cutter_azimuth, double advance) {
  const double own = cutter_azimuth - full_turn * std::floor(cutter_azimuth / full_turn);
  const double phi = own + std::remainder(std::atan2(x_B[1], x_B[0]) - own, full_turn);
  return {x_B.head<2>().norm(), phi, x_B[2] - advance * phi / full_turn};
}

/// Applies the straight piece between two passings to all columns whose centre it covers.
void offer(const Passing& a, const Passing& b, std::size_t cutter, RadialColumns& columns) {
  const auto [near, far] = std::minmax(a.r, b.r);
  const auto first = static_cast<std::size_t>(std::ceil(std::max(0.0, near / columns.width - 0.5)));
  for (std::size_t i = first; i < columns.deepest.size(); ++i) {
    const double centre = columns.centre(i);
    if (centre > far) break;
    const double s = near < far ? (centre - a.r) / (b.r - a.r) : 0.0;
    const double depth = a.depth + s * (b.depth - a.depth);
    Deepest& deepest = columns.deepest[i][cutter];
    if (depth > deepest.depth) deepest = {a.phi + s * (b.phi - a.phi), depth};
  }
}

/// Applies one mesh edge from a_B to b_B, in pieces no longer than half a column.
void offer_edge(const Vec3& a_B, const Vec3& b_B, double azimuth, double advance,
                std::size_t cutter, RadialColumns& columns) {
  const int pieces = 1 + static_cast<int>((b_B - a_B).norm() / (0.5 * columns.width));
  Passing last = passing(a_B, azimuth, advance);
  for (int k = 1; k <= pieces; ++k) {
    const double s = static_cast<double>(k) / pieces;
    const Passing next = passing((1.0 - s) * a_B + s * b_B, azimuth, advance);
    offer(last, next, cutter, columns);
    last = next;
  }
}

void offer_part(const bit::Bit& bit, const bit::Part& part, double advance,
                RadialColumns& columns) {
  const auto cutter = static_cast<std::size_t>(part.cutter);
  const double azimuth = bit.cutters[cutter].azimuth;
  for (const mesh::Triangle& f : part.mesh_P.triangles)
    for (int i = 0; i < 3; ++i)
      offer_edge(part.X_BP * part.mesh_P.positions[f[i]],
                 part.X_BP * part.mesh_P.positions[f[(i + 1) % 3]], azimuth, advance, cutter,
                 columns);
}

}  // namespace

RadialColumns radial_columns(const bit::Bit& bit, double advance, double radial_spacing) {
  const double reach = largest_radius(bit);
  const double count = std::ceil(reach / radial_spacing);
  RadialColumns columns{reach, reach / count, {}};
  columns.deepest.assign(static_cast<std::size_t>(count), std::vector<Deepest>(bit.cutters.size()));
  for (const bit::Part& part : bit.parts)
    if (takes_part(part)) offer_part(bit, part, advance, columns);
  return columns;
}

}  // namespace tdbd::reference
