#pragma once

#include <array>
#include <optional>
#include <vector>

#include "rock/cut/cutting_bit.hpp"
#include "rock/section/engaged_ends.hpp"
#include "rock/section/face_outline.hpp"

namespace tdbd::rock {

/// How rock breaks out around a face, rock (20), (21) (ours; thesis 4.1 leaves spalling out).
/// Beside the face cracks rise from its engaged edge to the free surface; ahead of it the upper
/// share of what it would cut chips off before it comes.
struct BreakoutRule {
  double angle = 0.0;        ///< rad, of cracks from the profile's normal, in (0, pi/2)
  double depth_share = 1.0;  ///< in [0, 1]: cracks start in this share of the depth, from the top
  double ahead_share = 0.0;  ///< in [0, 1): of the depth, from the top, that chips off ahead
};

enum class BreakoutPlace { left, right, ahead };

/// A body that the rock around a face leaves. It has one shape; where it is follows the depth of
/// cut. Beside a face: a prism along the path whose cross-section is the wedge above the
/// crack, its corner at the start of the crack; it ends where the crack comes to the height of the
/// free surface at the end of the engaged edge. Ahead: the outline of the face extended
/// along the path, raised.
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

/// dy / dz of a crack in the plane of a face (frame F) that, seen along the motion `along_B` (unit),
/// has this angle (rad) with the normal (unit). Not positive: the face is too oblique for it.
double crack_slope(const Pose& X_BF, FaceSide side, const Vec3& along_B, const Vec3& normal_B,
                   double angle);

/// The faces of a bit, per cutter.
struct BreakoutFaces {
  const std::vector<std::optional<BreakoutRule>>& rules;  ///< none: no break-out
  const std::vector<FaceOutline>& outlines;
  double ahead = 0.0;  ///< m, how far chips reach ahead; farther than sections are measured
};

/// Adds a group for each body that breaks out to the groups of `cutting`, and removes those that an
/// earlier call added.
/// The volume that they take counts as removed by the face, and in CutReport::broken_out_by_part.
std::vector<Breakout> add_breakouts(const bit::Bit& bit, const BreakoutFaces& faces,
                                    const CuttingOptions& options, CuttingBit& cutting);

/// The corners (F, m) of an outline's lower edge on one side, from its lowest point to its widest.
ConvexPolygon lower_edge(const ConvexPolygon& rim_F, FaceSide side);

/// Where the crack starts (y, z in F, m): the point of the lower edge in rock, at most depth_share
/// of the depth below `end_z`, from where the crack reaches farthest outwards, rock (20). None where
/// that is the end itself: nothing breaks out. `end_z`: height (F, m) of the highest engaged point of this
/// side.
std::optional<Vec2> crack_start(const Breakout& breakout, double end_z);

/// How far (m, along z of F) the outline is raised ahead of the face, rock (21). None without ends.
std::optional<double> raised_ahead(const Breakout& breakout, const EngagedEnds& ends);

/// Puts a body where these ends of its face's engaged edge have it; `ends` none: it takes no rock.
void place_breakout(const Breakout& breakout, const EngagedEnds& ends, CuttingBit& cutting);

}  // namespace tdbd::rock
