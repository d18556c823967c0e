#pragma once

#include "rock/rock.hpp"
#include "rock/section/crossing_segments.hpp"
#include "rock/section/face_columns.hpp"

namespace tdbd::rock {

/// How the section at the face is derived. `as_ahead`: it is taken to be that measured ahead of the
/// face, which is exact if the bit moves as it did when the previous cutters passed.
/// `extrapolated`: it is extrapolated linearly from two sections; the error is of second order in
/// the lead for any motion.
enum class SectionAtFace { as_ahead, extrapolated };

/// Where the rock ahead of a face is measured. At its own place the face is half-way through the
/// triangles. Farther away than their longest edge, the triangles are as the cutters before it left
/// them.
struct SectionPlace {
  double lead = 0.0;   ///< m, > 0, smallest distance ahead. Must exceed the rock's longest edge.
                       ///< Reduced where a face plunges.
  double reach = 0.0;  ///< m, distance around the face to search for rock; about an edge length
  int near_list = -1;  ///< index of the rock's list that may cover the place; -1: none
  double largest_turn = 0.5;  ///< rad, limits the distance ahead near the bit's axis
  SectionAtFace at_face = SectionAtFace::as_ahead;
};

/// What was found of the rock's outline in the plane of a face. `none`: no outline, so the face is
/// either outside the rock or deep in it. `over_the_top`: the outline leaves through the top; the
/// rock above it is unknown, so the values of the section are not valid.
enum class OutlineStatus { clear, none, over_the_top };

/// The part of a face's outline that lies in uncut rock.
struct Section {
  double area = 0.0;  ///< m2, in the plane of the face
  Vec3 centroid_B = Vec3::Zero();
  double engaged_edge = 0.0;     ///< m, length of the outline in rock (De)
  double angle_of_attack = 0.0;  ///< rad, between face and path, mean along the engaged edge
  double volume_rate = 0.0;      ///< m3/s, swept by this area: integral of X . v dA
  OutlineStatus sight = OutlineStatus::clear;
  Vec3 edge_centroid_B = Vec3::Zero();  ///< m, of the engaged edge
  double flat_area = 0.0;  ///< m2, of the cutter's wear flat behind its engaged edge (FlatBehind)
  Vec3 flat_centroid_B = Vec3::Zero();  ///< m, of flat_area

  template <class Archive>
  void serialize(Archive& a) {
    a(area, centroid_B, engaged_edge, angle_of_attack, volume_rate, sight, edge_centroid_B,
      flat_area, flat_centroid_B);
  }
};

/// A face, prepared once for its sections.
struct SectionFace {
  FaceOutline outline;
  FaceColumns columns;
  FlatBehind flat;  ///< no columns: no flat, or not measured
};

SectionFace section_face(FaceOutline outline);

/// Buffers of a section, kept between calls to avoid allocations.
struct SectionWork {
  OutlineWork outline;
  std::vector<FaceStrip> strips;
  ConvexPolygon forward_F;  ///< the part of the outline that does not move backwards
  FaceColumns forward;      ///< forward_F in columns
  ColumnSums sums;
  OutlineStatus sight = OutlineStatus::none;  ///< of the strips so far
  /// The columns of `sums`, of the face or of this work; null if nothing was measured.
  const FaceColumns* measured = nullptr;
};

/// Computes the section of uncut rock by a face, rock (12) and rock (13) [+]. The face is carried
/// ahead rigidly along the screw motion of the bit, and its plane cuts the triangles there, so the
/// rock's own mesh is the only approximation. If the face is carried for a time s, its point x is X
/// . v(x) s ahead, where X . v is affine on the face. Where it varies strongly, near the bit's
/// axis, the face is carried in strips (face_strips). The part of the face that does not move
/// forwards (X . v <= 0) is omitted.
///
/// In the plane, with segments a b of the rock's outline that have rock on their left, the area is
///   sum of sign(y_a - y_b) |F beside the segment: y between y_a and y_b, on its -Z side|
/// over the convex outline F, and similarly for first moments and lengths of its edge. These signed
/// trapezoids do not depend on which segments are neighbours. Therefore rock whose surface is
/// wholly above (+Z) the outline is not counted; Section::sight reports that case. The run time is
/// proportional to the number of triangles around the face. The result is a function of the surface
/// alone: it is bitwise independent of numbering and index. X_WB: pose of the bit; twist: its
/// motion relative to the rock.
///
/// SectionAtFace::extrapolated: a second section A2 is measured after twice the time, and 2 A - A2,
/// but at least 0, is returned; similarly for edge, centroids, angle and volume. While the advance
/// per turn changes, as at the start of a run or in stick-slip, A alone is too large by the depth
/// that the bit gains on its way to the plane of measurement. If no rock is found in the second
/// plane, A alone is returned.
Section section(const Rock& rock, const SectionFace& face, const Pose& X_WB,
                const rotation::Twist& twist, const SectionPlace& place, SectionWork& work);

}  // namespace tdbd::rock
