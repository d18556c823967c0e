#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// A point of a half-plane through the hole's axis: (r, z), m.
using Vec2 = Eigen::Vector2d;

/// A closed chain of straight edges. The last point is connected to the first.
using Outline = std::vector<Vec2>;

/// One piece of the plane: the region inside its border, minus its cavities.
struct PlanarFace {
  Outline border;
  std::vector<Outline> cavities;
};

/// Pieces of the plane that do not overlap.
using PlanarRegion = std::vector<PlanarFace>;

/// Signed area, positive if the outline runs from +r to +z. m2.
double signed_area(const Outline& outline);

/// Integral of r over the enclosed area, with the sign of the area. m3.
double signed_moment(const Outline& outline);

/// Area, and integral of r over it, which times 2 pi is the volume of revolution (Pappus). m2, m3.
double area(const PlanarRegion& region);
double moment(const PlanarRegion& region);

/// Whether the point is enclosed. Arbitrary for points on an outline.
bool encloses(const Outline& outline, const Vec2& x);
bool encloses(const PlanarFace& face, const Vec2& x);

/// The convex hull of points, without points on its edges. Empty if all points are on one line.
Outline convex_outline(std::vector<Vec2> points);

}  // namespace tdbd::reference
