#pragma once

#include <array>
#include <optional>
#include <vector>

#include "rock/cut/cutting_bit.hpp"
#include "rock/section/column_sums.hpp"
#include "rock/section/face_columns.hpp"

namespace tdbd::rock {

/// How rock breaks out around a face, rock (20), (21) [+] (thesis 4.1 does not treat spalling).
/// Beside the face, cracks rise from its engaged edge to the free surface. Ahead of it, the upper
/// share of the rock that it would cut chips off before the face arrives.
struct BreakoutRule {
  double angle = 0.0;        ///< rad, between cracks and the profile's normal, in (0, pi/2)
  double depth_share = 1.0;  ///< in [0, 1]: cracks start in this share of the depth, from the top
  double ahead_share = 0.0;  ///< in [0, 1): share of the depth, from the top, that chips off ahead
};

enum class BreakoutPlace { left, right, ahead };

/// A body that removes the rock that breaks out around a face. Its shape is fixed; its place
/// depends on the depth of cut. Beside a face: a prism along the path whose cross-section is the
/// wedge above the crack, with its corner at the start of the crack. It ends where the crack
/// reaches the height of the free surface at the end of the engaged edge. Ahead: the outline of the
/// face, extended along the path and raised.
struct Breakout {
  int cutter = -1;
  BreakoutPlace place = BreakoutPlace::left;
  std::size_t group = 0;          ///< index into CuttingBit::groups
  Pose X_BF;                      ///< of the face's outline
  ConvexPolygon left_F, right_F;  ///< lower_edge of the outline
  double slope = 0.0;             ///< of the crack in the plane of the face: dy / dz outwards
  double share = 1.0;             ///< BreakoutRule::depth_share or ahead_share
  double diameter = 0.0;          ///< m, of the cutter
};

/// Slope dy / dz of a crack in the plane of a face (frame F). Seen along the motion `along_B`
/// (unit), the crack has this angle (rad) with the normal (unit). If the slope is not positive, the
/// face is too oblique for a crack.
double crack_slope(const Pose& X_BF, FaceSide side, const Vec3& along_B, const Vec3& normal_B,
                   double angle);

/// The faces of a bit, indexed by cutter.
struct BreakoutFaces {
  const std::vector<std::optional<BreakoutRule>>& rules;  ///< empty: no break-out
  const std::vector<FaceOutline>& outlines;
  double ahead = 0.0;  ///< m, length of chips ahead; beyond the place of sections
};

/// Removes the groups that an earlier call added to `cutting` and adds a group for each body that
/// breaks out. Its removed volume is credited to the face, and also to
/// CutReport::broken_out_by_part.
std::vector<Breakout> add_breakouts(const bit::Bit& bit, const BreakoutFaces& faces,
                                    const CuttingOptions& options, CuttingBit& cutting);

/// The corners (F, m) of an outline's lower edge on one side, from its lowest to its widest point.
ConvexPolygon lower_edge(const ConvexPolygon& rim_F, FaceSide side);

/// Returns the start of the crack (y, z in F, m), rock (20): the point of the lower edge in rock,
/// at most depth_share of the depth below `end_z`, from which the crack reaches farthest outwards.
/// Returns nothing if that is the end itself, so that no rock breaks out. `end_z`: height (F, m) of
/// the highest engaged point on this side.
std::optional<Vec2> crack_start(const Breakout& breakout, double end_z);

/// Returns how far (m, along z of F) the outline is raised ahead of the face, rock (21); nothing
/// without ends.
std::optional<double> raised_ahead(const Breakout& breakout, const EngagedEnds& ends);

/// Places a body according to the ends of its face's engaged edge. Without ends it removes no rock.
void place_breakout(const Breakout& breakout, const EngagedEnds& ends, CuttingBit& cutting);

}  // namespace tdbd::rock
