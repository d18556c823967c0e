#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// A convex solid as the intersection of half-spaces n . x <= b, normals unit and outward. Stored
/// as columns, because loops run over planes.
struct ConvexSolid {
  std::vector<double> nx, ny, nz, b;

  int planes() const { return static_cast<int>(b.size()); }
};

/// With more planes than this a tree over the facets answers sooner.
inline constexpr std::size_t most_planes = 512;

/// The planes of a closed mesh if it is convex to tolerance::convex times its size and has at most
/// `most_planes`, else nothing.
/// Coplanar triangles give one plane; each plane touches the vertex farthest out, so the solid
/// contains the mesh.
std::optional<ConvexSolid> convex_solid(const TriangleMesh& m);

}  // namespace tdbd::mesh
