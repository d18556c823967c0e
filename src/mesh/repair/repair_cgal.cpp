#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <optional>
#include <utility>

#include "mesh/check/check.hpp"
#include "mesh/check/nesting.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/quiet_cgal.hpp"
#include "mesh/repair/repair.hpp"
#include "mesh/repair/repair_steps.hpp"

namespace tdbd::mesh {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

Kernel::Point_3 to_cgal(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

SurfaceMesh to_cgal(const TriangleMesh& m) {
  using Vertex = SurfaceMesh::Vertex_index;
  SurfaceMesh surface;
  for (const Vec3& x : m.positions) surface.add_vertex(to_cgal(x));
  for (const Triangle& t : m.triangles)
    surface.add_face(Vertex(static_cast<SurfaceMesh::size_type>(t[0])),
                     Vertex(static_cast<SurfaceMesh::size_type>(t[1])),
                     Vertex(static_cast<SurfaceMesh::size_type>(t[2])));
  return surface;
}

TriangleMesh from_cgal(SurfaceMesh surface) {
  surface.collect_garbage();
  TriangleMesh m;
  m.positions.reserve(surface.number_of_vertices());
  for (const auto v : surface.vertices()) {
    const Kernel::Point_3& p = surface.point(v);
    m.positions.push_back(Vec3(p.x(), p.y(), p.z()));
  }
  m.triangles.reserve(surface.number_of_faces());
  for (const auto f : surface.faces()) {
    Triangle t{};
    std::size_t k = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
      t.at(k++) = static_cast<int>(v.idx());
    m.triangles.push_back(t);
  }
  return m;
}

/// The union of sound bodies in doubles. Nothing if it is no manifold.
std::optional<TriangleMesh> united(const std::vector<Solid>& bodies) {
  SurfaceMesh all = to_cgal(bodies.front().mesh);
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    SurfaceMesh next = to_cgal(bodies[i].mesh);
    if (!processing::corefine_and_compute_union(all, next, all)) return std::nullopt;
  }
  return from_cgal(std::move(all));
}

/// Removes facets that have zero area because computed points were rounded. Returns whether the
/// mesh is then sound.
bool clean_up(TriangleMesh& m) {
  constexpr double rounding = 1e-14;
  merge_points(m, rounding * bounding_box(m).size().norm());
  remove_degenerate(m);
  drop_unused_points(m);
  return check_solid(m).empty();
}

}  // namespace

std::vector<Triangle> triangulate_loop(const std::vector<Vec3>& loop) {
  const QuietCgal quiet;
  std::vector<Kernel::Point_3> points;
  points.reserve(loop.size());
  for (const Vec3& x : loop) points.push_back(to_cgal(x));
  std::vector<CGAL::Triple<int, int, int>> patch;
  processing::triangulate_hole_polyline(points, std::back_inserter(patch));
  std::vector<Triangle> triangles;
  triangles.reserve(patch.size());
  for (const auto& [a, b, c] : patch) {
    Triangle t{a, b, c};
    std::sort(t.begin(), t.end());  // restores the direction of the loop
    triangles.push_back(t);
  }
  return triangles;
}

bool unite_pieces(TriangleMesh& m) {
  const QuietCgal quiet;
  std::vector<Solid> bodies;
  for (TriangleMesh& body : submeshes(m, facets_of_bodies(m)))
    bodies.push_back({"a piece", std::move(body)});
  for (const Solid& body : bodies)
    if (bodies.size() == 1 || !check_solid(body.mesh).empty()) return false;
  try {
    if (auto both = united(bodies); both && clean_up(*both)) {
      m = std::move(*both);
      return true;
    }
  } catch (const std::exception&) {  // a failed assertion in CGAL: exact arithmetic may succeed
  }
  United exact = unite(bodies, [](const TriangleMesh&) { return true; });
  if (!exact.refusal.empty()) return false;
  m = std::move(exact.mesh);
  return true;
}

bool remesh_intersections(TriangleMesh& m) {
  const QuietCgal quiet;
  try {
    SurfaceMesh surface = to_cgal(m);
    if (!processing::experimental::remove_self_intersections(surface)) return false;
    TriangleMesh remeshed = from_cgal(std::move(surface));
    if (!clean_up(remeshed)) return false;
    m = std::move(remeshed);
    return true;
  } catch (const std::exception&) {  // a failed assertion in CGAL
    return false;
  }
}

}  // namespace tdbd::mesh
