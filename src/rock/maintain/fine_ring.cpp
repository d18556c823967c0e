#include "rock/maintain/fine_ring.hpp"

#include <bit>

#include "rock/maintain/ring_notes.hpp"
#include "rock/maintain/star.hpp"
#include "rock/maintain/touched_region.hpp"

namespace tdbd::rock {
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
