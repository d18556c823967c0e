#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/utility.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <optional>
#include <utility>

#include "mesh/check/check.hpp"
#include "mesh/check/nesting.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair.hpp"
#include "mesh/repair/repair_steps.hpp"

namespace tdbd::mesh {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<ExactKernel::Point_3>;

/// Suppresses the messages that CGAL prints on standard error, which request bug reports. Failed
/// assertions still throw, and TDBD reports them with the place in the mesh. The suppression stays:
/// the handlers are shared by all threads, so none may restore them while another one needs them.
class QuietCgal {
 public:
  QuietCgal() {
    [[maybe_unused]] static const bool done = [] {
      CGAL::set_error_handler(&ignore);
      CGAL::set_warning_handler(&ignore);
      return true;
    }();
  }

 private:
  static void ignore(const char*, const char*, const char*, int, const char*) {}
};

double number(double x) { return x; }
double number(const ExactKernel::FT& x) { return CGAL::to_double(CGAL::exact(x)); }

/// The mesh with positions in doubles or exact ones, as given by `Mesh`.
template <class Mesh>
Mesh to_cgal(const TriangleMesh& m) {
  using Vertex = typename Mesh::Vertex_index;
  using Index = typename Mesh::size_type;
  Mesh surface;
  for (const Vec3& x : m.positions) surface.add_vertex(typename Mesh::Point(x.x(), x.y(), x.z()));
  for (const Triangle& t : m.triangles)
    surface.add_face(Vertex(static_cast<Index>(t[0])), Vertex(static_cast<Index>(t[1])),
                     Vertex(static_cast<Index>(t[2])));
  return surface;
}

/// The mesh with positions rounded to doubles.
template <class Mesh>
TriangleMesh from_cgal(Mesh& surface) {
  surface.collect_garbage();
  TriangleMesh m;
  m.positions.reserve(surface.number_of_vertices());
  for (const auto v : surface.vertices()) {
    const auto& p = surface.point(v);
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

/// A solid with exact positions, and the names of the solids in it, for messages.
struct ExactSolid {
  ExactMesh mesh;
  std::string names;
};

/// Unites neighbours in the list, then their unions: the number of facets in all unions grows with
/// the logarithm of the number of solids. Returns the names of two solids that have no union.
std::string unite_pairwise(std::vector<ExactSolid>& solids) {
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
  for (const Solid& solid : solids)
    exacts.push_back({to_cgal<ExactMesh>(enlarged(solid, by).mesh), solid.name});
  try {
    if (const std::string names = unite_pairwise(exacts); !names.empty())
      return {{}, fmt::format("the union of {} is no manifold", names)};
  } catch (const std::exception& e) {  // a failed assertion in CGAL
    return {{}, fmt::format("no union could be computed: {}", e.what())};
  }
  United united{from_cgal(exacts.front().mesh), ""};
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

namespace {

/// The union of sound bodies in doubles. Nothing if it is no manifold.
std::optional<TriangleMesh> united(const std::vector<Solid>& bodies) {
  SurfaceMesh all = to_cgal<SurfaceMesh>(bodies.front().mesh);
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    SurfaceMesh next = to_cgal<SurfaceMesh>(bodies[i].mesh);
    if (!processing::corefine_and_compute_union(all, next, all)) return std::nullopt;
  }
  return from_cgal(all);
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
  for (const Vec3& x : loop) points.emplace_back(x.x(), x.y(), x.z());
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
    SurfaceMesh surface = to_cgal<SurfaceMesh>(m);
    if (!processing::experimental::remove_self_intersections(surface)) return false;
    TriangleMesh remeshed = from_cgal(surface);
    if (!clean_up(remeshed)) return false;
    m = std::move(remeshed);
    return true;
  } catch (const std::exception&) {  // a failed assertion in CGAL
    return false;
  }
}

}  // namespace tdbd::mesh
