#pragma once

#include <vector>

#include "bit/cone.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::bit {

/// A solid of revolution about a cone's axis by its meridian: a polygon of points (s, r), r >= 0.
/// A side along the axis is no surface.
using Meridian = std::vector<ShellPoint>;

/// Signed distance (m) of a place (s, r) from a solid of revolution: negative inside. The distance
/// in space of any point that comes to (s, r) is the same.
double signed_distance(const Meridian& solid, const ShellPoint& p);

/// Of a shell: its profile, closed to the axis at both ends.
Meridian shell_meridian(const std::vector<ShellPoint>& shell);

/// Of what a convex part sweeps in a full turn of its cone: a convex polygon that contains it. Its
/// corners are reached by corners of the mesh, or lie straight below them towards the axis; so the
/// outer side is exact and the inner one at most y^2/(2 r) too low.
Meridian swept_meridian(const mesh::TriangleMesh& convex_P, const Pose& X_KP);

}  // namespace tdbd::bit
