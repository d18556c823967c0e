#pragma once

#include <array>

#include "rock/section/pressing_part.hpp"

namespace tdbd::rock {

/// A vertex that the part presses.
struct PressedPlace {
  Vec3 x_P;  ///< m
  Vec3 d_P;  ///< m, by which the part has pressed it; 0: it only touches
};

/// Where a contact ends on an edge of the rock.
struct ContactEnd {
  Vec3 x_P = Vec3::Zero();  ///< m
  int side = -1;            ///< plane of the part parallel to d that bounds the contact here, or -1
  Vec3 foot_P = Vec3::Zero();  ///< m, the lower edge of a side that pressed, below x_P; else x_P
};

/// Where the contact ends on the way from a vertex that the part presses to one that it does not,
/// on undisturbed rock: rock (14).
///   U = x - d, the undisturbed place of the pressed vertex;  point(t, s) = U + t (q - U) + s d/|d|
/// The contact ends on the undisturbed surface (s = 0), where that leaves the part; but where it
/// leaves through a side that did not press and does not face d, at the lower edge of that side: the
/// largest t for which some s >= 0 is inside. Exact for a part of one convex solid of planes; other
/// parts always end on the undisturbed surface. q_P: the undisturbed place of the other vertex, m.
ContactEnd end_on_undisturbed_rock(const PressingPart& part, const PressedPlace& from,
                                   const Vec3& q_P);

/// The same as end_on_undisturbed_rock from a vertex on the lee side that the part pressed before,
/// whose undisturbed place is inside the part: where a side that presses joins the lee side.
ContactEnd end_beside_lee_side(const PressingPart& part, const PressedPlace& from, const Vec3& q_P);

/// Where the contact ends on the way from a vertex that the part presses to one on the lee side:
/// on the part's surface, below the first point of the straight way whose surface below, seen along
/// d, moved away or is none; or on undisturbed rock, where that leaves the part before: the part may
/// have left the other vertex below it before its surface there turned away.
ContactEnd end_at_lee_side(const PressingPart& part, const PressedPlace& from, const Vec3& q_P,
                           const Vec3& undisturbed_q_P);

/// Between two ends on different sides of a part the contact ends at the edge of the two sides: the
/// points on it at the levels of both ends (m), a at that of `a`. False if there is no such edge
/// between them.
bool edge_between(const PressingPart& part, const ContactEnd& a, const ContactEnd& b,
                  const Vec3& d_P, std::array<Vec3, 2>& points_P);

}  // namespace tdbd::rock
