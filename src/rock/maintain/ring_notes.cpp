#include "rock/maintain/ring_notes.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "rock/maintain/ring_spokes.hpp"

namespace tdbd::rock {
namespace {

using mesh::VertexStar;

/// Results for the triangles of a ring, one bit per triangle.
struct Sifted {
  unsigned leans = 0, fine = 0, turned = 0;
};

/// The area vectors of the triangles divided by the sums of the squares of their spokes, and
/// whether the triangles lean.
struct Areas {
  RingColumn x, y, z;
  RingFlags leans;
};

/// Stores the first eight again from index n on.
template <class Ring, class Wide>
[[gnu::always_inline]] inline void repeat(Ring& c, std::size_t n, const Wide& first) {
  static_assert(sizeof(Ring) == 2 * sizeof(Wide));  // n is at most eight
  TDBD_STORE(first, c.at);
  TDBD_STORE(first, c.at + n);
}

/// Bit i: triangle i and another one, one of which leans, may be turned by more than 90 degrees
/// against each other. Every pair is tested once or twice.
TDBD_WIDE void sift_pairs(const Areas& a, std::size_t n, unsigned& turned) {
  constexpr Single far_from_rounding = 1e-5F;
  WideSingle x, y, z;
  WideFlags leans, found = {};
  TDBD_LOAD(x, a.x.at);
  TDBD_LOAD(y, a.y.at);
  TDBD_LOAD(z, a.z.at);
  TDBD_LOAD(leans, a.leans.at);
  for (std::size_t k = 1; k <= n / 2; ++k) {
    WideSingle ox, oy, oz;
    WideFlags other_leans;
    TDBD_LOAD(ox, a.x.at + k);
    TDBD_LOAD(oy, a.y.at + k);
    TDBD_LOAD(oz, a.z.at + k);
    TDBD_LOAD(other_leans, a.leans.at + k);
    found |= ~(x * ox + y * oy + z * oz > far_from_rounding) & (leans | other_leans);
  }
  turned = bits_of(found);
}

/// Fine: edges and quality within the limits, facing up, not folded on the next triangle. Leaning:
/// the rounding error of a component of an area over the squares of the spokes is below 1e-6; a
/// degenerate triangle leans.
TDBD_WIDE void sift(const mesh::Surface& s, const VertexStar& star, const RingLimits& l,
                    Sifted& found) {
  constexpr Single far_from_rounding = 2e-5F, room = 1.2F, no_size = 1e-30F;
  const std::size_t n = star.size;
  const unsigned all = (1U << n) - 1U;
  Spokes d;
  find_spokes(s, star, d);
  WideSpokes w;
  load(d, w);
  const auto& [ex, ey, ez, fx, fy, fz] = w;
  const WideSingle gx = fx - ex, gy = fy - ey, gz = fz - ez;
  const WideSingle e2 = ex * ex + ey * ey + ez * ez, f2 = fx * fx + fy * fy + fz * fz,
                   g2 = gx * gx + gy * gy + gz * gz, sum = e2 + f2 + g2;
  WideSingle ax = ey * fz - ez * fy, ay = ez * fx - ex * fz, az = ex * fy - ey * fx;
  const WideSingle a2 = ax * ax + ay * ay + az * az;
  const WideFlags edges = (e2 > l.short2) & (e2 < l.long2) & (g2 > l.short2) & (g2 < l.long2);
  const WideFlags shape = (Single{12} * a2 > l.quality2 * sum * sum) & (-az > l.short2);
  const WideSingle per_size = Single{1} / (e2 + f2 + no_size);
  ax *= per_size;
  ay *= per_size;
  az *= per_size;
  const WideFlags leans =
      ~((az * az > room * l.sine2 * (ax * ax + ay * ay + az * az)) & (-az > far_from_rounding));
  Areas a;
  repeat(a.x, n, ax);
  repeat(a.y, n, ay);
  repeat(a.z, n, az);
  WideSingle bx, by, bz;
  TDBD_LOAD(bx, a.x.at + 1);
  TDBD_LOAD(by, a.y.at + 1);
  TDBD_LOAD(bz, a.z.at + 1);
  const WideFlags flat = ax * bx + ay * by + az * bz > Single{0};
  found.fine = bits_of(edges & shape & flat) & all;
  found.leans = bits_of(leans) & all;
  found.turned = 0;
  if (found.leans == 0) return;
  repeat(a.leans, n, leans);
  sift_pairs(a, n, found.turned);
  found.turned &= all;
}

/// Discards the notes of the rings around every vertex that changed.
void discard_changed(Rock& rock) {
  std::vector<std::uint16_t>& of = rock.notes.of;
  for (const int v : rock.touched_list) {
    if ((of[at(v)] & ring_unchanged) != 0 || !rock.surface.is_alive(v)) continue;
    of[at(v)] = ring_unchanged;
    const VertexStar& star = rock.surface.star(v);
    const int* ring = rock.surface.ring(star);
    for (int i = 0; i < star.size; ++i) {
      std::uint16_t& note = of[at(ring[i])];
      note = static_cast<std::uint16_t>(note & ring_unchanged);
    }
  }
}

/// Prefetches what look_at_ring reads for vertices farther on in the list.
void prefetch(const mesh::Surface& s, const std::vector<int>& vertices, std::size_t i) {
  constexpr std::size_t farther = 16, nearer = 8;
  if (i + farther < vertices.size()) __builtin_prefetch(&s.stars[at(vertices[i + farther])]);
  if (i + nearer >= vertices.size()) return;
  const VertexStar& star = s.star(vertices[i + nearer]);
  if (star.long_ring >= 0) return;
  for (int k = 0; k < star.size; ++k) __builtin_prefetch(&s.stars[at(star.ring[at(k)])]);
}

/// Each call of look_at_ring writes only the note of its own vertex, so the calls may run in
/// parallel.
void look_at_rings(const std::vector<int>& vertices, const mesh::Surface& s, RingNotes& notes) {
  constexpr std::size_t per_chunk = 64;
  const std::size_t chunks = (vertices.size() + per_chunk - 1) / per_chunk;
  parallel_for(static_cast<int>(chunks), [&](int k) {
    const std::size_t first = at(k) * per_chunk, end = std::min(first + per_chunk, vertices.size());
    for (std::size_t i = first; i < end; ++i) {
      prefetch(s, vertices, i);
      notes.of[at(vertices[i])] = look_at_ring(s, vertices[i], notes.limits);
    }
  });
}

}  // namespace

RingLimits ring_limits(const MaintenanceLimits& limits) {
  // The rounding error of a squared edge, an area or their differences is below 1e-6 of the longest
  // square. That of a squared quality is below 1e-5 of it if the quality is at least 0.01.
  constexpr double slack = 1e-4, of_longest = 1e-6, least_quality = 0.01;
  const double short2 = limits.shortest_edge * limits.shortest_edge,
               long2 = limits.longest_edge * limits.longest_edge;
  const double quality =
      std::max({limits.worst_quality, limits.flip_quality, limits.smooth_quality, least_quality});
  return {static_cast<Single>(limits.steepest_overhang * limits.steepest_overhang),
          static_cast<Single>((1.0 + slack) * short2 + of_longest * long2),
          static_cast<Single>((1.0 - slack) * long2),
          static_cast<Single>((1.0 + 10.0 * slack) * quality * quality)};
}

std::uint16_t look_at_ring(const mesh::Surface& s, int v, const RingLimits& limits) {
  constexpr unsigned known = ring_unchanged | ring_known, all_lean = 0xffU << first_leaning_bit;
  const VertexStar& star = s.star(v);
  if (!has_spokes(star)) return known | all_lean | ring_may_fold;
  Sifted found;
  sift(s, star, limits, found);
  const unsigned all = (1U << star.size) - 1U;
  return static_cast<std::uint16_t>(known | (found.turned != 0 ? ring_may_fold : 0U) |
                                    (found.fine == all ? ring_fine : 0U) |
                                    found.leans << first_leaning_bit);
}

void begin_notes(Rock& rock, const MaintenanceLimits& limits, OldNotes old_notes,
                 std::vector<int>& unknown) {
  RingNotes& notes = rock.notes;
  const RingLimits now = ring_limits(limits);
  if (old_notes == OldNotes::discarded || now != notes.limits) notes.of.clear();
  notes.limits = now;
  notes.of.resize(rock.surface.stars.size(), 0);
  discard_changed(rock);
  unknown.resize(rock.touched_list.size());
  std::size_t found = 0;
  for (const int v : rock.touched_list)
    if ((notes.of[at(v)] & ring_known) == 0 && rock.surface.is_alive(v)) unknown[found++] = v;
  unknown.resize(found);
  look_at_rings(unknown, rock.surface, notes);
}

}  // namespace tdbd::rock
