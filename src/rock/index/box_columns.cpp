#include "rock/index/box_columns.hpp"

#include <algorithm>
#include <cmath>

namespace tdbd::rock {
namespace {

constexpr Single far = 1e30F;  // m

Single rounded(double x) {
  constexpr double most = 1e30;
  return static_cast<Single>(std::clamp(x, -most, most));
}

/// Ten times the rounding of both sides of a comparison.
double outwards(double x) { return 1e-6 * std::abs(x); }

TDBD_WIDE std::uint64_t overlap_of_some(const BoxColumns& columns, std::size_t first,
                                        std::size_t end, const std::array<Single, 6>& b) {
  std::uint64_t bits = 0;
  for (std::size_t i = first; i < end; i += single_lanes) {
    std::array<WideSingle, 6> side;
    for (std::size_t k = 0; k < side.size(); ++k) TDBD_LOAD(side[k], &columns.side[k][i]);
    const WideFlags in = (side[0] <= b[3]) & (side[1] <= b[4]) & (side[2] <= b[5]) &
                         (side[3] >= b[0]) & (side[4] >= b[1]) & (side[5] >= b[2]);
    if (any_of(in)) bits |= static_cast<std::uint64_t>(bits_of(in)) << (i - first);
  }
  return bits;
}

}  // namespace

void resize(BoxColumns& columns, std::size_t boxes) {
  const std::size_t padded = (boxes + single_lanes - 1) / single_lanes * single_lanes;
  for (std::size_t k = 0; k < columns.side.size(); ++k)
    columns.side[k].assign(padded, k < 3 ? far : -far);
  columns.boxes = boxes;
}

void set_box(BoxColumns& columns, std::size_t i, const mesh::Box& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double lo = box.lo[static_cast<Eigen::Index>(k)],
                 hi = box.hi[static_cast<Eigen::Index>(k)];
    columns.side[k][i] = rounded(lo - outwards(lo));
    columns.side[k + 3][i] = rounded(hi + outwards(hi));
  }
}

std::uint64_t may_overlap(const BoxColumns& columns, std::size_t first, const mesh::Box& b) {
  const std::size_t end = std::min(columns.boxes, first + 64);
  return overlap_of_some(columns, first, end,
                         {rounded(b.lo.x()), rounded(b.lo.y()), rounded(b.lo.z()),
                          rounded(b.hi.x()), rounded(b.hi.y()), rounded(b.hi.z())});
}

}  // namespace tdbd::rock
