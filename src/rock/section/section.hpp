#pragma once

#include "rock/rock.hpp"
#include "rock/section/crossing_segments.hpp"
#include "rock/section/face_strips.hpp"

namespace tdbd::rock {

/// Where the rock ahead of a face is measured. The face is half-way through the triangles at its
/// own place; an edge length farther on they are as the cutters before it left them.
struct SectionPlace {
  double lead = 0.0;   ///< m > 0, at least so far ahead; about 1.2 edge lengths
  double reach = 0.0;  ///< m, how far around the face rock is looked for; about an edge length
  int near_list = -1;  ///< of the rock's lists, that which may cover the place; -1: none
  double largest_turn = 0.5;  ///< rad: beside the bit's axis never farther ahead than this
};

/// What was seen of the rock's outline in the plane of a face. none: nothing, so that the face is
/// in the open, or deep in rock. over_the_top: the outline leaves through the top, and what rock is
/// above is not known; then the numbers of the section are not.
enum class Sight { clear, none, over_the_top };

/// What of a face's outline lies in uncut rock.
struct Section {
  double area = 0.0;  ///< m2, in the plane of the face
  Vec3 centroid_B = Vec3::Zero();
  double engaged_edge = 0.0;     ///< m, length of the outline in rock (De)
  double angle_of_attack = 0.0;  ///< rad, between face and path, mean along the engaged edge
  double volume_rate = 0.0;      ///< m3/s, swept by this area: integral of X . v dA
  Sight sight = Sight::clear;
  Vec3 edge_centroid_B = Vec3::Zero();  ///< m, of the engaged edge
};

/// A face, prepared once for its sections.
struct SectionFace {
  FaceOutline outline;
  FaceColumns columns;
};

SectionFace section_face(FaceOutline outline);

/// Room for a section, kept between them so that none allocates once warm.
struct SectionWork {
  OutlineWork outline;
  std::vector<FaceStrip> strips;
  ConvexPolygon forward_F;  ///< what of the outline does not go backwards, if not all
  FaceColumns forward;      ///< the same in columns
  ColumnSums sums;
  Sight sight = Sight::none;  ///< of the strips so far
};

/// The section of uncut rock by a face, formulation 2.6 (ours, beyond the thesis). The face is
/// carried ahead along the screw motion of the bit, rigidly, and the triangles there are cut by its
/// plane, so that nothing is approximated but the rock's own mesh. Carried by a time s the face's
/// point x is X . v(x) s ahead, X . v being affine on the face: where it differs much, near the
/// bit's axis, the face is carried in strips (face_strips). What of the face does not go forwards
/// (X . v <= 0) takes no part.
///
/// In the plane, with segments a b of the rock's outline that have rock on their left, the area is
///   sum of sign(y_a - y_b) |F beside the segment: y between y_a and y_b, on its -Z side|
/// over the convex outline F, and the same for first moments and lengths of its edge: signed
/// trapezoids, which need not know which segments are neighbours. So rock whose surface is wholly
/// above
/// (+Z) the outline does not count; Section::sight tells. The surface is not changed; cost follows
/// the triangles around the face. Pure: the same surface gives the same bits, whatever its
/// numbering and its index. X_WB: the bit now; twist: its motion over the rock.
Section section(const Rock& rock, const SectionFace& face, const Pose& X_WB,
                const rotation::Twist& twist, const SectionPlace& place, SectionWork& work);

}  // namespace tdbd::rock
