#pragma once

#include "rock/rock.hpp"

namespace tdbd::rock {

/// Which neighbours of a vertex are touched, bit by bit, and which of them have a smaller number.
struct RingMarks {
  unsigned touched = 0, before = 0;
};

/// Of a closed ring of at most eight neighbours (has_spokes).
RingMarks marks_around(const Rock& rock, int v);

/// Triangles at v of whose touched corners v has the smallest number: over all touched vertices,
/// every touched triangle once. The second is quicker.
long triangles_first_at(const Rock& rock, int v);
long triangles_first_at(const mesh::VertexStar& star, const RingMarks& marks);

/// Whether no operation wants a triangle at v, nor is one steep or folded on a neighbour: by the
/// vertex's note (ring_notes.hpp), after begin_notes. Conservative: may be false for a ring that needs
/// no repair. Folds across an edge that faces v are tested only where neither of its ends is touched;
/// otherwise the rings of its ends contain them.
bool ring_is_fine(Rock& rock, int v, const RingMarks& marks);

}  // namespace tdbd::rock
