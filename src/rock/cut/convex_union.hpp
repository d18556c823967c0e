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

/// A piece that owns the facet of a union's plane where it lies inside these planes. It has the
/// plane, or touches the facet at an edge.
struct Claim {
  int piece = -1;
  mesh::ConvexSolid within_P;
};

/// For each plane of a union the pieces that touch its facet; of these the first that holds a place
/// owns it, as the first of them takes the vertex if it leaves them one after another.
using Claims = std::vector<std::vector<Claim>>;

/// Pieces that fill one convex solid together, such as the table, the chamfer and the body of a
/// cutter: a vertex goes out of all of them at once.
struct ConvexUnion {
  mesh::ConvexSolid solid_P;
  Claims claims;
};

/// The union if it is convex to tolerance::convex of its size. It is if every facet that does not
/// bound all pieces is covered by other pieces, which have it inside or touch it from outside.
std::optional<ConvexUnion> convex_union(const std::vector<ConvexPiece>& pieces);

/// The piece that has the place x on this plane of the union.
int owner_at(const Claims& claims, std::size_t plane, const Vec3& x_P);

}  // namespace tdbd::rock
