#include "reference/rock/convex_hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace tdbd::reference {

mesh::TriangleMesh convex_hull(const std::vector<Vec3>& points) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> input;
  for (const Vec3& x : points) input.emplace_back(x[0], x[1], x[2]);
  CGAL::Surface_mesh<Point> hull;
  CGAL::convex_hull_3(input.begin(), input.end(), hull);

  mesh::TriangleMesh m;
  for (const auto v : hull.vertices()) {
    const Point& p = hull.point(v);
    m.positions.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : hull.faces()) {  // convex, so a fan will do where CGAL left a polygon
    std::vector<int> rim;
    for (const auto v : hull.vertices_around_face(hull.halfedge(f)))
      rim.push_back(static_cast<int>(v.idx()));
    for (std::size_t i = 2; i < rim.size(); ++i)
      m.triangles.push_back({rim[0], rim[i - 1], rim[i]});
  }
  return m;
}

}  // namespace tdbd::reference
