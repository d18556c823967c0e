#pragma once

#include <optional>
#include <vector>

#include "mesh/shape/convex.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::rock {

/// One of several convex solids that share a frame.
struct ConvexPiece {
  mesh::ConvexSolid solid_P;
  mesh::TriangleMesh mesh_P;
};

/// A piece that owns the part of a union's facet that lies inside the planes `within_P`. The
/// facet's plane bounds the piece, or the piece touches the facet along an edge.
struct Claim {
  int piece = -1;
  mesh::ConvexSolid within_P;
};

/// For each plane of a union, the pieces that touch its facet. A place on the facet belongs to the
/// first piece that contains it. This piece would also move the vertex if the vertex left the
/// pieces one after another.
using Claims = std::vector<std::vector<Claim>>;

/// The convex union of several pieces, such as the table, the chamfer and the body of a cutter. A
/// vertex leaves all of them at once.
struct ConvexUnion {
  mesh::ConvexSolid solid_P;
  Claims claims;
};

/// Returns the union, or nothing if it is not convex to within tolerance::convex of its size. The
/// union is convex if other pieces cover every facet that does not bound all pieces: the facet is
/// inside these pieces, or they touch it from outside.
std::optional<ConvexUnion> convex_union(const std::vector<ConvexPiece>& pieces);

/// Returns the piece that owns the place x on this plane of the union.
int owner_at(const Claims& claims, std::size_t plane, const Vec3& x_P);

}  // namespace tdbd::rock
