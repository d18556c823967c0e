#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rock/section/face_columns.hpp"

namespace tdbd::rock {

/// A segment of the rock's outline in the plane of a face, with rock on its left. Frame F, m.
struct OutlineSegment {
  Vec2 from, to;
};

/// Sums over segments as integer multiples of a small unit, so that they do not depend on the
/// order. One unit is 2^-50 of the outline's box (its area, area times size, size, size squared),
/// which is finer than the rounding of a double. The range is 4096 boxes.
struct ColumnSums {
  std::int64_t area = 0, moment_y = 0, moment_z = 0;
  std::vector<std::int64_t> engaged;  ///< lower, then upper edges of all columns; left, right end
  /// First moments of length of the same edges about the start of each edge: y - y0 along a column,
  /// the height above the lower corner along an end.
  std::vector<std::int64_t> engaged_moment;
  double per_area = 0.0, per_moment = 0.0, per_length = 0.0;  ///< units per m2, m3, m
  double per_length_moment = 0.0;                             ///< units per m2
};

/// Resets the sums and sets their units.
void begin_sums(const FaceColumns& face, ColumnSums& sums);

/// Adds the part of columns [first, end) beside the segment, on its -Z side, with the sign of
/// y_from - y_to: its area, its first moments, and the lengths of the outline's edge in it.
void add_segment(const FaceColumns& face, std::size_t first, std::size_t end,
                 const OutlineSegment& s, ColumnSums& sums);

/// Adds the same for a chain of segments between consecutive points, all inside the columns and
/// away from their edges. For each segment it adds the region between the segment and the box's
/// bottom. The part of that below the lower edge is subtracted at the two ends of the chain. It is
/// rounded separately for each end, so the ends of neighbouring chains cancel exactly, and the sums
/// do not depend on where chains begin. `y`, `z`: coordinates of at least two points in F, m.
void add_inside(const FaceColumns& face, std::span<const double> y, std::span<const double> z,
                ColumnSums& sums);

/// The sides of a face, seen from the rock ahead. Left is towards -Y of frame F.
enum class FaceSide { left, right };

/// Heights (z in F, m), by FaceSide, of the highest points of the outline's lower edge that are in
/// rock. Empty if no point on that side is in rock. If the engaged edge has gaps, its highest piece
/// counts.
using EngagedEnds = std::array<std::optional<double>, 2>;

/// Computes the ends from the sums over a face's columns. Each piece of the edge is assumed to be
/// engaged without a gap. Rock above the outline's widest point does not count.
EngagedEnds engaged_ends(const FaceColumns& face, const ColumnSums& sums);

}  // namespace tdbd::rock
