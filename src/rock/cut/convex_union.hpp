#pragma once

#include <optional>
#include <vector>

#include "mesh/shape/convex.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::rock {

/// Selects at most `most` planes: the first six, then repeatedly the plane whose normal is farthest
/// from those already selected. The selection bounds the solid closely, and most outside points are
/// outside one of the first planes. The result is padded.
mesh::ConvexSolid spread_planes(const mesh::ConvexSolid& planes, std::size_t most);

/// One of several convex solids that share a frame.
struct ConvexPart {
  mesh::ConvexSolid solid_P;
  mesh::TriangleMesh mesh_P;
};

/// A piece that owns the part of a union's facet that lies inside the planes `within_P`. The
/// facet's plane bounds the piece, or the piece touches the facet along an edge.
struct FacetOwner {
  int piece = -1;
  mesh::ConvexSolid within_P;
};

/// For each plane of a union, the pieces that touch its facet. A place on the facet belongs to the
/// first piece that contains it. This piece would also move the vertex if the vertex left the
/// pieces one after another.
using FacetOwners = std::vector<std::vector<FacetOwner>>;

/// The convex union of several pieces, such as the table, the chamfer and the body of a cutter. A
/// vertex leaves all of them at once.
struct ConvexUnion {
  mesh::ConvexSolid solid_P;
  FacetOwners claims;
};

/// Returns the union, or nothing if it is not convex to within tolerance::convex of its size. The
/// union is convex if other pieces cover every facet that does not bound all pieces: the facet is
/// inside these pieces, or they touch it from outside.
std::optional<ConvexUnion> convex_union(const std::vector<ConvexPart>& pieces);

/// Returns the piece that owns the place x on this plane of the union.
int owner_at(const FacetOwners& claims, std::size_t plane, const Vec3& x_P);

}  // namespace tdbd::rock
