#pragma once

#include <optional>
#include <vector>

#include "core/types.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {

/// How deep x lies inside (m, to the nearest plane); negative outside.
double depth_inside(const mesh::ConvexSolid& solid, const Vec3& x_P);

/// Whether the path of the vertex alone enters the solid by more than `depth` (m).
bool is_swept(const mesh::ConvexSolid& solid, const RelativePath& path, double depth);

/// Exit distance of a swept vertex: the largest t >= 0 for which some tau puts
/// q(tau) + t u(tau) inside the solid. The strip meets a convex solid in a convex region of
/// (tau, t), up to the turn of u, which is iterated away. Exact twin for any mesh:
/// reference/rock/brute_force_exit. Thesis: 4.1.3.3 (reconstructed). Nothing if not swept.
std::optional<double> exit_distance(const mesh::ConvexSolid& solid, const RelativePath& path,
                                    double depth, PlaneStrip& strip);

}  // namespace tdbd::rock
