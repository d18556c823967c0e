#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace tdbd::mesh {

/// A convex solid as the intersection of half-spaces n . x <= b, mesh (7), with unit outward
/// normals. The planes are stored as columns because loops run over them, and padded to a multiple
/// of `lanes` with planes that exclude nothing (n = 0, b infinite).
struct ConvexSolid {
  std::vector<double> nx, ny, nz, b;
  std::size_t planes = 0;  ///< number without the padding
};

inline Vec3 normal(const ConvexSolid& s, std::size_t i) { return {s.nx[i], s.ny[i], s.nz[i]}; }

/// Appends a plane. Must be called before pad().
void add_plane(ConvexSolid& solid, const Vec3& n, double b);

/// Appends the padding.
void pad(ConvexSolid& solid);

/// With more planes than this, a tree over the facets is faster.
inline constexpr std::size_t most_planes = 512;

/// Returns the planes of a closed mesh if it is convex within tolerance::convex times its size and
/// has at most `most` planes, otherwise nothing. Coplanar triangles give one plane. Each plane
/// touches the outermost vertex, so the solid contains the mesh.
std::optional<ConvexSolid> convex_solid(const TriangleMesh& m, std::size_t most = most_planes);

/// Clips a closed convex mesh to n.x <= b and closes it with a flat fan; n is a unit vector.
/// Vertices closer to the plane than 1e-12 of the size of the mesh count as lying on it. Pieces of
/// clipped triangles remain in their planes, so the result is convex. Returns an empty mesh if no
/// part is strictly inside, and `m` if no part is outside.
TriangleMesh clipped_convex(const TriangleMesh& m, const Vec3& n, double b);

}  // namespace tdbd::mesh
