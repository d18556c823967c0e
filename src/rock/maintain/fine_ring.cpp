#include "rock/maintain/fine_ring.hpp"

#include <algorithm>

#include "core/wide.hpp"
#include "rock/maintain/star.hpp"
#include "rock/maintain/touched_region.hpp"

namespace tdbd::rock {
namespace {

using mesh::VertexStar;

/// Columns of the triangles around a vertex, the first repeated behind the last.
struct alignas(32) Column {
  Single at[2 * single_lanes] = {};
};

struct Spokes {
  Column x, y, z;
};

/// A triangle's two spokes, eight triangles side by side.
struct WideSpokes {
  WideSingle ex, ey, ez, fx, fy, fz;
};

/// For functions that are TDBD_WIDE.
inline void load(const Spokes& d, WideSpokes& w) {
  TDBD_LOAD(w.ex, d.x.at);
  TDBD_LOAD(w.ey, d.y.at);
  TDBD_LOAD(w.ez, d.z.at);
  TDBD_LOAD(w.fx, d.x.at + 1);
  TDBD_LOAD(w.fy, d.y.at + 1);
  TDBD_LOAD(w.fz, d.z.at + 1);
}

void wrap(Column& c, std::size_t n) { c.at[n] = c.at[0]; }

/// The neighbours less the vertex.
void find_spokes(const mesh::Surface& s, const VertexStar& star, Spokes& d) {
  const std::size_t n = star.size;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 spoke = s.position(star.ring[i]) - star.x;
    d.x.at[i] = static_cast<Single>(spoke.x());
    d.y.at[i] = static_cast<Single>(spoke.y());
    d.z.at[i] = static_cast<Single>(spoke.z());
  }
  for (Column* c : {&d.x, &d.y, &d.z}) wrap(*c, n);
}

/// Bit i tells whether triangle i is fine and not folded on the next.
TDBD_WIDE void sift(Spokes& d, std::size_t n, const FineLimits& l, unsigned& fine) {
  WideSpokes w;
  load(d, w);
  const auto& [ex, ey, ez, fx, fy, fz] = w;
  const WideSingle gx = fx - ex, gy = fy - ey, gz = fz - ez;
  const WideSingle e2 = ex * ex + ey * ey + ez * ez, f2 = fx * fx + fy * fy + fz * fz,
                   g2 = gx * gx + gy * gy + gz * gz, sum = e2 + f2 + g2;
  const WideSingle ax = ey * fz - ez * fy, ay = ez * fx - ex * fz, az = ex * fy - ey * fx;
  const WideSingle a2 = ax * ax + ay * ay + az * az;
  const WideFlags edges = (e2 > l.short2) & (e2 < l.long2) & (g2 > l.short2) & (g2 < l.long2);
  const WideFlags shape = (Single{12} * a2 > l.quality2 * sum * sum) & (-az > l.short2);
  TDBD_STORE(ax, d.x.at);
  TDBD_STORE(ay, d.y.at);
  TDBD_STORE(az, d.z.at);
  for (Column* c : {&d.x, &d.y, &d.z}) wrap(*c, n);
  WideSingle bx, by, bz;
  TDBD_LOAD(bx, d.x.at + 1);
  TDBD_LOAD(by, d.y.at + 1);
  TDBD_LOAD(bz, d.z.at + 1);
  const WideFlags flat = ax * bx + ay * by + az * bz > Single{0};
  fine = bits_of(edges & shape & flat);
}

/// Bit i tells whether triangle i faces up. Room for rounding: of an area's components below 1e-6
/// of the squared edges.
TDBD_WIDE void sift_upward(const Spokes& d, Single sine2, unsigned& upward) {
  WideSpokes w;
  load(d, w);
  const auto& [ex, ey, ez, fx, fy, fz] = w;
  const WideSingle scale = ex * ex + ey * ey + ez * ez + fx * fx + fy * fy + fz * fz;
  const WideSingle ax = ey * fz - ez * fy, ay = ez * fx - ex * fz, az = ex * fy - ey * fx;
  constexpr Single far_from_rounding = 2e-5F, room = 1.2F;
  const WideFlags flat = az * az > room * sine2 * (ax * ax + ay * ay + az * az);
  upward = bits_of(flat & (-az > far_from_rounding * scale));
}

/// The vertex that faces the edge (a, b) from the other side of triangle (v, a, b); -1: none.
int facing_from_outside(const mesh::Surface& s, int a, int b) {
  const VertexStar& star = s.star(a);
  const int* ring = s.ring(star);
  for (int i = 0; i < star.size; ++i)
    if (ring[i] == b) return i > 0 ? ring[i - 1] : (star.open != 0 ? -1 : ring[star.size - 1]);
  return -1;
}

/// Whether a triangle at v lies back to back with that across the edge that faces v, of those whose
/// both ends are untouched.
bool is_folded_outwards(const Rock& rock, int v) {
  const mesh::Surface& s = rock.surface;
  const VertexStar& star = s.star(v);
  for (std::size_t i = 0; i < star.size; ++i) {
    const int a = star.ring[i], b = star.ring[i + 1 < star.size ? i + 1 : 0];
    if (rock.touched[at(a)] != 0 || rock.touched[at(b)] != 0) continue;
    const int o = facing_from_outside(s, a, b);
    if (o >= 0 && are_folded(doubled_area({star.x, s.position(a), s.position(b)}),
                             doubled_area({s.position(o), s.position(b), s.position(a)})))
      return true;
  }
  return false;
}

}  // namespace

FineLimits fine_limits(const MaintenanceLimits& limits) {
  // Rounding of a squared edge, an area or their differences is below 1e-6 of the longest square,
  // that of a squared quality below 1e-5 of it as long as the quality is 0.01 or more.
  constexpr double slack = 1e-4, of_longest = 1e-6, least_quality = 0.01;
  const double short2 = limits.shortest_edge * limits.shortest_edge,
               long2 = limits.longest_edge * limits.longest_edge;
  const double quality =
      std::max({limits.worst_quality, limits.flip_quality, limits.smooth_quality, least_quality});
  return {static_cast<Single>((1.0 + slack) * short2 + of_longest * long2),
          static_cast<Single>((1.0 - slack) * long2),
          static_cast<Single>((1.0 + 10.0 * slack) * quality * quality)};
}

bool ring_is_fine(const Rock& rock, int v, const FineLimits& limits) {
  const VertexStar& star = rock.surface.star(v);
  if (star.open != 0 || star.long_ring >= 0) return false;
  Spokes spokes;
  find_spokes(rock.surface, star, spokes);
  unsigned fine = 0;
  sift(spokes, star.size, limits, fine);
  const unsigned all = (1U << star.size) - 1U;
  return (fine & all) == all && !is_folded_outwards(rock, v);
}

bool ring_faces_up(const mesh::Surface& s, int v, double sine) {
  const VertexStar& star = s.star(v);
  if (star.open != 0 || star.long_ring >= 0) return false;
  Spokes spokes;
  find_spokes(s, star, spokes);
  unsigned upward = 0;
  sift_upward(spokes, static_cast<Single>(sine * sine), upward);
  const unsigned all = (1U << star.size) - 1U;
  return (upward & all) == all;
}

}  // namespace tdbd::rock
