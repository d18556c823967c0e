#pragma once

#include <optional>

#include "reference/literature/surface/planar_region.hpp"

namespace tdbd::reference {

/// Shared by all surfaces of spokes (thesis: 2.1, fig. 2.1): half-planes through the hole's axis,
/// the z-axis, at equal angles. In the plane of a spoke, cutting is two-dimensional.
struct SpokePlane {
  double cosine = 1.0, sine = 0.0;  ///< of the azimuth

  /// Distance from the plane, m; positive towards increasing azimuth.
  double beside(const Vec3& x) const { return cosine * x.y() - sine * x.x(); }
  /// (r, z) of the point's projection onto the plane, m; r < 0 on the other side of the axis.
  Vec2 foot(const Vec3& x) const { return {cosine * x.x() + sine * x.y(), x.z()}; }
};

/// Azimuth of a spoke, with `spokes` spokes in total, rad.
double spoke_azimuth(int spoke, int spokes);

/// Its plane.
SpokePlane spoke_plane(int spoke, int spokes);

/// Where the line segment from a to b passes through the plane, if it does.
std::optional<Vec2> crossing(const SpokePlane& plane, const Vec3& a, const Vec3& b);

}  // namespace tdbd::reference
