#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Computes the exact contact of a closed convex part with rock whose undisturbed surface is the
/// plane z = `plane_z` (m; rock below, z points down): the facets that move into the rock, n .
/// move_W >= 0, clipped by the plane. Returns the sum of their area vectors, out of the rock, m2.
/// With a `ramp` above 0 each facet counts with its share of the full stress, min(1, tan b / ramp),
/// b being the angle of its motion into the rock; the result is then the rock's force over the full
/// stress. Twin of rock::contact_areas; does not use a rock mesh. part_W: placed at the end of the
/// step; move_W: its uniform displacement in the step, m.
Vec3 contact_area_vector(const mesh::TriangleMesh& part_W, double plane_z, const Vec3& move_W,
                         double ramp = 0.0);

}  // namespace tdbd::reference
