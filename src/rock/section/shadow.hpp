#pragma once

#include <array>

#include "mesh/shape/convex.hpp"

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
Exit exit_of_way(const mesh::ConvexSolid& solid, const Vec3& U, const Vec3& e, const Vec3& x_P);

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

}  // namespace tdbd::rock
