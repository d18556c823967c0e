#pragma once

#include <vector>

#include "reference/simulation/round_cutters.hpp"

/// The rock under a bit that rotates about a fixed axis, without a mesh and without a height field.
/// The rock in the half-plane of a point of a cutter is what earlier cutters left there, each at
/// the height of the bit when it passed. So only the height of the bit as a function of its angle
/// is stored.
namespace tdbd::reference {

/// The bit's height as a function of its rotation, stored for slightly more than a revolution.
/// Before the start it is 0: the bottom fits the bit, as all cutters at the height 0 would leave
/// it.
class HeightHistory {
 public:
  explicit HeightHistory(int bins_per_turn);

  /// Appends the present position of the bit. Angles that were passed before are not overwritten.
  void pass(double turned, double height);

  /// Linear interpolation between entries, and to (now_turned, now_height) after the last one.
  double at(double turned, double now_turned, double now_height) const;

 private:
  double width_;
  std::vector<double> heights_{0.0};  ///< at multiples of the width
  double last_turned_ = 0.0, last_height_ = 0.0;
};

/// What one cutter left of a column of another one: the column's point `up` (at the marks of
/// Columns) is rock only if the bit has moved down by more than `needed` (m) since.
struct Left {
  double lag = 0.0;                   ///< rad that the bit has rotated since, in (0, 2 pi]
  double least = 0.0, largest = 0.0;  ///< m, the first and the last of `needed`
  std::vector<double> needed;         ///< m, ascending, one per mark
};

/// A column of a face: the points above the rim's point at the angle `at` from -Z.
struct Column {
  double at = 0.0;             ///< rad
  double y = 0.0;              ///< m, along Y of the face
  double chord = 0.0;          ///< m, from the rim to the rim on the other side
  Vec3 foot_B = Vec3::Zero();  ///< m, on the rim
  std::vector<Left> left;      ///< by all cutters that pass here, including the cutter itself
};

/// The cutters of a bit, in columns.
struct Columns {
  std::vector<RoundCutter> cutters;
  std::vector<std::vector<Column>> columns;  ///< [cutter]; empty: it cuts without force
  std::vector<double> marks;                 ///< m up the face
};

/// Makes `per_cutter` columns plus one on the lower half of each rim, at equal angles, with marks
/// `spacing` (m) apart up to `highest`.
Columns make_columns(std::vector<RoundCutter> cutters, int per_cutter, double spacing,
                     double highest);

/// The uncut rock in a column.
struct RockInColumn {
  double up = 0.0;    ///< m up the face; 0 if no rock is left
  double deep = 0.0;  ///< m, depth of the foot below the rock's surface; negative: above it
};

RockInColumn rock_in_column(const Column& column, const std::vector<double>& marks,
                            const HeightHistory& history, double turned, double height);

}  // namespace tdbd::reference
