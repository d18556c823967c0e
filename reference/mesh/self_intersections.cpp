#include "reference/mesh/self_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = SurfaceMesh::Vertex_index;
using Face = SurfaceMesh::Face_index;

/// Converts the mesh to CGAL's type: face i is triangle i.
SurfaceMesh to_cgal(const mesh::TriangleMesh& m) {
  SurfaceMesh surface;
  for (const Vec3& x : m.positions) surface.add_vertex(Kernel::Point_3(x[0], x[1], x[2]));
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const auto& [a, b, c] = m.triangles[i];
    if (surface.add_face(Vertex(a), Vertex(b), Vertex(c)) == SurfaceMesh::null_face())
      throw RunError("self_intersections: triangle " + std::to_string(i) + " breaks the manifold");
  }
  return surface;
}

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const mesh::TriangleMesh& m) {
  const SurfaceMesh surface = to_cgal(m);
  std::vector<std::pair<Face, Face>> faces;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(faces));
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [a, b] : faces)
    pairs.push_back(std::minmax(static_cast<int>(a.idx()), static_cast<int>(b.idx())));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::size_t self_intersecting_pairs(const mesh::TriangleMesh& m) {
  return self_intersections(m).size();
}

}  // namespace tdbd::reference
