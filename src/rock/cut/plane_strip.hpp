#pragma once

#include <vector>

#include "core/wide.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/relative_path.hpp"

namespace tdbd::rock {

/// Four planes of a solid, n . x <= b, side by side.
struct WidePlanes {
  Wide x, y, z, b;
};

/// The planes from column i on. For loops that are TDBD_WIDE.
inline void load(const mesh::ConvexSolid& s, std::size_t i, WidePlanes& planes) {
  TDBD_LOAD(planes.x, &s.nx[i]);
  TDBD_LOAD(planes.y, &s.ny[i]);
  TDBD_LOAD(planes.z, &s.nz[i]);
  TDBD_LOAD(planes.b, &s.b[i]);
}

/// The strip q(tau) + t u(tau) against the planes of a convex solid, rock (4): a point (tau, t) is
/// inside plane i while along tau + (up + twist tau) t <= rest. Columns over planes, kept between
/// queries so that none allocates.
struct PlaneStrip {
  std::vector<double> rest, along, up, twist;
};

/// When q(tau) is deeper than `depth` inside every plane; empty (lo >= hi) if never.
struct Interval {
  double lo, hi;
};
Interval when_inside(const mesh::ConvexSolid& s, const RelativePath& p, double depth);

void put_on_strip(const mesh::ConvexSolid& s, const RelativePath& p, PlaneStrip& w);

/// Where the ray at tau leaves the solid, and through which plane; t is infinite if it never does.
/// The ray misses the solid if t < entry.
struct Exit {
  double tau, t;
  std::size_t plane;
  double entry;
};
Exit leave_at(const PlaneStrip& w, double tau);

/// The plane that the ray at tau enters last.
std::size_t last_entered(const PlaneStrip& w, double tau);

/// A straight path on the strip, and the point at which the planes are linearised for it.
struct Way {
  double tau0, t0;     ///< linearised here
  double tau, t;       ///< start
  double side, climb;  ///< direction
};

/// The first plane met on the way within `reach`, other than `on`, the plane the way runs along,
/// which rounding must not let block it. Shortens `reach` to it. Returns w.rest.size() if none.
std::size_t first_plane_on_way(const PlaneStrip& w, const Way& way, std::size_t on, double& reach);

}  // namespace tdbd::rock
