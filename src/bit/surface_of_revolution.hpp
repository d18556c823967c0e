#pragma once

#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::bit {

/// A ring of points about the X axis. Point k of n is at the angle a = 2 pi k / n from -Z towards
/// +Y: (x, radius sin a, -radius cos a). A ring with one point lies on the axis.
struct Ring {
  double radius = 0.0;  ///< m
  double x = 0.0;       ///< m
  int count = 1;
};

/// Makes a closed mesh that connects each ring to the next. The rings follow the meridian from the
/// solid's +X end, on the axis, to its other end, on the axis, so that the normals point outwards.
/// Rings with different counts are connected by always advancing the smaller angle. The polygons
/// are inscribed, and every ring has a point at exactly -Z. Thesis: 3.3.
mesh::TriangleMesh surface_of_revolution(const std::vector<Ring>& rings);

}  // namespace tdbd::bit
