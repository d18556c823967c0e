#pragma once

#include <array>
#include <limits>

#include "core/wide.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/relative_path.hpp"

namespace tdbd::rock {

/// Cosine below which a plane is parallel to a ray up to rounding, and does not block it.
inline constexpr double grazing_cosine = 1e-14;

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Narrows intervals of tau to where a path is inside its planes: at tau = 0 it is `room` (m) inside,
/// and until tau = 1 it goes `along` (m) outwards. A plane parallel to the path excludes all or nothing.
TDBD_INLINE void narrow_interval(const Wide& room, const Wide& along, Wide& first, Wide& last) {
  const Wide when = room / (along == 0.0 ? Wide{} + 1.0 : along);
  const Wide at_rest = room <= 0.0 ? Wide{} - 1.0 : Wide{} + unbounded;
  const Wide until = along > 0.0 ? when : (along < 0.0 ? Wide{} + unbounded : at_rest);
  const Wide from = along < 0.0 ? when : Wide{};
  last = until < last ? until : last;
  first = from > first ? from : first;
}

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
/// inside plane i while along tau + (up + twist tau) t <= rest. Only the first `columns` of each
/// array are set: one for each of the solid's planes, its padding included.
struct PlaneStrip {
  using Column = std::array<double, mesh::most_planes>;
  Column rest, along, up, twist;
  std::size_t columns = 0;
};

/// When q(tau) is inside; empty (lo >= hi) if never.
struct Interval {
  double lo, hi;
};

/// Sets `rest` and `along`. Returns when q(tau) is deeper than `depth` inside every plane; where it
/// never is, not all columns are set. Solids of more than mesh::most_planes planes are refused
/// (std::invalid_argument).
Interval put_path_on_strip(const mesh::ConvexSolid& s, const RelativePath& p, double depth,
                           PlaneStrip& w);

/// A plane that the path between these points does not come deeper than `depth` inside, so that
/// put_path_on_strip finds it nowhere inside; the number of columns if no plane alone shows it.
std::size_t plane_beside_path(const mesh::ConvexSolid& s, const Vec3& q0_P, const Vec3& q1_P,
                              double depth);

/// Whether plane i is one.
bool is_beside_path(const mesh::ConvexSolid& s, std::size_t i, const Vec3& q0_P, const Vec3& q1_P,
                    double depth);

/// Sets `up` and `twist`.
void put_direction_on_strip(const mesh::ConvexSolid& s, const RelativePath& p, PlaneStrip& w);

/// Where the ray at tau meets a plane. Of several planes at the same t it is the first.
struct Crossing {
  double tau, t;
  std::size_t plane;
};

/// Where the ray at tau leaves the solid; t is infinite if it never does.
Crossing leave_at(const PlaneStrip& w, double tau);

/// Where the ray at tau enters the last of the planes that it enters: minus infinity if there is
/// none, infinity if it is parallel to one and outside. It misses the solid if that is beyond where
/// it leaves.
Crossing enter_at(const PlaneStrip& w, double tau);

}  // namespace tdbd::rock
