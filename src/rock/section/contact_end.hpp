#pragma once

#include <array>

#include "rock/section/pressing_part.hpp"

namespace tdbd::rock {

/// A vertex that the part presses.
struct PressedPlace {
  Vec3 x_P;  ///< m
  Vec3 d_P;  ///< m, its displacement by the part; 0: the part only touches it
};

/// The end of a contact on an edge of the rock.
struct ContactEnd {
  Vec3 x_P = Vec3::Zero();     ///< m
  int side = -1;               ///< plane parallel to d that bounds the contact here, or -1
  Vec3 foot_P = Vec3::Zero();  ///< m, lower edge of a side that pressed; otherwise x_P
};

/// Returns where the contact ends on the edge from a vertex that the part presses to one that it
/// does not press, on undisturbed rock: rock (14).
///   U = x - d, the undisturbed place of the pressed vertex;  point(t, s) = U + t (q - U) + s d/|d|
/// The contact ends on the undisturbed surface (s = 0), where that leaves the part. If it leaves
/// through a side that did not press and does not face d, the contact ends at the lower edge of
/// that side: at the largest t for which some s >= 0 is inside. Exact for a part that is one convex
/// solid of planes; contacts of other parts always end on the undisturbed surface. q_P: the
/// undisturbed place of the other vertex, m.
ContactEnd end_on_undisturbed_rock(const PressingPart& part, const PressedPlace& from,
                                   const Vec3& q_P);

/// Returns the end for an edge from a vertex on the lee side that the part pressed before and whose
/// undisturbed place is inside the part. It occurs where a side that presses joins the lee side.
ContactEnd end_beside_lee_side(const PressingPart& part, const PressedPlace& from, const Vec3& q_P);

/// Returns where the contact ends on the edge from a vertex that the part presses to one on the lee
/// side. The end is on the part's surface, below the first point of the edge at which the surface
/// below it, seen along d, moved away or does not exist. If the undisturbed rock leaves the part
/// before that point, the contact ends there: the part may have left the other vertex below it
/// before its surface turned away.
ContactEnd end_at_lee_side(const PressingPart& part, const PressedPlace& from, const Vec3& q_P,
                           const Vec3& undisturbed_q_P);

/// Between two ends on different sides of a part, the contact ends at the edge between these sides.
/// Computes its points at the levels of both ends (m), the first at that of `a`. Returns false if
/// there is no such edge between them.
bool edge_between(const PressingPart& part, const ContactEnd& a, const ContactEnd& b,
                  const Vec3& d_P, std::array<Vec3, 2>& points_P);

}  // namespace tdbd::rock
