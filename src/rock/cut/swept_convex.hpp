#pragma once

#include <limits>
#include <optional>

#include "core/types.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {

/// Planes no farther from a place than this meet there, m.
inline constexpr double corner_tolerance = 1e-11;

/// A ray touches the solid if it enters no later than this after it leaves, m.
inline constexpr double entry_tolerance = 1e-12;

/// Depth of x inside the solid (m, to the nearest plane); negative outside.
double depth_inside(const mesh::ConvexSolid& solid, const Vec3& x_P);

/// Whether the path of the vertex itself enters the solid by more than `depth` (m), rock (2).
bool is_swept(const mesh::ConvexSolid& solid, const RelativePath& path, double depth);

/// The exit of a swept vertex: the largest t >= 0 for which some tau puts q(tau) + t u(tau) inside
/// the solid, that tau, and the plane through which it leaves. See rock (3), (4); twins:
/// reference/rock/exit_by_corners, and for any mesh brute_force_exit. Thesis: 4.1.3.3
/// (reconstructed). Nothing if not swept. A t beyond `t_max` says no more than that the search came
/// by such a place; up to there the answer does not depend, to the bit, on planes that the path
/// cannot reach within t_max (near_planes.hpp).
std::optional<Crossing> find_exit(const mesh::ConvexSolid& solid, const RelativePath& path,
                                  double depth, PlaneStrip& strip,
                                  double t_max = std::numeric_limits<double>::infinity());

/// The t of find_exit.
std::optional<double> exit_distance(const mesh::ConvexSolid& solid, const RelativePath& path,
                                    double depth, PlaneStrip& strip);

}  // namespace tdbd::rock
