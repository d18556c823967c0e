#pragma once

#include <array>

#include "mesh/shape/convex.hpp"
#include "rock/section/pressing_part.hpp"

namespace tdbd::rock {

/// A straight line U + t e, 0 <= t <= 1, above a convex solid of planes, and its shadow along the
/// direction u on the solid: the point U + t e + s u is inside plane i if a t + c s <= r. Without a
/// direction, u is zero, c is one and s is the distance from a plane, so that the lowest plane is
/// the nearest. All in the frame P, m. The end of a contact, rock (14), is computed from these
/// rows.
struct Shadow {
  using Column = std::array<double, mesh::most_planes>;

  const mesh::ConvexSolid& solid;
  Vec3 U, e, u;
  Column a, c, r;  ///< per plane of the solid and its padding, which bounds nothing

  /// x_P: a pressed vertex that the part only touches may be outside of planes by up to the gap.
  /// These planes are moved outwards to x_P.
  Shadow(const mesh::ConvexSolid& solid, const Vec3& U, const Vec3& e, const Vec3& u,
         const Vec3& x_P);
  /// Without a direction.
  Shadow(const mesh::ConvexSolid& solid, const Vec3& U, const Vec3& e, const Vec3& x_P);

  std::size_t planes() const { return solid.planes; }
  std::size_t columns() const { return solid.b.size(); }
  /// For a plane that is not parallel to u: s at which the line at t meets it, m.
  double height(std::size_t i, double t) const { return (r[i] - a[i] * t) / c[i]; }
  Vec3 point(double t, double s) const { return U + t * e + s * u; }
};

enum class Facing { parallel, up, down };  ///< relative to u: side, surface below, surface above

inline constexpr double least_cosine = 1e-9;  ///< smaller cosines with u count as parallel

/// Of a plane whose normal has this cosine with u.
inline Facing facing(double cosine) {
  if (cosine > least_cosine) return Facing::up;
  return cosine < -least_cosine ? Facing::down : Facing::parallel;
}

inline Facing facing(const Shadow& w, std::size_t i) { return facing(w.c[i]); }

/// Where a line leaves the solid, and through which plane. t = 1: it does not leave.
struct Exit {
  double t = 1.0;
  std::size_t plane = 0;
};

/// The exit of the line itself, s = 0, without computing rows. x_P: as for Shadow.
Exit exit_of_line(const mesh::ConvexSolid& solid, const Vec3& U, const Vec3& e, const Vec3& x_P);

/// How far the solid reaches along u at t, m; at least 0.
double reach_at(const Shadow& w, double t);

/// The end of the shadow: the point with the largest t, up to the planes parallel to u, at which
/// the line is inside for some s >= 0.
Vec3 end_of_shadow(const Shadow& w);

/// An interval of the surface below the line, seen along u, that lies on one plane.
struct Stretch {
  std::size_t plane = 0;
  double from = 0.0, to = 0.0;           ///< t
  std::size_t next = mesh::most_planes;  ///< the plane that follows; most_planes: none, or t is 1
};

Stretch first_stretch(const Shadow& w);

/// The stretch on this plane that begins at t.
Stretch stretch_from(const Shadow& w, std::size_t plane, double t);

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
