#include "rock/maintain/ring_notes.hpp"

#include <algorithm>
#include <bit>

#include "core/parallel.hpp"
#include "rock/maintain/touched_region.hpp"

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
  constexpr Single far_from_rounding = 2e-5F, margin = 1.2F, no_size = 1e-30F;
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
      ~((az * az > margin * l.sine2 * (ax * ax + ay * ay + az * az)) & (-az > far_from_rounding));
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

/// Prefetches what compute_ring_note reads for vertices farther on in the list.
void prefetch(const mesh::Surface& s, const std::vector<int>& vertices, std::size_t i) {
  constexpr std::size_t farther = 16, nearer = 8;
  if (i + farther < vertices.size()) __builtin_prefetch(&s.stars[at(vertices[i + farther])]);
  if (i + nearer >= vertices.size()) return;
  const VertexStar& star = s.star(vertices[i + nearer]);
  if (star.long_ring >= 0) return;
  for (int k = 0; k < star.size; ++k) __builtin_prefetch(&s.stars[at(star.ring[at(k)])]);
}

/// Each call of compute_ring_note writes only the note of its own vertex, so the calls may run in
/// parallel.
void compute_ring_notes(const std::vector<int>& vertices, const mesh::Surface& s,
                        RingNotes& notes) {
  constexpr std::size_t per_chunk = 64;
  const std::size_t chunks = (vertices.size() + per_chunk - 1) / per_chunk;
  parallel_for(static_cast<int>(chunks), [&](int k) {
    const std::size_t first = at(k) * per_chunk, end = std::min(first + per_chunk, vertices.size());
    for (std::size_t i = first; i < end; ++i) {
      prefetch(s, vertices, i);
      notes.of[at(vertices[i])] = compute_ring_note(s, vertices[i], notes.limits);
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

std::uint16_t compute_ring_note(const mesh::Surface& s, int v, const RingLimits& limits) {
  constexpr unsigned known = ring_unchanged | ring_note_valid,
                     all_lean = 0xffU << first_leaning_bit;
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
    if ((notes.of[at(v)] & ring_note_valid) == 0 && rock.surface.is_alive(v)) unknown[found++] = v;
  unknown.resize(found);
  compute_ring_notes(unknown, rock.surface, notes);
}

namespace {

using mesh::VertexStar;

/// Bit i of the result: bit i or the next bit around the ring.
unsigned with_next(unsigned bits, std::size_t size) {
  return bits | bits >> 1U | bits << (size - 1U);
}

unsigned all_of(const VertexStar& star) { return (1U << star.size) - 1U; }

/// The vertex that faces the edge (a, b) from the other side of triangle (v, a, b); -1 if there is
/// none.
int facing_from_outside(const mesh::Surface& s, int a, int b) {
  const VertexStar& star = s.star(a);
  const int* ring = s.ring(star);
  for (int i = 0; i < star.size; ++i)
    if (ring[i] == b) return i > 0 ? ring[i - 1] : (star.open != 0 ? -1 : ring[star.size - 1]);
  return -1;
}

/// Whether a triangle at v lies back to back with the triangle across the edge that faces v. Tests
/// only edges with two untouched ends.
bool is_folded_outwards(const mesh::Surface& s, int v, const RingMarks& marks) {
  const VertexStar& star = s.star(v);
  unsigned edges = ~with_next(marks.touched, star.size) & all_of(star);
  for (; edges != 0; edges &= edges - 1U) {
    const auto i = static_cast<std::size_t>(std::countr_zero(edges));
    const int a = star.ring[i], b = star.ring[i + 1 < star.size ? i + 1 : 0];
    const int o = facing_from_outside(s, a, b);
    if (o >= 0 && are_folded(doubled_area({star.x, s.position(a), s.position(b)}),
                             doubled_area({s.position(o), s.position(b), s.position(a)})))
      return true;
  }
  return false;
}

}  // namespace

RingMarks marks_around(const Rock& rock, int v) {
  const VertexStar& star = rock.surface.star(v);
  RingMarks marks;
  for (unsigned i = 0; i < star.size; ++i) {
    const int w = star.ring[i];
    const unsigned touched = rock.touched[at(w)] != 0 ? 1U : 0U;
    marks.touched |= touched << i;
    marks.before |= (w < v ? touched : 0U) << i;
  }
  return marks;
}

long triangles_first_at(const Rock& rock, int v) {
  const VertexStar& star = rock.surface.star(v);
  const int* ring = rock.surface.ring(star);
  const auto goes_before = [&](int w) { return rock.touched[at(w)] != 0 && w < v; };
  long count = 0;
  bool before = goes_before(ring[star.open != 0 ? 0 : star.size - 1]);
  for (int i = star.open != 0 ? 1 : 0; i < star.size; ++i) {
    const bool now = goes_before(ring[i]);
    count += before || now ? 0 : 1;
    before = now;
  }
  return count;
}

long triangles_first_at(const VertexStar& star, const RingMarks& marks) {
  return std::popcount(~with_next(marks.before, star.size) & all_of(star));
}

bool ring_is_fine(Rock& rock, int v, const RingMarks& marks) {
  return (note_at(rock.surface, v, rock.notes) & ring_fine) != 0 &&
         !is_folded_outwards(rock.surface, v, marks);
}

}  // namespace tdbd::rock
