#pragma once

#include <optional>
#include <vector>

#include "core/types.hpp"
#include "mesh/shape/convex.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {

/// Depth of x inside the solid (m, to the nearest plane); negative outside.
double depth_inside(const mesh::ConvexSolid& solid, const Vec3& x_P);

/// Whether the path of the vertex itself enters the solid by more than `depth` (m), rock (2).
bool is_swept(const mesh::ConvexSolid& solid, const RelativePath& path, double depth);

/// Exit distance of a swept vertex: the largest t >= 0 for which some tau puts q(tau) + t u(tau)
/// inside the solid. The strip meets a convex solid in a convex region of (tau, t), except for the
/// turn of u, which is iterated away. See rock (3), (4); twin for any mesh:
/// reference/rock/brute_force_exit. Thesis: 4.1.3.3 (reconstructed). Nothing if not swept.
std::optional<double> exit_distance(const mesh::ConvexSolid& solid, const RelativePath& path,
                                    double depth, PlaneStrip& strip);

}  // namespace tdbd::rock
