#include "rock/cut/wide_exits.hpp"

#include <cmath>

namespace tdbd::rock {
namespace {

/// See mapped_direction_W.
TDBD_INLINE void map_direction(const CuttingGroup& g, const GroupMotion& m, const WideVec3& x_W,
                               WideVec3& u_W) {
  WideVec3 x_D;
  transform(m.X_DW1, x_W, x_D);
  Wide rho;
  square_root(x_D.x * x_D.x + x_D.y * x_D.y, rho);
  const WideMask is_off_axis = rho > 0.0;
  const Wide safe = is_off_axis ? rho : Wide{} + 1.0;
  const Wide c = is_off_axis ? x_D.x / safe : Wide{} + 1.0, s = is_off_axis ? x_D.y / safe : Wide{};
  const Vec3& U = g.update_direction_B;
  const WideVec3 u_D{c * U.x() - s * U.y(), s * U.x() + c * U.y(), Wide{} + U.z()};
  rotate(m.R_WD1, u_D, u_W);
}

TDBD_WIDE void find_wide_paths(const CuttingGroup& g, const GroupMotion& m, const WideVec3& x_W,
                               WidePaths& p) {
  map_direction(g, m, x_W, p.u_W);
  transform(m.X_PW0, x_W, p.q0);
  transform(m.X_PW1, x_W, p.q1);
  rotate(m.X_PW0.R, p.u_W, p.u0);
  rotate(m.X_PW1.R, p.u_W, p.u1);
}

}  // namespace

void find_paths(const CuttingGroup& g, const GroupMotion& m,
                const std::array<const Vec3*, lanes>& x_W, WidePaths& paths) {
  const WideVec3 places_W{{x_W[0]->x(), x_W[1]->x(), x_W[2]->x(), x_W[3]->x()},
                          {x_W[0]->y(), x_W[1]->y(), x_W[2]->y(), x_W[3]->y()},
                          {x_W[0]->z(), x_W[1]->z(), x_W[2]->z(), x_W[3]->z()}};
  find_wide_paths(g, m, places_W, paths);
}

namespace {

TDBD_INLINE void select(const WideMask& which, const WideLine& from, WideLine& to) {
  to.rest = which ? from.rest : to.rest;
  to.along = which ? from.along : to.along;
  to.up = which ? from.up : to.up;
  to.twist = which ? from.twist : to.twist;
}

TDBD_INLINE void select(const WideMask& which, const WideCrossing& from, WideCrossing& to) {
  to.tau = which ? from.tau : to.tau;
  to.t = which ? from.t : to.t;
  to.row = which ? from.row : to.row;
  select(which, from.line, to.line);
}

/// Growth with tau of the exit through the crossing's plane; see rise in swept_part.cpp.
TDBD_INLINE void rise(const WideCrossing& x, Wide& growth) {
  growth = -(x.line.along + x.t * x.line.twist);
}

/// Distance of x outside a plane.
TDBD_INLINE void distance_beyond(const WideLine& a, const WideCrossing& x, Wide& beyond) {
  beyond = a.along * x.tau + (a.up + a.twist * x.tau) * x.t - a.rest;
}

/// Whether x is on a plane, within `corner_tolerance`.
TDBD_INLINE void touches(const WideLine& a, const WideCrossing& x, WideMask& on) {
  Wide beyond;
  distance_beyond(a, x, beyond);
  on = (beyond < 0.0 ? -beyond : beyond) <= corner_tolerance;
}

/// State of the search; see Search in swept_part.cpp. In `found` lanes, `in` is the top.
struct WideSearch {
  WideCrossing in, out;
  Wide side;
  WideMask has_entered;  ///< the ray of `out` enters this plane too late
  WideMask entered_row;
  WideLine entered;
  WideMask active, found;
  Wide t_lo, t_hi;  ///< range of t over all looks
};

TDBD_INLINE void distance_from_in(const WideSearch& s, const Wide& tau, Wide& distance) {
  const Wide way = s.side * (tau - s.in.tau);
  const WideMask between = (way >= 0.0) & (s.side * (s.out.tau - tau) >= 0.0);
  distance = between ? way : Wide{} + unbounded;
}

/// See meeting in swept_part.cpp.
TDBD_INLINE void meeting(const WideSearch& s, const WideLine& k, const WideLine& l, Wide& tau) {
  const Wide square = l.along * k.twist - k.along * l.twist;
  const Wide slope = k.rest * l.twist - l.rest * k.twist + l.along * k.up - k.along * l.up;
  const Wide at_zero = k.rest * l.up - l.rest * k.up;
  const Wide under = slope * slope - 4.0 * square * at_zero;
  Wide root;
  square_root(under > 0.0 ? under : Wide{}, root);
  const WideMask is_minus = __builtin_bit_cast(WideMask, slope) < 0;
  const Wide below = slope + (is_minus ? -root : root);
  const Wide near = -2.0 * at_zero / below, far = -0.5 * below / square;
  Wide far_way, near_way;
  distance_from_in(s, far, far_way);
  distance_from_in(s, near, near_way);
  const Wide lo = s.out.tau < s.in.tau ? s.out.tau : s.in.tau,
             hi = s.in.tau < s.out.tau ? s.out.tau : s.in.tau;
  const Wide nearer = far_way < near_way ? far : near;
  tau = nearer < lo ? lo : (hi < nearer ? hi : nearer);
  tau = below == 0.0 ? s.in.tau : tau;
}

TDBD_INLINE void is_end(const Sectors& sectors, const WideMask& row, WideMask& end) {
  end = WideMask{sectors[0]->ends >> row[0] & 1, sectors[1]->ends >> row[1] & 1,
                 sectors[2]->ends >> row[2] & 1, sectors[3]->ends >> row[3] & 1} != 0;
}

/// Whether the crossing is in the core.
TDBD_INLINE void is_in_core(const PlaneSectors& all, const WidePaths& p, const WideCrossing& at,
                            WideMask& inside) {
  const Wide &tau = at.tau, &t = at.t;
  const Wide x = p.q0.x + tau * (p.q1.x - p.q0.x) + t * (p.u0.x + tau * (p.u1.x - p.u0.x)),
             y = p.q0.y + tau * (p.q1.y - p.q0.y) + t * (p.u0.y + tau * (p.u1.y - p.u0.y)),
             z = p.q0.z + tau * (p.q1.z - p.q0.z) + t * (p.u0.z + tau * (p.u1.z - p.u0.z));
  inside = (x >= all.core_lo) & (x <= all.core_hi) &
           (y * y + z * z <= all.core_radius * std::abs(all.core_radius));
}

/// Deactivates the lanes in which the planes of the sector are not sufficient at x, where a ray
/// leaves. Extends the range of t of lanes whose x must be in the wedge. Rays that leave long
/// before t = 0 do so in the core.
TDBD_INLINE void check_probe(const PlaneSectors& all, const Sectors& sectors, const WidePaths& p,
                             const WideStrip& w, const WideCrossing& x, const WideEntry& entry,
                             WideSearch& s) {
  const WideMask outside = entry.last > x.t + entry_tolerance;
  s.active &= (x.t < unbounded) & ~(entry.second > x.t + entry_tolerance);
  if (lane_bits(s.active & outside) != 0) {
    WideLine line{};
    Wide beyond;
    WideMask end;
    fetch_line(w, entry.row, line);
    distance_beyond(line, x, beyond);
    is_end(sectors, entry.row, end);
    s.active &= ~outside | (end & (beyond <= all.beyond));
  }
  WideMask is_early = s.active & (x.t < s.t_lo);
  if (lane_bits(is_early) != 0) {
    WideMask in_core;
    is_in_core(all, p, x, in_core);
    is_early &= ~in_core;
  }
  s.t_lo = is_early ? x.t : s.t_lo;
  s.t_hi = (s.active & (x.t > s.t_hi)) ? x.t : s.t_hi;
}

TDBD_INLINE void finish(const WideMask& which, const WideCrossing& x, WideSearch& s) {
  select(which, x, s.in);
  s.found |= which;
  s.active &= ~which;
}

/// The next tau and the reason for it; see Look in swept_part.cpp.
struct WideProbe {
  Wide tau;
  WideMask is_end, is_middle;
};

/// Whether the two planes of the look meet at x.
TDBD_INLINE void is_corner(const WideSearch& s, const WideMask& is_end, const WideCrossing& x,
                           WideMask& corner) {
  WideLine other = s.in.line;
  select(is_end, s.entered, other);
  WideMask on_other;
  touches(s.out.line, x, corner);
  touches(other, x, on_other);
  corner &= on_other;
}

/// See next_tau and highest in swept_part.cpp. Finishes the lanes whose `in` is the top.
TDBD_INLINE void choose_probe(WideSearch& s, WideProbe& look) {
  Wide top, end = s.out.tau, out_growth;
  meeting(s, s.in.line, s.out.line, top);
  if (lane_bits(s.active & s.has_entered) != 0) {
    Wide there;
    meeting(s, s.out.line, s.entered, there);
    end = s.has_entered ? there : end;
  }
  rise(s.out, out_growth);
  const WideMask grows = (s.out.t >= 0.0) & (s.side * out_growth >= 0.0);
  s.active &= ~(grows & ~s.has_entered);
  look.is_end = s.has_entered & (grows | (s.side * (top - end) >= 0.0));
  look.tau = look.is_end ? end : top;
  const WideMask at_in = look.tau == s.in.tau, at_out = look.tau == s.out.tau;
  look.is_middle = WideMask{};
  if (lane_bits(s.active & (at_in | at_out)) == 0) return;
  WideMask in_corner, out_corner;
  is_corner(s, look.is_end, s.in, in_corner);
  is_corner(s, look.is_end, s.out, out_corner);
  look.is_middle = (at_in & ~in_corner) | (~at_in & at_out & ~out_corner);
  look.tau = look.is_middle ? 0.5 * (s.in.tau + s.out.tau) : look.tau;
  finish(s.active & at_in & in_corner, s.in, s);
}

/// See narrow in swept_part.cpp.
TDBD_INLINE void narrow(const WideStrip& w, const WideProbe& look, const WideCrossing& x,
                        const WideEntry& entry, WideSearch& s) {
  WideMask corner;
  is_corner(s, look.is_end, x, corner);
  corner &= ~look.is_middle;
  const WideMask may_miss = s.has_entered | (s.out.t < 0.0);
  const WideMask late = may_miss & (x.t >= 0.0) & ~(entry.last <= x.t + entry_tolerance);
  const WideMask same = corner & (x.row == s.out.row);
  const WideMask is_end = late & same & s.has_entered & (entry.row == s.entered_row);
  Wide growth;
  rise(x, growth);
  growth = x.t < 0.0 ? Wide{} - 1.0 : s.side * growth;
  const WideMask is_top = ~late & ((growth == 0.0) | (same & (look.is_end | (growth < 0.0))) |
                                   (corner & (growth > 0.0) & (x.row == s.in.row) & ~look.is_end));
  finish(s.active & (is_end | is_top), x, s);
  const WideMask to_in = s.active & ~late & (growth > 0.0), to_out = s.active & ~to_in;
  select(to_in, x, s.in);
  select(to_out, x, s.out);
  s.has_entered = to_out ? late : s.has_entered;
  const WideMask is_late = s.active & late;
  if (lane_bits(is_late) == 0) return;
  WideLine entered{};
  fetch_line(w, entry.row, entered);
  s.entered_row = is_late ? entry.row : s.entered_row;
  select(is_late, entered, s.entered);
}

/// The search from the first look on, which is at one end of the interval or in its middle; see
/// find_exit.
TDBD_INLINE void search(const PlaneSectors& all, const Sectors& sectors, const WidePaths& p,
                        const WideStrip& w, const WideMask& from_start, const WideMask& to_end,
                        WideSearch& s) {
  Wide growth;
  rise(s.in, growth);
  const Wide end = growth > 0.0 ? Wide{} + 1.0 : Wide{};
  finish(s.active & ((growth == 0.0) | (s.in.tau == end)), s.in, s);
  if (lane_bits(s.active) == 0) return;
  WideEntry entry;
  leave_and_enter(w, end, s.out, entry);
  check_probe(all, sectors, p, w, s.out, entry, s);
  s.side = growth > 0.0 ? Wide{} + 1.0 : Wide{} - 1.0;
  const WideMask is_inside = growth > 0.0 ? to_end : from_start;
  s.has_entered = ~is_inside & (s.out.t >= 0.0) & ~(entry.last <= s.out.t + entry_tolerance);
  s.entered_row = entry.row;
  fetch_line(w, entry.row, s.entered);
  rise(s.out, growth);
  finish(s.active & ~s.has_entered & ~(s.out.t < 0.0) & (s.side * growth >= 0.0), s.out, s);
  constexpr int most_probes = 16;
  for (int k = 0; k < most_probes && lane_bits(s.active) != 0; ++k) {
    WideProbe look;
    choose_probe(s, look);
    if (lane_bits(s.active) == 0) return;
    WideCrossing x{};
    leave_and_enter(w, look.tau, x, entry);
    check_probe(all, sectors, p, w, x, entry, s);
    narrow(w, look, x, entry, s);
  }
}

/// Whether q0 + t u0 and q1 + t u1 are in the wedges, and therefore the part of the strip between
/// them.
TDBD_INLINE void check_wedge(const Sectors& sectors, const WidePaths& p, const Wide& t,
                             WideMask& inside) {
  Wide lo_y, lo_z, hi_y, hi_z;
  TDBD_LOAD(lo_y, sectors[0]->sides.data());
  TDBD_LOAD(lo_z, sectors[1]->sides.data());
  TDBD_LOAD(hi_y, sectors[2]->sides.data());
  TDBD_LOAD(hi_z, sectors[3]->sides.data());
  transpose(lo_y, lo_z, hi_y, hi_z);
  const Wide y0 = p.q0.y + t * p.u0.y, z0 = p.q0.z + t * p.u0.z, y1 = p.q1.y + t * p.u1.y,
             z1 = p.q1.z + t * p.u1.z;
  inside = (lo_y * y0 + lo_z * z0 >= 0.0) & (hi_y * y0 + hi_z * z0 >= 0.0) &
           (lo_y * y1 + lo_z * z1 >= 0.0) & (hi_y * y1 + hi_z * z1 >= 0.0);
}

TDBD_INLINE void squared_norm(const WideVec3& x, Wide& square) {
  square = x.x * x.x + x.y * x.y + x.z * x.z;
}

/// Whether the strips are in the wedges and near the solid for t between t_lo and t_hi.
TDBD_INLINE void check_strip(const PlaneSectors& all, const Sectors& sectors, const WidePaths& p,
                             const Wide& t_lo, const Wide& t_hi, WideMask& inside) {
  Wide square0, square1;
  WideMask below, above;
  check_wedge(sectors, p, t_lo, below);
  check_wedge(sectors, p, t_hi, above);
  squared_norm(p.q0, square0);
  squared_norm(p.q1, square1);
  const double size = all.size, most = 4.0 * size * size;
  inside = below & above & (square0 <= most) & (square1 <= most) & (t_lo >= -size) & (t_hi <= size);
}

TDBD_WIDE void find_in_sectors(const PlaneSectors& all, const WidePaths& p, double depth,
                               WideExits& exits) {
  const Sectors& sectors = exits.sector;
  WideStrip w;
  w.rows = all.rows;
  Wide first, last;
  put_on_strip(sectors, p, depth, w, first, last);
  const WideMask swept = first < last, from_start = first == 0.0, to_end = last == 1.0;
  exits.missed = lane_bits(~swept);
  exits.found = 0;
  if (lane_bits(swept) == 0) return;
  WideSearch s{};
  s.active = swept;
  s.found = WideMask{};
  leave(w, to_end ? Wide{} + 1.0 : (from_start ? Wide{} : 0.5 * (first + last)), s.in);
  s.active &= s.in.t < unbounded;
  s.t_lo = s.in.t < 0.0 ? s.in.t : Wide{};
  s.t_hi = s.in.t > 0.0 ? s.in.t : Wide{};
  search(all, sectors, p, w, from_start, to_end, s);
  WideMask inside;
  check_strip(all, sectors, p, s.t_lo, s.t_hi, inside);
  exits.found = lane_bits(s.found & inside);
  const Wide row = {static_cast<double>(s.in.row[0]), static_cast<double>(s.in.row[1]),
                    static_cast<double>(s.in.row[2]), static_cast<double>(s.in.row[3])};
  TDBD_STORE(s.in.tau, exits.tau.data());
  TDBD_STORE(s.in.t, exits.t.data());
  TDBD_STORE(row, exits.row.data());
}

}  // namespace

void find_exits(const PlaneSectors& all, const WidePaths& p, double depth, WideExits& exits) {
  for (std::size_t l = 0; l < lanes; ++l)
    exits.sector[l] = &all.towards(p.q0.y[l] + p.q1.y[l], p.q0.z[l] + p.q1.z[l]);
  find_in_sectors(all, p, depth, exits);
}

}  // namespace tdbd::rock
