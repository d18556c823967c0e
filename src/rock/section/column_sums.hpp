#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "rock/section/face_columns.hpp"

namespace tdbd::rock {

/// A piece of the rock's outline in the plane of a face, rock on its left. Frame F, m.
struct OutlineSegment {
  Vec2 from, to;
};

/// Sums over segments in whole multiples of a small unit: integers add up to the same in any order.
/// One unit is 2^-50 of the outline's box (its area, area times size, size, size squared), finer
/// than a double's rounding; the range is 4096 boxes.
struct ColumnSums {
  std::int64_t area = 0, moment_y = 0, moment_z = 0;
  std::vector<std::int64_t> engaged;  ///< lower edges, upper edges of all columns; left, right end
  /// The same edges' first moments of length about the start of each: y - y0 along a column, the
  /// height above the lower corner along an end.
  std::vector<std::int64_t> engaged_moment;
  double per_area = 0.0, per_moment = 0.0, per_length = 0.0;  ///< units per m2, m3, m
  double per_length_moment = 0.0;                             ///< units per m2
};

/// Resets the sums and sets their units.
void begin_sums(const FaceColumns& face, ColumnSums& sums);

/// Adds the part of columns [first, end) that lies beside the segment, on its -Z side, with the
/// sign of y_from - y_to: its area, first moments, and the lengths of the outline's edge in it.
void add_segment(const FaceColumns& face, std::size_t first, std::size_t end,
                 const OutlineSegment& s, ColumnSums& sums);

/// The same for a chain of segments between neighbouring points, all of which are inside the columns, away
/// from their edges: what lies below each segment and above the box's bottom. What of that is below the
/// lower edge is subtracted at the ends of the chain: it is rounded for each end alone, so that the ends
/// of neighbouring chains cancel exactly, and the sums do not depend on where chains begin. `y`, `z`: m,
/// of the points, in F; two or more.
void add_inside(const FaceColumns& face, std::span<const double> y, std::span<const double> z,
                ColumnSums& sums);

}  // namespace tdbd::rock
