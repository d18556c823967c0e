#pragma once

#include <vector>

#include "mesh/shape/convex.hpp"
#include "rock/cut/relative_path.hpp"

namespace tdbd::rock {

/// The strip q(tau) + t u(tau) seen by the planes of a convex solid: a point (tau, t) is inside
/// plane i while along tau + (up + twist tau) t <= rest. Columns over planes, kept between queries,
/// so that none allocates.
struct PlaneStrip {
  std::vector<double> rest, along, up, twist;
};

/// When q(tau) is deeper than `depth` inside every plane; empty (lo >= hi) if never.
struct Interval {
  double lo, hi;
};
Interval when_inside(const mesh::ConvexSolid& s, const RelativePath& p, double depth);

void put_on_strip(const mesh::ConvexSolid& s, const RelativePath& p, PlaneStrip& w);

/// Where the ray at tau leaves the solid, and the plane there; t is infinite if it never does. The
/// ray misses the solid if it leaves it before `entry`.
struct Exit {
  double tau, t;
  std::size_t plane;
  double entry;
};
Exit leave_at(const PlaneStrip& w, double tau);

/// The plane that the ray at tau enters last.
std::size_t last_entered(const PlaneStrip& w, double tau);

/// A straight way on the strip, and the point at which the planes are linearised for it.
struct Way {
  double tau0, t0;     ///< linearised here
  double tau, t;       ///< start
  double side, climb;  ///< direction
};

/// The first plane met on the way within `reach`, other than `on`: the plane underfoot does not
/// block, whatever rounding says. Shortens `reach` to it. Returns w.rest.size() if none.
std::size_t first_plane_on_way(const PlaneStrip& w, const Way& way, std::size_t on, double& reach);

}  // namespace tdbd::rock
