#include "benchmarks/corefinement.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <ctime>

#include "core/error.hpp"

namespace tdbd::bench {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Vertex = SurfaceMesh::Vertex_index;

Point to_cgal(const Vec3& x) { return {x[0], x[1], x[2]}; }

SurfaceMesh to_cgal(const mesh::TriangleMesh& m) {
  SurfaceMesh surface;
  for (const Vec3& x : m.positions) surface.add_vertex(to_cgal(x));
  for (const auto& [a, b, c] : m.triangles)
    if (surface.add_face(Vertex(a), Vertex(b), Vertex(c)) == SurfaceMesh::null_face())
      throw RunError("corefinement: the block of rock is not a manifold");
  return surface;
}

mesh::TriangleMesh from_cgal(SurfaceMesh& surface) {
  surface.collect_garbage();
  mesh::TriangleMesh m;
  for (const Vertex v : surface.vertices()) {
    const Point& x = surface.point(v);
    m.positions.push_back({x.x(), x.y(), x.z()});
  }
  for (const SurfaceMesh::Face_index f : surface.faces()) {
    const auto h = surface.halfedge(f);
    m.triangles.push_back({static_cast<int>(surface.source(h).idx()),
                           static_cast<int>(surface.target(h).idx()),
                           static_cast<int>(surface.target(surface.next(h)).idx())});
  }
  return m;
}

SurfaceMesh tool_of(const std::vector<std::vector<Vec3>>& hulls_W) {
  SurfaceMesh tool;
  for (const std::vector<Vec3>& corners : hulls_W) {
    std::vector<Point> points;
    for (const Vec3& x : corners) points.push_back(to_cgal(x));
    SurfaceMesh hull;
    CGAL::convex_hull_3(points.begin(), points.end(), hull);
    pmp::triangulate_faces(hull);
    tool += hull;
  }
  if (pmp::does_self_intersect(tool)) throw RunError("corefinement: hulls of two cutters meet");
  return tool;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

BooleanCut cut_by_corefinement(const mesh::TriangleMesh& block_W,
                               const std::vector<std::vector<Vec3>>& hulls_W) {
  SurfaceMesh rock = to_cgal(block_W), tool = tool_of(hulls_W);
  const double before = pmp::volume(rock);
  const double start = cpu_seconds();
  if (!pmp::corefine_and_compute_difference(rock, tool, rock))
    throw RunError("corefinement: what is left of the rock is not a manifold");
  const double seconds = cpu_seconds() - start;
  return {seconds, before - pmp::volume(rock), from_cgal(rock)};
}

}  // namespace tdbd::bench
