#pragma once

#include <array>
#include <cstddef>

#include "core/simd.hpp"
#include "core/types.hpp"
#include "rock/cut/cutting_bit.hpp"
#include "rock/cut/plane_sectors.hpp"
#include "rock/cut/plane_strip.hpp"
#include "rock/cut/swept_part.hpp"

namespace tdbd::rock {

/// Vectors of four vertices, one per lane. For loops that are TDBD_WIDE; all functions are inlined.
struct WideVec3 {
  Wide x, y, z;
};

TDBD_INLINE Vec3 lane_of(const WideVec3& x, std::size_t l) { return {x.x[l], x.y[l], x.z[l]}; }

/// The sums have the order of Eigen's products, so each lane is bitwise equal to `R * x`.
TDBD_INLINE void rotate(const Mat3& R, const WideVec3& x, WideVec3& y) {
  y.x = R(0, 0) * x.x + (R(0, 1) * x.y + R(0, 2) * x.z);
  y.y = R(1, 0) * x.x + (R(1, 1) * x.y + R(1, 2) * x.z);
  y.z = R(2, 0) * x.x + (R(2, 1) * x.y + R(2, 2) * x.z);
}

TDBD_INLINE void transform(const Pose& X, const WideVec3& x, WideVec3& y) {
  rotate(X.R, x, y);
  y.x += X.p.x();
  y.y += X.p.y();
  y.z += X.p.z();
}

/// Transposes a 4 x 4 matrix: a becomes the first element of each of the four, b the second, and so
/// on.
TDBD_INLINE void transpose(Wide& a, Wide& b, Wide& c, Wide& d) {
  const Wide ab0 = __builtin_shufflevector(a, b, 0, 4, 2, 6),
             ab1 = __builtin_shufflevector(a, b, 1, 5, 3, 7),
             cd0 = __builtin_shufflevector(c, d, 0, 4, 2, 6),
             cd1 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab0, cd0, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7);
}

/// The square root of each lane, correctly rounded.
TDBD_INLINE void square_root(const Wide& x, Wide& root) {
  root =
      Wide{__builtin_sqrt(x[0]), __builtin_sqrt(x[1]), __builtin_sqrt(x[2]), __builtin_sqrt(x[3])};
}

/// Paths of four vertices relative to a group (RelativePath), and their update directions.
struct WidePaths {
  WideVec3 q0, q1;  ///< m, in P
  WideVec3 u0, u1;  ///< in P
  WideVec3 u_W;
};

/// mapped_direction_W and relative_path for four vertices at these places (m), bitwise the same.
/// Only for groups without a core.
void find_paths(const CuttingGroup& g, const GroupMotion& m,
                const std::array<const Vec3*, lanes>& x_W, WidePaths& paths);

inline RelativePath path_of(const WidePaths& p, std::size_t l) {
  return {lane_of(p.q0, l), lane_of(p.q1, l), lane_of(p.u0, l), lane_of(p.u1, l)};
}

// PlaneStrip (plane_strip.hpp) for four vertices, each with the planes of its own sector. The
// formulas and their order are the same.

using Sectors = std::array<const PlaneSector*, lanes>;

/// One plane relative to the strip, rock (4), per vertex.
struct WideLine {
  Wide rest, along, up, twist;
};

/// The strips of four vertices. Row i contains plane i of each vertex's sector.
struct WideStrip {
  std::array<WideLine, PlaneSectors::most_rows> line;
  std::size_t rows;
};

/// Where rays leave and enter; see Crossing.
struct WideCrossing {
  Wide tau, t;
  WideMask row;
  WideLine line;
};

/// The last two entries of rays, and the row of the last.
struct WideEntry {
  Wide last, second;
  WideMask row;
};

TDBD_INLINE void fetch_line(const WideStrip& w, const WideMask& row, WideLine& line) {
  const WideLine &a = w.line[static_cast<std::size_t>(row[0])],
                 &b = w.line[static_cast<std::size_t>(row[1])],
                 &c = w.line[static_cast<std::size_t>(row[2])],
                 &d = w.line[static_cast<std::size_t>(row[3])];
  line.rest = Wide{a.rest[0], b.rest[1], c.rest[2], d.rest[3]};
  line.along = Wide{a.along[0], b.along[1], c.along[2], d.along[3]};
  line.up = Wide{a.up[0], b.up[1], c.up[2], d.up[3]};
  line.twist = Wide{a.twist[0], b.twist[1], c.twist[2], d.twist[3]};
}

/// Computes the intervals of tau in which the paths are deeper than `depth`, and the rows of the
/// strip; see put_path_on_strip.
TDBD_INLINE void put_on_strip(const Sectors& sectors, const WidePaths& p, double depth,
                              WideStrip& w, Wide& first, Wide& last) {
  const WideVec3 &q = p.q0, &u = p.u0;
  const WideVec3 d{p.q1.x - q.x, p.q1.y - q.y, p.q1.z - q.z},
      e{p.u1.x - u.x, p.u1.y - u.y, p.u1.z - u.z};
  first = Wide{};
  last = first + 1.0;
  for (std::size_t i = 0; i < w.rows; ++i) {
    Wide x, y, z, b;
    TDBD_LOAD(x, sectors[0]->rows.data() + 4 * i);
    TDBD_LOAD(y, sectors[1]->rows.data() + 4 * i);
    TDBD_LOAD(z, sectors[2]->rows.data() + 4 * i);
    TDBD_LOAD(b, sectors[3]->rows.data() + 4 * i);
    transpose(x, y, z, b);
    const Wide rest = b - (x * q.x + y * q.y + z * q.z);
    const Wide along = x * d.x + y * d.y + z * d.z;
    w.line[i] = {rest, along, x * u.x + y * u.y + z * u.z, x * e.x + y * e.y + z * e.z};
    narrow_interval(rest - depth, along, first, last);
  }
}

/// See leave_at. t is infinite if the ray leaves no plane.
TDBD_INLINE void leave(const WideStrip& w, const Wide& tau, WideCrossing& x) {
  x.tau = tau;
  x.t = Wide{} + unbounded;
  WideMask row{};
  x.row = row;
  for (std::size_t i = 0; i < w.rows; ++i, row += 1) {
    const WideLine& a = w.line[i];
    const Wide c = a.up + tau * a.twist;
    const Wide t = (a.rest - tau * a.along) / (c > grazing_cosine ? c : Wide{} + 1.0);
    const WideMask nearer = (c > grazing_cosine) & (t < x.t);
    x.row = nearer ? row : x.row;
    x.t = nearer ? t : x.t;
  }
  fetch_line(w, x.row, x.line);
}

/// See leave_at and enter_at.
TDBD_INLINE void leave_and_enter(const WideStrip& w, const Wide& tau, WideCrossing& x,
                                 WideEntry& in) {
  x.tau = tau;
  x.t = Wide{} + unbounded;
  Wide least = x.t, second = x.t;  // negated entries
  WideMask row{};
  x.row = in.row = row;
  for (std::size_t i = 0; i < w.rows; ++i, row += 1) {
    const WideLine& a = w.line[i];
    const Wide c = a.up + tau * a.twist, room = a.rest - tau * a.along;
    const WideMask leaves = c > grazing_cosine, enters = c < -grazing_cosine;
    const Wide t = room / ((leaves | enters) ? c : Wide{} + 1.0);
    const WideMask nearer = leaves & (t < x.t);
    x.row = nearer ? row : x.row;
    x.t = nearer ? t : x.t;
    const Wide never = room < 0.0 ? Wide{} - unbounded : Wide{} + unbounded;
    const Wide entry = enters ? -t : (leaves ? Wide{} + unbounded : never);
    const WideMask farther = entry < least;
    second = farther ? least : (entry < second ? entry : second);
    in.row = farther ? row : in.row;
    least = farther ? entry : least;
  }
  in.last = -least;
  in.second = -second;
  fetch_line(w, x.row, x.line);
}

/// The exits of four vertices from a solid. Bit l refers to vertex l.
struct WideExits {
  unsigned missed = 0;  ///< not swept
  unsigned found = 0;   ///< exits at these tau, t and row of the sector; the others are undecided
  std::array<double, lanes> tau, t, row;
  std::array<const PlaneSector*, lanes> sector;
};

/// find_exit (swept_part.hpp) for four vertices at once, each with the planes of its own sector,
/// with the same formulas in the same order. Missed and found vertices have bitwise the result of
/// find_exit with all planes, because the planes of the sector are sufficient at every place that
/// the search examines (plane_sectors.hpp). A vertex whose search examines any other place is in
/// neither mask. `depth`: as in find_exit.
void find_exits(const PlaneSectors& sectors, const WidePaths& paths, double depth,
                WideExits& exits);

/// The exit of a found vertex l, with the plane's index in the solid.
inline Crossing crossing_of(const WideExits& exits, std::size_t l) {
  return {exits.tau[l], exits.t[l], exits.sector[l]->plane[static_cast<std::size_t>(exits.row[l])]};
}

}  // namespace tdbd::rock
