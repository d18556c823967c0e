#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/simd.hpp"
#include "mesh/measures.hpp"

namespace tdbd::rock {

/// Slightly enlarged boxes in single precision, stored as columns, so that eight at a time can be
/// tested for overlap with another box.
struct BoxColumns {
  std::array<std::vector<Single>, 6> side;  ///< m: lo x, y, z, hi x, y, z; padded with empty boxes
  std::size_t boxes = 0;
};

/// Resizes to this many boxes, all empty.
void resize(BoxColumns& columns, std::size_t boxes);

void set_box(BoxColumns& columns, std::size_t i, const mesh::Box& box);

/// Bit mask: bit l is set if box first + l of 64 may overlap b.
std::uint64_t may_overlap(const BoxColumns& columns, std::size_t first, const mesh::Box& b);

/// Calls visit(i), in ascending order, for each box i that overlaps b and for few others.
template <class Visit>
void visit_overlapping(const BoxColumns& columns, const mesh::Box& b, Visit&& visit) {
  for (std::size_t first = 0; first < columns.boxes; first += 64)
    for (std::uint64_t bits = may_overlap(columns, first, b); bits != 0; bits &= bits - 1)
      visit(first + static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace tdbd::rock
