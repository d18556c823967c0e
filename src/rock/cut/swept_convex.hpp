#pragma once

#include <limits>
#include <optional>

#include "core/types.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {

/// A place is on a plane if its distance is at most this, m.
inline constexpr double corner_tolerance = 1e-11;

/// A ray touches the solid if it enters at most this much after it leaves, m.
inline constexpr double entry_tolerance = 1e-12;

/// Depth of x inside the solid (m, to the nearest plane); negative outside.
double depth_inside(const mesh::ConvexSolid& solid, const Vec3& x_P);

/// Whether the path of the vertex itself enters the solid by more than `depth` (m), rock (2).
bool is_swept(const mesh::ConvexSolid& solid, const RelativePath& path, double depth);

/// Returns the exit of a swept vertex: the largest t >= 0 for which some tau puts q(tau) + t u(tau)
/// inside the solid, that tau, and the plane through which the vertex leaves. Returns nothing if
/// the vertex is not swept. The search stops at a place with t >= `t_max`, which need not be the
/// exit. Below t_max the result is bitwise independent of planes that the path cannot reach within
/// t_max (near_planes.hpp). See rock (3), (4). Thesis: 4.1.3.3 (reconstructed). Twins:
/// reference/rock/exit_by_corners and, for any mesh, brute_force_exit.
std::optional<Crossing> find_exit(const mesh::ConvexSolid& solid, const RelativePath& path,
                                  double depth, PlaneStrip& strip,
                                  double t_max = std::numeric_limits<double>::infinity());

/// The t of find_exit.
std::optional<double> exit_distance(const mesh::ConvexSolid& solid, const RelativePath& path,
                                    double depth, PlaneStrip& strip);

}  // namespace tdbd::rock
