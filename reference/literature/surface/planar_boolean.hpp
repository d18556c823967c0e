#pragma once

#include "reference/literature/surface/planar_region.hpp"

namespace tdbd::reference {

/// Regularised booleans in the plane, by Boost.Polygon. They are exact on the points of a grid of 1
/// nm, to which all coordinates are rounded before and after. So an edge moves by up to 1 nm;
/// crossings, folds and coinciding edges due to rounding are resolved by the next boolean.
/// |coordinates| must be below 2 m; otherwise throws std::invalid_argument.
inline constexpr double planar_grid = 1e-9;  ///< m

/// The nearest point of the grid.
Vec2 on_grid(const Vec2& x);

/// The region without the part that the outline encloses, or that any of the outlines encloses.
PlanarRegion without(const PlanarRegion& region, const Outline& tool);
PlanarRegion without_all(const PlanarRegion& region, const std::vector<Outline>& tools);

/// The part of the region that the outline encloses.
PlanarRegion within(const PlanarRegion& region, const Outline& window);

}  // namespace tdbd::reference
