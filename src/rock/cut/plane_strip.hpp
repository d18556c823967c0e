#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/simd.hpp"
#include "core/types.hpp"
#include "mesh/measures.hpp"
#include "mesh/shape/convex.hpp"

namespace tdbd::rock {

/// The path of a rock vertex relative to a moving part during one step, in the part's frame P, rock
/// (1). At tau in [0, 1] the vertex is at (1-tau) q0 + tau q1, and its update direction is (1-tau)
/// u0 + tau u1. Both are linear to second order in the step.
struct RelativePath {
  Vec3 q0_P, q1_P;  ///< m
  Vec3 u0_P, u1_P;  ///< unit vectors
};

/// The path of a vertex at x_W with update direction u_W relative to a part with these poses.
inline RelativePath relative_path(const Pose& X_PW0, const Pose& X_PW1, const Vec3& x_W,
                                  const Vec3& u_W) {
  return {X_PW0 * x_W, X_PW1 * x_W, X_PW0.R * u_W, X_PW1.R * u_W};
}

/// A plane is parallel to a ray, up to rounding, below this cosine; then it does not block the ray.
inline constexpr double grazing_cosine = 1e-14;

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Narrows intervals of tau to where a path is inside its planes. At tau = 0 the path is `room` (m)
/// inside; until tau = 1 it moves `along` (m) outwards. A plane parallel to the path excludes all
/// of it or nothing.
TDBD_INLINE void narrow_interval(const Wide& room, const Wide& along, Wide& first, Wide& last) {
  const Wide when = room / (along == 0.0 ? Wide{} + 1.0 : along);
  const Wide at_rest = room <= 0.0 ? Wide{} - 1.0 : Wide{} + unbounded;
  const Wide until = along > 0.0 ? when : (along < 0.0 ? Wide{} + unbounded : at_rest);
  const Wide from = along < 0.0 ? when : Wide{};
  last = until < last ? until : last;
  first = from > first ? from : first;
}

/// Four planes of a solid, n . x <= b, one per lane.
struct WidePlanes {
  Wide x, y, z, b;
};

/// Loads four planes from column i on. Only for loops that are TDBD_WIDE.
inline void load(const mesh::ConvexSolid& s, std::size_t i, WidePlanes& planes) {
  TDBD_LOAD(planes.x, &s.nx[i]);
  TDBD_LOAD(planes.y, &s.ny[i]);
  TDBD_LOAD(planes.z, &s.nz[i]);
  TDBD_LOAD(planes.b, &s.b[i]);
}

/// The strip q(tau) + t u(tau) relative to the planes of a convex solid, rock (4): a point (tau, t)
/// is inside plane i if along tau + (up + twist tau) t <= rest. Only the first `columns` entries of
/// each array are set: one for each of the solid's planes, including padding.
struct PlaneStrip {
  using Column = std::array<double, mesh::most_planes>;
  Column rest, along, up, twist;
  std::size_t columns = 0;
};

/// Interval of tau; empty if lo >= hi.
struct Interval {
  double lo, hi;
};

/// Sets `rest` and `along`. Returns the interval of tau in which q(tau) is deeper than `depth`
/// inside every plane. If it is empty, some columns may be unset. Throws std::invalid_argument for
/// solids with more than mesh::most_planes planes.
Interval put_path_on_strip(const mesh::ConvexSolid& s, const RelativePath& p, double depth,
                           PlaneStrip& w);

/// Returns a plane inside which the path between these points is nowhere deeper than `depth`, so
/// that put_path_on_strip returns an empty interval. Returns the number of columns if no single
/// plane shows this.
std::size_t plane_beside_path(const mesh::ConvexSolid& s, const Vec3& q0_P, const Vec3& q1_P,
                              double depth);

/// Whether plane i is such a plane.
bool is_beside_path(const mesh::ConvexSolid& s, std::size_t i, const Vec3& q0_P, const Vec3& q1_P,
                    double depth);

/// Sets `up` and `twist`.
void put_direction_on_strip(const mesh::ConvexSolid& s, const RelativePath& p, PlaneStrip& w);

/// The place at which the ray at tau meets a plane. Of several planes at the same t it is the
/// first.
struct Crossing {
  double tau, t;
  std::size_t plane;
};

/// Where the ray at tau leaves the solid; t is infinite if it never does.
Crossing leave_at(const PlaneStrip& w, double tau);

/// Where the ray at tau enters the last of the planes that it enters. t is minus infinity if it
/// enters none, and infinity if it is parallel to a plane and outside. The ray misses the solid if
/// this t is larger than that of leave_at.
Crossing enter_at(const PlaneStrip& w, double tau);

/// Bounds of the places and of the update directions of some paths.
struct PathBoxes {
  mesh::Box q_P, u_P;
};

/// Bounds of the paths with these indices.
PathBoxes boxes_around(const std::vector<RelativePath>& paths,
                       const std::vector<std::size_t>& which);

/// The planes of a convex solid that any path in some boxes can meet within a distance `t_max` (m)
/// along its update direction. An exit from these planes within t_max is bitwise the exit from the
/// solid (find_exit), because all other planes are farther away. The result does not depend on the
/// boxes for which the planes were found, so they can be kept from step to step.
struct NearPlanes {
  mesh::ConvexSolid solid_P;
  std::vector<std::size_t> plane;  ///< per plane: its index in the solid
  PathBoxes hold_for;
  double t_max = 0.0;
  double checksum = 0.0;  ///< of the solid
  int uses = 0;           ///< since the planes were found
};

/// A sum over the planes that distinguishes solids.
double checksum(const mesh::ConvexSolid& solid);

/// Finds the near planes of a solid. `near` is a reused buffer. `depth`: as in find_exit.
void find_near_planes(const mesh::ConvexSolid& solid, const PathBoxes& boxes, double depth,
                      double t_max, NearPlanes& near);

/// Keeps the planes in `near` if they are valid for these boxes; otherwise finds the planes for
/// somewhat wider boxes. `sum`: checksum of the solid.
void update_near_planes(const mesh::ConvexSolid& solid, double sum, const PathBoxes& boxes,
                        double depth, double t_max, NearPlanes& near);

}  // namespace tdbd::rock
