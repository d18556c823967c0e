#pragma once

#include "reference/literature/surface/planar_region.hpp"

namespace tdbd::reference {

/// Regularised booleans in the plane, by Boost.Polygon: exact on the points of a grid of 1 nm, to
/// which all coordinates are rounded before and after. So an edge moves by up to 1 nm, and
/// crossings, folds and coinciding edges that rounding causes are resolved by the next boolean.
/// |coordinates| below 2 m; throws std::invalid_argument beyond.
inline constexpr double planar_grid = 1e-9;  ///< m

/// The nearest point of the grid.
Vec2 on_grid(const Vec2& x);

/// The region without what the outline encloses; without what any of them encloses.
PlanarRegion without(const PlanarRegion& region, const Outline& tool);
PlanarRegion without_all(const PlanarRegion& region, const std::vector<Outline>& tools);

/// The part of the region that the outline encloses.
PlanarRegion within(const PlanarRegion& region, const Outline& window);

}  // namespace tdbd::reference
