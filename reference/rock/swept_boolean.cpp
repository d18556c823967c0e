#include "reference/rock/swept_boolean.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/convex_hull_3.h>

#include "core/error.hpp"
#include "reference/mesh/cgal_surface.hpp"

namespace tdbd::reference {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

Point exact(const Vec3& x) { return {x[0], x[1], x[2]}; }

/// Convex hull of the part at two poses, spatial frame.
SurfaceMesh hull(const mesh::TriangleMesh& part_P, const Pose& X_WP0, const Pose& X_WP1) {
  std::vector<Point> points;
  for (const Vec3& x_P : part_P.positions) {
    points.push_back(exact(X_WP0 * x_P));
    points.push_back(exact(X_WP1 * x_P));
  }
  SurfaceMesh surface;
  CGAL::convex_hull_3(points.begin(), points.end(), surface);
  pmp::triangulate_faces(surface);
  return surface;
}

double rounded(const Kernel::FT& x) { return CGAL::to_double(CGAL::exact(x)); }

}  // namespace

SweptBoolean swept_boolean(const mesh::TriangleMesh& block_W, const mesh::TriangleMesh& part_P,
                           const std::vector<Pose>& X_WP) {
  SurfaceMesh rock = surface_mesh_of<Point>(block_W);
  const Kernel::FT before = pmp::volume(rock);
  for (std::size_t i = 0; i + 1 < X_WP.size(); ++i) {
    SurfaceMesh swept = hull(part_P, X_WP[i], X_WP[i + 1]);
    if (!pmp::corefine_and_compute_difference(rock, swept, rock))
      throw RunError("swept_boolean: what is left of the rock is not a manifold");
  }
  const Kernel::FT after = pmp::volume(rock);
  return {rounded(before), rounded(after), rounded(before - after),
          triangle_mesh_of(rock, rounded)};
}

}  // namespace tdbd::reference
