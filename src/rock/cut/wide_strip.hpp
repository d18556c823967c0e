#pragma once

#include <array>

#include "rock/cut/plane_sectors.hpp"
#include "rock/cut/swept_convex.hpp"
#include "rock/cut/wide_paths.hpp"

/// PlaneStrip (plane_strip.hpp) for four vertices, each with the planes of its own sector. The
/// formulas and their order are the same.
namespace tdbd::rock {

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

}  // namespace tdbd::rock
