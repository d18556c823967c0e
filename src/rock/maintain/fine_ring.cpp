#include "rock/maintain/fine_ring.hpp"

#include <algorithm>

#include "rock/maintain/ring_spokes.hpp"
#include "rock/maintain/star.hpp"
#include "rock/maintain/touched_region.hpp"

namespace tdbd::rock {
namespace {

using mesh::VertexStar;

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
  for (RingColumn* c : {&d.x, &d.y, &d.z}) wrap(*c, n);
  WideSingle bx, by, bz;
  TDBD_LOAD(bx, d.x.at + 1);
  TDBD_LOAD(by, d.y.at + 1);
  TDBD_LOAD(bz, d.z.at + 1);
  const WideFlags flat = ax * bx + ay * by + az * bz > Single{0};
  fine = bits_of(edges & shape & flat);
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
  if (!has_spokes(star)) return false;
  Spokes spokes;
  find_spokes(rock.surface, star, spokes);
  unsigned fine = 0;
  sift(spokes, star.size, limits, fine);
  const unsigned all = (1U << star.size) - 1U;
  return (fine & all) == all && !is_folded_outwards(rock, v);
}

}  // namespace tdbd::rock
