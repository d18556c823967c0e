#include "benchmarks/corefinement.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/convex_hull_3.h>

#include <ctime>

#include "core/error.hpp"
#include "reference/mesh/cgal_surface.hpp"

namespace tdbd::bench {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

Point to_cgal(const Vec3& x) { return {x[0], x[1], x[2]}; }

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
  SurfaceMesh rock = reference::surface_mesh_of<Point>(block_W), tool = tool_of(hulls_W);
  const double before = pmp::volume(rock);
  const double start = cpu_seconds();
  if (!pmp::corefine_and_compute_difference(rock, tool, rock))
    throw RunError("corefinement: what is left of the rock is not a manifold");
  const double seconds = cpu_seconds() - start;
  return {seconds, before - pmp::volume(rock),
          reference::triangle_mesh_of(rock, [](double x) { return x; })};
}

}  // namespace tdbd::bench
