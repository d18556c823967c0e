#include <pybind11/stl.h>

#include <optional>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "core/units.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/files/length_unit.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/repair/repair.hpp"
#include "python/src/arrays.hpp"
#include "simulation/start/rock_start.hpp"

namespace tdbd::python {
namespace {

using namespace py::literals;

using Positions = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Faces = py::array_t<int, py::array::c_style | py::array::forcecast>;

void require_columns(const py::array& a, const char* name) {
  constexpr py::ssize_t columns = 3;
  if (a.ndim() != 2 || a.shape(1) != columns)
    throw py::value_error(
        fmt::format("{}: found {} dimensions, expected an array (n, 3)", name, a.ndim()));
}

/// A copy of the arrays as a mesh. Throws ValueError if they are no mesh: another shape, a vertex
/// that is not finite, a face with a vertex that does not exist.
mesh::TriangleMesh mesh_of(const Positions& vertices, const Faces& faces) {
  require_columns(vertices, "vertices");
  require_columns(faces, "faces");
  mesh::TriangleMesh m;
  const auto x = vertices.unchecked<2>();
  const auto f = faces.unchecked<2>();
  for (py::ssize_t i = 0; i < x.shape(0); ++i) {
    m.positions.emplace_back(x(i, 0), x(i, 1), x(i, 2));
    if (!m.positions.back().allFinite())
      throw py::value_error(fmt::format("vertices: found vertex {} that is not finite", i));
  }
  for (py::ssize_t i = 0; i < f.shape(0); ++i) {
    m.triangles.push_back({f(i, 0), f(i, 1), f(i, 2)});
    for (const int v : m.triangles.back())
      if (v < 0 || v >= x.shape(0))
        throw py::value_error(fmt::format("faces: found vertex {} in face {}, expected 0 to {}", v,
                                          i, x.shape(0) - 1));
  }
  return m;
}

py::tuple arrays_of(const mesh::TriangleMesh& m) {
  return py::make_tuple(array_of(m.positions), array_of(m.triangles));
}

/// Each body of a file: name, vertices, faces. `unit`: metres per unit of the file; without it, the
/// unit that the file states, otherwise `otherwise`. Points up to `weld` apart are merged before the
/// file is divided.
py::list read_solids(const std::string& path, std::optional<double> unit, double otherwise,
                     double weld) {
  std::vector<mesh::Solid> solids;
  {
    const py::gil_scoped_release released;
    if (const std::string found = unit ? mesh::unit_contradiction(path, *unit) : ""; !found.empty())
      throw InputError("unit: found " + found + ", expected the unit that the file states");
    solids = mesh::read_solids(path, unit ? *unit : mesh::unit_or(path, otherwise), weld);
  }
  py::list all;
  for (const mesh::Solid& s : solids)
    all.append(py::make_tuple(s.name, array_of(s.mesh.positions), array_of(s.mesh.triangles)));
  return all;
}

/// Writes bodies, whose positions are in m, in a unit of `unit` metres.
void write_solids(const std::string& path,
                  const std::vector<std::tuple<std::string, Positions, Faces>>& solids,
                  double unit) {
  std::vector<mesh::Solid> all;
  for (const auto& [name, vertices, faces] : solids)
    all.push_back({name, mesh_of(vertices, faces)});
  const py::gil_scoped_release released;
  mesh::write_solids(path, all, {.unit = mesh::length_unit_of(unit)});
}

/// Statistics of a mesh, and its defects as (kind, place).
std::pair<py::dict, std::vector<std::pair<std::string, std::string>>> inspect(
    const Positions& vertices, const Faces& faces) {
  const mesh::TriangleMesh m = mesh_of(vertices, faces);
  mesh::Inspection i;
  std::vector<std::pair<std::string, std::string>> defects;
  {
    const py::gil_scoped_release released;
    i = mesh::inspect(m);
    for (const mesh::Defect& d : mesh::check_solid(m))
      defects.emplace_back(mesh::name(d.kind), d.where);
  }
  const py::dict numbers(
      "vertices"_a = i.vertices, "faces"_a = i.facets, "pieces"_a = i.pieces,
      "equal_points"_a = i.equal_points, "degenerate"_a = i.degenerate,
      "duplicates"_a = i.duplicates, "open_edges"_a = i.open_edges,
      "flipped_edges"_a = i.flipped_edges, "non_manifold_edges"_a = i.non_manifold_edges,
      "non_manifold_vertices"_a = i.non_manifold_vertices,
      "intersecting_pairs"_a = i.intersecting_pairs, "closed"_a = i.is_closed(),
      "oriented"_a = i.is_oriented(), "manifold"_a = i.is_manifold(), "volume"_a = i.volume,
      "area"_a = i.area, "box"_a = py::make_tuple(array_of(i.box.lo), array_of(i.box.hi)),
      "shortest_edge"_a = i.shortest_edge, "mean_edge"_a = i.mean_edge,
      "longest_edge"_a = i.longest_edge, "worst_quality"_a = i.worst_quality);
  return {numbers, defects};
}

/// The repaired mesh, the steps as (what, count), and why it is not repaired; empty if it is.
py::tuple repair(const Positions& vertices, const Faces& faces, double weld) {
  mesh::TriangleMesh m = mesh_of(vertices, faces);
  mesh::Repaired r;
  {
    const py::gil_scoped_release released;
    r = mesh::repair(std::move(m), {weld});
  }
  std::vector<std::pair<std::string, std::size_t>> steps;
  for (const mesh::RepairStep& s : r.steps) steps.emplace_back(s.what, s.count);
  return py::make_tuple(arrays_of(r.mesh), steps, r.refusal);
}

}  // namespace

void add_meshes(py::module_& m) {
  using py::arg;
  m.def("to_si", &to_si, arg("text"), arg("unit"));
  m.def("read_solids", &read_solids, arg("path"), arg("unit"), arg("otherwise"), arg("weld"));
  m.def("write_solids", &write_solids, arg("path"), arg("solids"), arg("unit"));
  m.def("inspect_mesh", &inspect, arg("vertices"), arg("faces"));
  m.def("repair_mesh", &repair, arg("vertices"), arg("faces"), arg("weld"));
  m.def(
      "is_rock_of_a_run",
      [](const std::string& path) { return simulation::read_stamp(path).has_value(); },
      arg("path"));
}

}  // namespace tdbd::python
