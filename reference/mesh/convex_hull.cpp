#include "reference/mesh/convex_hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_3.h>

#include "reference/mesh/cgal_surface.hpp"

namespace tdbd::reference {

mesh::TriangleMesh convex_hull(const std::vector<Vec3>& points) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> input;
  for (const Vec3& x : points) input.emplace_back(x[0], x[1], x[2]);
  CGAL::Surface_mesh<Point> hull;
  CGAL::convex_hull_3(input.begin(), input.end(), hull);
  return triangle_mesh_of(hull, [](double x) { return x; });
}

}  // namespace tdbd::reference
