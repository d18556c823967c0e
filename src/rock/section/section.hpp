#pragma once

#include "rock/rock.hpp"
#include "rock/section/crossing_segments.hpp"
#include "rock/section/face_strips.hpp"
#include "rock/section/flat_behind.hpp"

namespace tdbd::rock {

/// Whether a section is taken to be the same at the face as ahead of it, exact where the bit moves as
/// the cutters before did, or follows from two sections by a straight line, whose error is of second
/// order in the lead for any motion.
enum class SectionAtFace { as_ahead, extrapolated };

/// Where the rock ahead of a face is measured. At its own place the face is half-way through the
/// triangles; beyond their longest edge they are as the cutters before it left them.
struct SectionPlace {
  double lead = 0.0;   ///< m > 0, least distance ahead; more than the rock's longest edge; reduced
                       ///< where a face plunges
  double reach = 0.0;  ///< m, how far around the face to search for rock; about an edge length
  int near_list = -1;  ///< index of the rock's list that may cover the place; -1: none
  double largest_turn = 0.5;  ///< rad: near the bit's axis never farther ahead than this
  SectionAtFace at_face = SectionAtFace::as_ahead;
};

/// What was found of the rock's outline in the plane of a face. none: nothing, so the face is in
/// the open, or deep in rock. over_the_top: the outline leaves through the top; the rock above it
/// is unknown, and so are the numbers of the section.
enum class Sight { clear, none, over_the_top };

/// The part of a face's outline that lies in uncut rock.
struct Section {
  double area = 0.0;  ///< m2, in the plane of the face
  Vec3 centroid_B = Vec3::Zero();
  double engaged_edge = 0.0;     ///< m, length of the outline in rock (De)
  double angle_of_attack = 0.0;  ///< rad, between face and path, mean along the engaged edge
  double volume_rate = 0.0;      ///< m3/s, swept by this area: integral of X . v dA
  Sight sight = Sight::clear;
  Vec3 edge_centroid_B = Vec3::Zero();  ///< m, of the engaged edge
  double flat_area = 0.0;  ///< m2, of the cutter's wear flat behind its engaged edge (FlatBehind)
  Vec3 flat_centroid_B = Vec3::Zero();  ///< m, of that
};

/// A face, prepared once for its sections.
struct SectionFace {
  FaceOutline outline;
  FaceColumns columns;
  FlatBehind flat;  ///< no columns: none, or not measured
};

SectionFace section_face(FaceOutline outline);

/// Buffers of a section, kept between calls so that none allocates once warm.
struct SectionWork {
  OutlineWork outline;
  std::vector<FaceStrip> strips;
  ConvexPolygon forward_F;  ///< the part of the outline that does not go backwards, if not all
  FaceColumns forward;      ///< the same in columns
  ColumnSums sums;
  Sight sight = Sight::none;  ///< of the strips so far
  /// The columns of `sums`, of the face or of this work; null: nothing was measured.
  const FaceColumns* measured = nullptr;
};

/// The section of uncut rock by a face, rock (12) and rock (13) (ours, beyond the thesis). The face
/// is carried ahead rigidly along the screw motion of the bit, and its plane cuts the triangles
/// there, so nothing is approximated but the rock's own mesh. Carried by a time s the face's point
/// x is X . v(x) s ahead, where X . v is affine on the face. Where it varies much, near the bit's
/// axis, the face is carried in strips (face_strips). The part of the face that does not go
/// forwards (X . v <= 0) is left out.
///
/// In the plane, with segments a b of the rock's outline that have rock on their left, the area is
///   sum of sign(y_a - y_b) |F beside the segment: y between y_a and y_b, on its -Z side|
/// over the convex outline F, and likewise for first moments and lengths of its edge: signed
/// trapezoids, which do not depend on which segments are neighbours. Rock whose surface is wholly
/// above (+Z) the outline is therefore not counted; Section::sight reports that. Cost is
/// proportional to the triangles around the face. Pure: the same surface gives the same bits,
/// whatever its numbering and its index. X_WB: the bit now; twist: its motion relative to the rock.
///
/// SectionAtFace::extrapolated: a second section A2 is measured after twice the time, and 2 A - A2
/// is returned, at least 0; likewise for edge, centroids, angle and volume. While the advance per
/// turn changes, as at the start of a run or in stick-slip, A alone is too large by the depth that
/// the bit gains on its way to where it is measured. Where the second plane sees no rock, A alone.
Section section(const Rock& rock, const SectionFace& face, const Pose& X_WB,
                const rotation::Twist& twist, const SectionPlace& place, SectionWork& work);

}  // namespace tdbd::rock
