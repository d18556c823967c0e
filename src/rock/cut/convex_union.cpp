#include "rock/cut/convex_union.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/tolerance.hpp"
#include "mesh/measures.hpp"

namespace tdbd::rock {

mesh::ConvexSolid spread_planes(const mesh::ConvexSolid& planes, std::size_t most) {
  constexpr std::size_t first = 6;  // the sides of a box, if the solid has one
  mesh::ConvexSolid chosen;
  std::vector<double> nearest(planes.planes, -1.0);  // cosine to the nearest selected plane
  for (std::size_t k = 0; k < std::min(most, planes.planes); ++k) {
    const std::size_t next =
        k < first ? k
                  : static_cast<std::size_t>(std::ranges::min_element(nearest) - nearest.begin());
    const Vec3 n = mesh::normal(planes, next);
    mesh::add_plane(chosen, n, planes.b[next]);
    for (std::size_t i = 0; i < planes.planes; ++i)
      nearest[i] = std::max(nearest[i], n.dot(mesh::normal(planes, i)));
  }
  mesh::pad(chosen);
  return chosen;
}

namespace {

struct Plane {
  Vec3 n;
  double b;
};

Plane plane_of(const mesh::ConvexSolid& s, std::size_t i) { return {mesh::normal(s, i), s.b[i]}; }

double height(const Plane& p, const Vec3& x) { return p.n.dot(x) - p.b; }

/// Whether two planes, including their orientation, coincide for a solid of this size. The offsets
/// are compared first because most planes differ there.
bool coincide(const Plane& p, const Plane& q, double size) {
  return std::abs(p.b - q.b) <= 2.0 * tolerance::convex * size &&
         (p.n - q.n).norm() <= tolerance::convex;
}

template <class Has>
bool any_plane(const mesh::ConvexSolid& s, Has&& has) {
  for (std::size_t i = 0; i < s.planes; ++i)
    if (has(plane_of(s, i))) return true;
  return false;
}

bool has_plane(const mesh::ConvexSolid& s, const Plane& p, double size) {
  return any_plane(s, [&](const Plane& q) { return coincide(p, q, size); });
}

double size_of(const std::vector<ConvexPart>& pieces) {
  mesh::Box box;
  for (const ConvexPart& piece : pieces)
    for (const Vec3& x : piece.mesh_P.positions) box.add(x);
  return box.size().norm();
}

/// The planes of the pieces that bound all pieces, without duplicates, moved outwards to the
/// outermost corner.
mesh::ConvexSolid bounding_planes(const std::vector<ConvexPart>& pieces, double size) {
  mesh::ConvexSolid bounding;
  for (const ConvexPart& piece : pieces)
    for (std::size_t i = 0; i < piece.solid_P.planes; ++i) {
      Plane p = plane_of(piece.solid_P, i);
      double out = 0.0;
      for (const ConvexPart& other : pieces)
        for (const Vec3& x : other.mesh_P.positions) out = std::max(out, height(p, x));
      if (out > tolerance::convex * size || has_plane(bounding, p, size)) continue;
      mesh::add_plane(bounding, p.n, p.b + out);
    }
  return bounding;
}

std::vector<Vec3> corners_on(const ConvexPart& piece, const Plane& p, double slack) {
  std::vector<Vec3> on;
  for (const Vec3& x : piece.mesh_P.positions)
    if (std::abs(height(p, x)) <= slack) on.push_back(x);
  return on;
}

using Polygon = std::vector<Vec3>;  ///< convex, corners in order

/// The part of the polygon on the plane's outer side (sign 1) or inner side (sign -1).
Polygon clipped(const Polygon& polygon, const Plane& p, double sign) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &x = polygon[i], &y = polygon[(i + 1) % polygon.size()];
    const double hx = sign * height(p, x), hy = sign * height(p, y);
    if (hx >= 0.0) kept.push_back(x);
    if ((hx > 0.0 && hy < 0.0) || (hx < 0.0 && hy > 0.0))
      kept.push_back(x + hx / (hx - hy) * (y - x));
  }
  return kept;
}

double greatest_height(const Plane& p, const Polygon& polygon) {
  double out = -1e300;
  for (const Vec3& x : polygon) out = std::max(out, height(p, x));
  return out;
}

/// Whether the union of these pieces contains the outer side of the polygon. What lies outside the
/// first piece must be covered by the pieces after it. `facet`: the polygon's plane.
bool is_covered(Polygon polygon, const Plane& facet, std::span<const ConvexPart* const> by,
                double size) {
  if (by.empty()) return false;
  const mesh::ConvexSolid& solid = by.front()->solid_P;
  const auto others = by.subspan(1);
  if (has_plane(solid, facet, size)) return is_covered(std::move(polygon), facet, others, size);
  for (std::size_t i = 0; i < solid.planes; ++i) {
    const Plane p = plane_of(solid, i);
    if (greatest_height(p, polygon) <= tolerance::convex * size) continue;
    if (!is_covered(clipped(polygon, p, 1.0), facet, others, size)) return false;
    polygon = clipped(polygon, p, -1.0);
    if (polygon.empty()) return true;
  }
  return true;
}

/// Whether other pieces cover all of a piece's surface that does not bound the union.
bool inner_facets_are_covered(const std::vector<ConvexPart>& pieces, const ConvexPart& piece,
                              const mesh::ConvexSolid& bounding, double size) {
  std::vector<const ConvexPart*> others;
  for (const ConvexPart& other : pieces)
    if (&other != &piece) others.push_back(&other);
  const mesh::TriangleMesh& m = piece.mesh_P;
  return std::ranges::all_of(m.triangles, [&](const mesh::Triangle& t) {
    const Polygon corners{m.positions[at(t[0])], m.positions[at(t[1])], m.positions[at(t[2])]};
    const Vec3 area = mesh::area_vector(corners[0], corners[1], corners[2]);
    if (area.norm() <= tolerance::convex * size * size) return true;  // degenerate triangle
    const Plane facet{area.normalized(), area.normalized().dot(corners[0])};
    return has_plane(bounding, facet, size) || is_covered(corners, facet, others, size);
  });
}

/// The planes of a piece that cut the union's facet with these corners, moved outwards by `slack`.
/// Exits often lie on the piece's edge; the slack assigns them to the piece in spite of rounding.
mesh::ConvexSolid cuts(const ConvexPart& piece, const std::vector<Vec3>& corners, double slack) {
  mesh::ConvexSolid within;
  for (std::size_t i = 0; i < piece.solid_P.planes; ++i) {
    const Plane p = plane_of(piece.solid_P, i);
    if (std::ranges::any_of(corners, [&](const Vec3& x) { return height(p, x) > slack; }))
      mesh::add_plane(within, p.n, p.b + slack);
  }
  return within;
}

std::vector<FacetOwner> claims_on(const std::vector<ConvexPart>& pieces, const Plane& p,
                                  double size) {
  const double slack = 2.0 * tolerance::convex * size;
  std::vector<Vec3> corners;
  for (const ConvexPart& piece : pieces) {
    const std::vector<Vec3> more = corners_on(piece, p, slack);
    corners.insert(corners.end(), more.begin(), more.end());
  }
  std::vector<FacetOwner> claims;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (corners_on(pieces[i], p, slack).empty()) continue;
    claims.push_back({static_cast<int>(i), cuts(pieces[i], corners, slack)});
    if (claims.back().within_P.planes == 0) break;
  }
  return claims;
}

}  // namespace

std::optional<ConvexUnion> convex_union(const std::vector<ConvexPart>& pieces) {
  const double size = size_of(pieces);
  const mesh::ConvexSolid bounding = bounding_planes(pieces, size);
  if (bounding.planes < 4 || bounding.planes > mesh::most_planes) return std::nullopt;
  const auto is_inside = [&](const ConvexPart& piece) {
    return inner_facets_are_covered(pieces, piece, bounding, size);
  };
  if (!std::ranges::all_of(pieces, is_inside)) return std::nullopt;
  ConvexUnion whole{spread_planes(bounding, bounding.planes), {}};
  for (std::size_t i = 0; i < whole.solid_P.planes; ++i)
    whole.claims.push_back(claims_on(pieces, plane_of(whole.solid_P, i), size));
  return whole;
}

int owner_at(const FacetOwners& all, std::size_t plane, const Vec3& x_P) {
  const std::vector<FacetOwner>& claims = all[plane];
  const auto holds = [&](const FacetOwner& c) {
    return !any_plane(c.within_P, [&](const Plane& p) { return height(p, x_P) > 0.0; });
  };
  const auto owner = std::ranges::find_if(claims, holds);
  return (owner == claims.end() ? claims.back() : *owner).piece;
}

}  // namespace tdbd::rock
