#pragma once

#include <array>

#include "mesh/shape/convex.hpp"

namespace tdbd::rock {

/// A straight way U + t e, 0 <= t <= 1, over a convex solid of planes, and the direction u along which
/// the solid is seen from it: the points U + t e + s u of the way's shadow are inside plane i while
/// a t + c s <= r. Without a direction u is zero and c one, and s the distance from a plane, so that
/// the lowest plane is the nearest. All in the frame P, m. Where a contact ends, rock (14), follows
/// from these rows.
struct Shadow {
  using Column = std::array<double, mesh::most_planes>;

  const mesh::ConvexSolid& solid;
  Vec3 U, e, u;
  Column a, c, r;  ///< of the solid's planes and its padding; the latter bounds nothing

  /// A pressed vertex x_P that only touches lies outside of its planes by up to the gap: they are moved
  /// out to it.
  Shadow(const mesh::ConvexSolid& solid, const Vec3& U, const Vec3& e, const Vec3& u,
         const Vec3& x_P);
  /// Without a direction.
  Shadow(const mesh::ConvexSolid& solid, const Vec3& U, const Vec3& e, const Vec3& x_P);

  std::size_t planes() const { return solid.planes; }
  std::size_t columns() const { return solid.b.size(); }
  /// Of a plane that is not parallel to u: s at which the line at t meets it, m.
  double height(std::size_t i, double t) const { return (r[i] - a[i] * t) / c[i]; }
  Vec3 point(double t, double s) const { return U + t * e + s * u; }
};

enum class Facing { parallel, up, down };  ///< along u: a side, what is below, what is above

inline constexpr double least_cosine = 1e-9;  ///< with u, of a plane that is not parallel to it

/// Of a plane whose normal has this cosine with u.
inline Facing facing(double cosine) {
  if (cosine > least_cosine) return Facing::up;
  return cosine < -least_cosine ? Facing::down : Facing::parallel;
}

inline Facing facing(const Shadow& w, std::size_t i) { return facing(w.c[i]); }

/// Where a way leaves the solid, and through which plane; t = 1: it does not.
struct Exit {
  double t = 1.0;
  std::size_t plane = 0;
};

/// Of the way itself, s = 0, without its rows. x_P: as for Shadow.
Exit exit_of_way(const mesh::ConvexSolid& solid, const Vec3& U, const Vec3& e, const Vec3& x_P);

/// How far along u the solid reaches at t, m: at least 0.
double reach_at(const Shadow& w, double t);

/// The end of the shadow: the point of largest t, up to that of the planes parallel to u, at which
/// the line is inside for some s >= 0.
Vec3 end_of_shadow(const Shadow& w);

/// A stretch of the surface below the way, seen along u: on one plane.
struct Stretch {
  std::size_t plane = 0;
  double from = 0.0, to = 0.0;           ///< t
  std::size_t next = mesh::most_planes;  ///< the plane that follows; most_planes: none, or t is 1
};

Stretch first_stretch(const Shadow& w);

/// The stretch that begins at t on this plane.
Stretch stretch_from(const Shadow& w, std::size_t plane, double t);

}  // namespace tdbd::rock
