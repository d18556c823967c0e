#pragma once

#include <vector>

#include "bit/cone.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::bit {

/// The meridian of a solid of revolution about a cone's axis: a polygon of points (s, r), r >= 0. A
/// side along the axis is not part of the surface.
using Meridian = std::vector<ShellPoint>;

/// Signed distance (m) of the point (s, r) from a solid of revolution, negative inside. It is also
/// the distance in space of any point at (s, r).
double signed_distance(const Meridian& solid, const ShellPoint& p);

/// The meridian of a shell: its profile, closed to the axis at both ends.
Meridian shell_meridian(const std::vector<ShellPoint>& shell);

/// A convex polygon that contains the meridian of the volume that a convex part sweeps in a full
/// turn of its cone. Each of its corners is reached by a corner of the mesh or lies vertically
/// below one, towards the axis. So its outer side is exact, and its inner side is too low by at
/// most y^2/(2 r).
Meridian swept_meridian(const mesh::TriangleMesh& convex_P, const Pose& X_KP);

}  // namespace tdbd::bit
