#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// A point of a half-plane through the hole's axis: (r, z), m.
using Vec2 = Eigen::Vector2d;

/// A closed chain of straight edges; the last point joins the first.
using Outline = std::vector<Vec2>;

/// One piece of the plane: the region inside its border, less its cavities.
struct PlanarFace {
  Outline border;
  std::vector<Outline> cavities;
};

/// Pieces of the plane that do not overlap.
using PlanarRegion = std::vector<PlanarFace>;

/// Area with sign: positive if the outline goes round from +r to +z. m2.
double signed_area(const Outline& outline);

/// Integral of r over the enclosed area, sign as of the area. m3.
double signed_moment(const Outline& outline);

/// Area, and integral of r over it: 2 pi times that is the volume of revolution (Pappus). m2, m3.
double area(const PlanarRegion& region);
double moment(const PlanarRegion& region);

/// Whether the point is enclosed; arbitrary for points on an outline.
bool encloses(const Outline& outline, const Vec2& x);
bool encloses(const PlanarFace& face, const Vec2& x);

/// The convex outline around points, without points on its edges; empty if all are on one line.
Outline convex_outline(std::vector<Vec2> points);

}  // namespace tdbd::reference
