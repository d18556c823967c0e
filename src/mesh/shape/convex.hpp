#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// A convex solid as the intersection of half-spaces n . x <= b, mesh (7), with unit outward normals. Stored as columns,
/// because loops run over planes, and padded to a multiple of `lanes` with planes that exclude nothing (n = 0, b
/// infinite).
struct ConvexSolid {
  std::vector<double> nx, ny, nz, b;
  std::size_t planes = 0;  ///< without the padding
};

inline Vec3 normal(const ConvexSolid& s, std::size_t i) { return {s.nx[i], s.ny[i], s.nz[i]}; }

/// Appends a plane; call it before pad().
void add_plane(ConvexSolid& solid, const Vec3& n, double b);

/// Appends the padding.
void pad(ConvexSolid& solid);

/// With more planes than this a tree over the facets is faster.
inline constexpr std::size_t most_planes = 512;

/// The planes of a closed mesh if it is convex to tolerance::convex times its size and has at most `most` of them, else
/// nothing. Coplanar triangles give one plane; each plane touches the outermost vertex, so the solid contains the mesh.
std::optional<ConvexSolid> convex_solid(const TriangleMesh& m, std::size_t most = most_planes);

}  // namespace tdbd::mesh
