#include "reference/rock/swept_boolean.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Vertex = SurfaceMesh::Vertex_index;

Point exact(const Vec3& x) { return {x[0], x[1], x[2]}; }

SurfaceMesh to_cgal(const mesh::TriangleMesh& m) {
  SurfaceMesh surface;
  for (const Vec3& x : m.positions) surface.add_vertex(exact(x));
  for (const auto& [a, b, c] : m.triangles)
    if (surface.add_face(Vertex(a), Vertex(b), Vertex(c)) == SurfaceMesh::null_face())
      throw RunError("swept_boolean: the block of rock is not a manifold");
  return surface;
}

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

mesh::TriangleMesh from_cgal(SurfaceMesh& surface) {
  surface.collect_garbage();
  mesh::TriangleMesh m;
  for (const Vertex v : surface.vertices()) {
    const Point& x = surface.point(v);
    m.positions.push_back({rounded(x.x()), rounded(x.y()), rounded(x.z())});
  }
  for (const SurfaceMesh::Face_index f : surface.faces()) {
    const auto h = surface.halfedge(f);
    m.triangles.push_back({static_cast<int>(surface.source(h).idx()),
                           static_cast<int>(surface.target(h).idx()),
                           static_cast<int>(surface.target(surface.next(h)).idx())});
  }
  return m;
}

}  // namespace

SweptBoolean swept_boolean(const mesh::TriangleMesh& block_W, const mesh::TriangleMesh& part_P,
                           const std::vector<Pose>& X_WP) {
  SurfaceMesh rock = to_cgal(block_W);
  const Kernel::FT before = pmp::volume(rock);
  for (std::size_t i = 0; i + 1 < X_WP.size(); ++i) {
    SurfaceMesh swept = hull(part_P, X_WP[i], X_WP[i + 1]);
    if (!pmp::corefine_and_compute_difference(rock, swept, rock))
      throw RunError("swept_boolean: what is left of the rock is not a manifold");
  }
  const Kernel::FT after = pmp::volume(rock);
  return {rounded(before), rounded(after), rounded(before - after), from_cgal(rock)};
}

}  // namespace tdbd::reference
