#pragma once

#include <CGAL/Surface_mesh.h>

#include <vector>

#include "core/error.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Converts a mesh to CGAL's. Throws RunError if it is not a manifold.
template <class Point>
CGAL::Surface_mesh<Point> surface_mesh_of(const mesh::TriangleMesh& m) {
  using Surface = CGAL::Surface_mesh<Point>;
  using Vertex = typename Surface::Vertex_index;
  Surface surface;
  for (const Vec3& x : m.positions) surface.add_vertex(Point(x[0], x[1], x[2]));
  for (const auto& [a, b, c] : m.triangles)
    if (surface.add_face(Vertex(a), Vertex(b), Vertex(c)) == Surface::null_face())
      throw RunError("CGAL: the mesh is not a manifold");
  return surface;
}

/// Converts CGAL's mesh to a TriangleMesh. `rounded` converts a coordinate to double. Polygons
/// become fans, which is correct if they are convex and planar.
template <class Point, class Rounded>
mesh::TriangleMesh triangle_mesh_of(CGAL::Surface_mesh<Point>& surface, Rounded&& rounded) {
  surface.collect_garbage();
  mesh::TriangleMesh m;
  for (const auto v : surface.vertices()) {
    const Point& x = surface.point(v);
    m.positions.push_back({rounded(x.x()), rounded(x.y()), rounded(x.z())});
  }
  for (const auto f : surface.faces()) {
    std::vector<int> rim;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f)))
      rim.push_back(static_cast<int>(v.idx()));
    for (std::size_t i = 2; i < rim.size(); ++i)
      m.triangles.push_back({rim[0], rim[i - 1], rim[i]});
  }
  return m;
}

}  // namespace tdbd::reference
