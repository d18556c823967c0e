#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::rock {

/// A point of a meridian curve: radius and depth (z down), m.
struct MeridianPoint {
  double r, z;
};

/// Makes a rock surface of revolution about the z axis. The meridian curve runs from the axis (r =
/// 0) along the bottom and up the wall. Rings of about 2 pi r / edge_length points are placed at an
/// arc spacing of 0.866 edge_length. The normal points out of the rock (up, and towards the axis on
/// the wall). The last ring is the only boundary loop. Thesis: 4.4.1 (reconstructed).
mesh::TriangleMesh borehole(const std::vector<MeridianPoint>& curve, double edge_length);

/// The bottom curve, continued by a vertical wall of height `wall` (m) above its last point.
std::vector<MeridianPoint> with_wall(std::vector<MeridianPoint> bottom, double wall);

/// A flat bottom at depth z inside a wall of height `wall`, m.
std::vector<MeridianPoint> flat_bottom(double radius, double z, double wall);

}  // namespace tdbd::rock
