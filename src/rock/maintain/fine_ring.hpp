#pragma once

#include "rock/rock.hpp"

namespace tdbd::rock {

/// Bit masks of the neighbours of a vertex that are touched, and of those that are touched and have
/// a smaller number.
struct RingMarks {
  unsigned touched = 0, before = 0;
};

/// For a closed ring of at most eight neighbours (has_spokes).
RingMarks marks_around(const Rock& rock, int v);

/// The number of triangles at v of whose touched corners v has the smallest number. The sum over
/// all touched vertices counts every touched triangle once. The second overload is faster.
long triangles_first_at(const Rock& rock, int v);
long triangles_first_at(const mesh::VertexStar& star, const RingMarks& marks);

/// Whether no triangle at v needs an operation, is steep, or is folded on a neighbour, according to
/// the vertex's note (ring_notes.hpp). Requires begin_notes. Conservative: may return false for a
/// ring that needs no repair. Folds across an edge that faces v are tested only if neither of its
/// ends is touched; otherwise the rings of its ends contain them.
bool ring_is_fine(Rock& rock, int v, const RingMarks& marks);

}  // namespace tdbd::rock
