#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "rock/section/face_columns.hpp"

namespace tdbd::rock {

/// Where a segment is known to lie: within the columns at work, away from their edges; beneath all
/// lower edges, so that it adds nothing; or anywhere.
enum class SegmentPlace : std::uint8_t { anywhere, inside, beneath };

/// A piece of the rock's outline in the plane of a face, rock on its left. Frame F, m.
struct OutlineSegment {
  Vec2 from, to;
  SegmentPlace place = SegmentPlace::anywhere;
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

/// Neighbouring segments inside the columns, joined.
struct InsideRun {
  bool is_open = false;
  Vec2 begin = Vec2::Zero(), end = Vec2::Zero();
};

/// Resets the sums and sets their units.
void begin_sums(const FaceColumns& face, ColumnSums& sums);

/// Adds the part of columns [first, end) that lies beside the segment, on its -Z side, with the
/// sign of y_from - y_to: its area, first moments, and the lengths of the outline's edge in it.
void add_segment(const FaceColumns& face, std::size_t first, std::size_t end,
                 const OutlineSegment& s, ColumnSums& sums);

/// The same for a segment that is inside: what lies below it and above the box's bottom. What of
/// that is below the lower edge is subtracted at the ends of a run: it is rounded for each end
/// alone, so that the ends of neighbours cancel exactly, and the sums do not depend on where runs
/// begin.
void add_inside(const FaceColumns& face, const OutlineSegment& s, InsideRun& run, ColumnSums& sums);

/// Ends a run, if there is one; to be called after the last segment.
void end_run(const FaceColumns& face, InsideRun& run, ColumnSums& sums);

}  // namespace tdbd::rock
