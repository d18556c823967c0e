#pragma once

#include <vector>

#include "reference/simulation/round_cutters.hpp"

/// The rock under a bit that turns about a fixed axis, without a mesh and without a height field: in
/// the half-plane of a point of a cutter stands what earlier cutters left there, each at the height at
/// which the bit was when it passed. Only the bit's height over its angle has to be kept.
namespace tdbd::reference {

/// The bit's height over what it has turned, kept for a revolution and more. Before the start it is
/// 0: the bottom fits the bit, as all cutters at the height 0 would leave it.
class HeightHistory {
 public:
  explicit HeightHistory(int bins_per_turn);

  /// Appends where the bit is now; angles that were passed before are not written again.
  void pass(double turned, double height);

  /// Linear between entries, and to (turned, height) after the last.
  double at(double turned, double now_turned, double now_height) const;

 private:
  double width_;
  std::vector<double> heights_{0.0};  ///< at multiples of the width
  double last_turned_ = 0.0, last_height_ = 0.0;
};

/// What one cutter left of a column of another: the column's point `up` (at the marks of Columns) is
/// rock only if the bit has come down by more than `needed` (m) since.
struct Left {
  double lag = 0.0;            ///< rad that the bit has turned since, in (0, 2 pi]
  std::vector<double> needed;  ///< m, ascending, one per mark
};

/// A column of a face: points above the rim's point at the angle `at` from -Z.
struct Column {
  double at = 0.0;             ///< rad
  double y = 0.0;              ///< m, along Y of the face
  double chord = 0.0;          ///< m, from the rim to the rim again
  Vec3 foot_B = Vec3::Zero();  ///< m, on the rim
  std::vector<Left> left;      ///< of all cutters that pass here, the cutter itself included
};

/// A bit's cutters in columns.
struct Columns {
  std::vector<RoundCutter> cutters;
  std::vector<std::vector<Column>> columns;  ///< [cutter]; none: it cuts without force
  std::vector<double> marks;                 ///< m up the face
};

/// `per_cutter` columns and one on the lower half of each rim, at equal angles; marks `spacing` (m)
/// apart up to `highest`.
Columns make_columns(std::vector<RoundCutter> cutters, int per_cutter, double spacing,
                     double highest);

/// The uncut rock in a column.
struct RockInColumn {
  double up = 0.0;    ///< m up the face, 0 where all is gone
  double deep = 0.0;  ///< m that the foot is below the rock's surface; negative: above it
};

RockInColumn rock_in_column(const Column& column, const std::vector<double>& marks,
                            const HeightHistory& history, double turned, double height);

}  // namespace tdbd::reference
