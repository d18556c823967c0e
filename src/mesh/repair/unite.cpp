#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <exception>
#include <utility>

#include "mesh/check/check.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/quiet_cgal.hpp"
#include "mesh/repair/repair.hpp"
#include "mesh/repair/repair_steps.hpp"

namespace tdbd::mesh {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// A solid with exact positions, and the names of the solids in it, for messages.
struct ExactSolid {
  ExactMesh mesh;
  std::string names;
};

ExactMesh exact(const TriangleMesh& m) {
  using Vertex = ExactMesh::Vertex_index;
  ExactMesh surface;
  for (const Vec3& x : m.positions) surface.add_vertex(Kernel::Point_3(x.x(), x.y(), x.z()));
  for (const Triangle& t : m.triangles)
    surface.add_face(Vertex(static_cast<ExactMesh::size_type>(t[0])),
                     Vertex(static_cast<ExactMesh::size_type>(t[1])),
                     Vertex(static_cast<ExactMesh::size_type>(t[2])));
  return surface;
}

TriangleMesh rounded(ExactMesh& surface) {
  surface.collect_garbage();
  TriangleMesh m;
  m.positions.reserve(surface.number_of_vertices());
  const auto number = [](const Kernel::FT& x) { return CGAL::to_double(CGAL::exact(x)); };
  for (const auto v : surface.vertices()) {
    const Kernel::Point_3& p = surface.point(v);
    m.positions.push_back(Vec3(number(p.x()), number(p.y()), number(p.z())));
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

/// Unites neighbours in the list, then their unions: the number of facets in all unions grows with
/// the logarithm of the number of solids. Returns the names of two solids that have no union.
std::string unite_pairwise(std::vector<ExactSolid>& solids) {
  namespace processing = CGAL::Polygon_mesh_processing;
  while (solids.size() > 1) {
    std::vector<ExactSolid> next;
    for (std::size_t i = 0; i < solids.size(); i += 2) {
      if (i + 1 == solids.size()) {
        next.push_back(std::move(solids[i]));
        continue;
      }
      ExactSolid both{{}, solids[i].names + " and " + solids[i + 1].names};
      if (!processing::corefine_and_compute_union(solids[i].mesh, solids[i + 1].mesh, both.mesh))
        return both.names;
      if (both.names.size() > 60) both.names.replace(57, std::string::npos, "...");
      next.push_back(std::move(both));
    }
    solids = std::move(next);
  }
  return "";
}

/// Merges near points until the rounded mesh is sound. Returns nothing on success, or the defects
/// that remain.
std::string make_sound(TriangleMesh& m, const std::function<bool(const TriangleMesh&)>& is_sound) {
  constexpr double distances[] = {0.0, 1e-9, 1e-8, 1e-7, 1e-6};  // m
  std::string defects;
  for (const double distance : distances) {
    TriangleMesh merged = m;
    merge_points(merged, distance);
    drop_duplicates(merged);
    remove_degenerate(merged);
    drop_unused_points(merged);
    const auto left = check_solid(merged);
    if (left.empty() && is_sound(merged)) {
      m = std::move(merged);
      return "";
    }
    defects = left.empty() ? "facets lose their area when they are rounded" : summarize(left);
  }
  return defects;
}

/// Enlarges a solid about the middle of its box, so that no point moves by more than `by` (m).
Solid enlarged(Solid solid, double by) {
  const Box box = bounding_box(solid.mesh);
  const Vec3 middle = 0.5 * (box.lo + box.hi);
  const double factor = 1.0 + by / (0.5 * box.size().norm());
  if (by > 0.0)
    for (Vec3& x : solid.mesh.positions) x = middle + factor * (x - middle);
  return solid;
}

United unite_enlarged(const std::vector<Solid>& solids, double by,
                      const std::function<bool(const TriangleMesh&)>& is_sound) {
  std::vector<ExactSolid> exacts;
  exacts.reserve(solids.size());
  for (const Solid& solid : solids) exacts.push_back({exact(enlarged(solid, by).mesh), solid.name});
  try {
    if (const std::string names = unite_pairwise(exacts); !names.empty())
      return {{}, fmt::format("the union of {} is no manifold", names)};
  } catch (const std::exception& e) {  // a failed assertion in CGAL
    return {{}, fmt::format("no union could be computed: {}", e.what())};
  }
  United united{rounded(exacts.front().mesh), ""};
  united.refusal = make_sound(united.mesh, is_sound);
  return united;
}

}  // namespace

United unite(const std::vector<Solid>& solids,
             const std::function<bool(const TriangleMesh&)>& is_sound) {
  const QuietCgal quiet;
  constexpr double enlargements[] = {0.0, 1e-7, 1e-6};  // m
  for (const Solid& solid : solids)
    if (const auto defects = check_solid(solid.mesh); !defects.empty())
      return {{}, fmt::format("solid {}: {}", solid.name, summarize(defects))};
  United united;
  for (const double by : enlargements) {
    if (solids.empty()) break;
    united = unite_enlarged(solids, by, is_sound);
    if (united.refusal.empty()) break;
  }
  return united;
}

}  // namespace tdbd::mesh
