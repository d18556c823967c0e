#pragma once

#include <array>

#include "core/types.hpp"

namespace tdbd::reference {

/// Corners of a triangle, m.
using Corners = std::array<Vec3, 3>;

/// Volume swept by a triangle that moves from `from` to `to`, m3, positive against its normal (rock
/// removed), rock (10). x = (1-zeta) x_from + zeta x_to; det J has degree 1 in (xi, eta) and 2 in
/// zeta, so the centroid with two Gauss points in zeta is exact. Neighbours share their ruled
/// sides, so the sum over a surface is the exact change of the enclosed volume. Thesis: 4.3, figs.
/// 4.23, 4.24. Twin: reference/mesh/exact_volume.
double prism_volume(const Corners& from, const Corners& to);

}  // namespace tdbd::reference
