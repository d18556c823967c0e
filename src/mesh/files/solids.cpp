#include "mesh/files/solids.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <map>
#include <utility>

#include "io/whole_file.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/files.hpp"
#include "mesh/measures.hpp"

namespace tdbd::mesh {
namespace {

/// The triangles of each body.
std::vector<std::vector<int>> by_body(const std::vector<int>& body_of_triangle,
                                      std::size_t bodies) {
  std::vector<std::vector<int>> triangles(bodies);
  for (std::size_t i = 0; i < body_of_triangle.size(); ++i)
    triangles[at(body_of_triangle[i])].push_back(static_cast<int>(i));
  return triangles;
}

void write_stl_solid(std::ostream& out, const Solid& solid) {
  std::string text = fmt::format("solid {}\n", solid.name);
  for (const Triangle& t : solid.mesh.triangles) {
    const auto corner = [&](int k) { return solid.mesh.positions[at(t[at(k)])]; };
    const Vec3 n = area_vector(corner(0), corner(1), corner(2)).stableNormalized();
    fmt::format_to(std::back_inserter(text), "facet normal {:.6g} {:.6g} {:.6g}\nouter loop\n",
                   n.x(), n.y(), n.z());
    for (int k = 0; k < 3; ++k) {
      const Vec3 x = corner(k);
      fmt::format_to(std::back_inserter(text), "vertex {} {} {}\n", x.x(), x.y(), x.z());
    }
    text += "endloop\nendfacet\n";
  }
  out << text << fmt::format("endsolid {}\n", solid.name);
}

/// `first` is the number of vertices written before: OBJ counts vertices from 1 over the whole
/// file.
void write_obj_group(std::ostream& out, const Solid& solid, int first) {
  std::string text = fmt::format("g {}\n", solid.name);
  for (const Vec3& x : solid.mesh.positions)
    fmt::format_to(std::back_inserter(text), "v {} {} {}\n", x.x(), x.y(), x.z());
  for (const Triangle& t : solid.mesh.triangles)
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", first + t[0] + 1, first + t[1] + 1,
                   first + t[2] + 1);
  out << text;
}

}  // namespace

std::vector<Solid> read_solids(const std::filesystem::path& path, double unit) {
  const FacetFile file = read_facets(path);
  std::vector<int> body_of_triangle;
  const TriangleMesh all = triangulated(file, path, unit, &body_of_triangle);
  std::vector<Solid> solids;
  if (file.names.empty()) {
    std::vector<TriangleMesh> pieces = divide(all);
    solids.reserve(pieces.size());
    for (TriangleMesh& piece : pieces)
      solids.push_back({fmt::format("solid-{}", solids.size() + 1), std::move(piece)});
    return solids;
  }
  const auto triangles = by_body(body_of_triangle, file.names.size());
  solids.reserve(file.names.size());
  for (std::size_t b = 0; b < file.names.size(); ++b)
    solids.push_back({file.names[b], submesh(all, triangles[b])});
  return solids;
}

TriangleMesh merged(const std::vector<Solid>& solids) {
  TriangleMesh all;
  for (const Solid& solid : solids) {
    const int first = static_cast<int>(all.positions.size());
    all.positions.insert(all.positions.end(), solid.mesh.positions.begin(),
                         solid.mesh.positions.end());
    for (const Triangle& t : solid.mesh.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

void write_solids(const std::filesystem::path& path, const std::vector<Solid>& solids) {
  const std::string extension = lower_extension(path);
  if (extension != ".stl" && extension != ".obj") return write_mesh(path, merged(solids));
  AtomicFile file(path);
  int first = 0;
  for (const Solid& solid : solids) {
    if (extension == ".stl")
      write_stl_solid(file.stream(), solid);
    else
      write_obj_group(file.stream(), solid, first);
    first += static_cast<int>(solid.mesh.positions.size());
  }
  file.commit();
}

void write_in_unit_of(const std::filesystem::path& path, std::vector<Solid> solids,
                      const std::filesystem::path& original, double unit) {
  std::map<std::array<double, 3>, Vec3> in_file;
  for (const Vec3& x : read_facets(original).points) {
    const Vec3 in_m = unit * x;
    in_file.try_emplace({in_m.x(), in_m.y(), in_m.z()}, x);
  }
  for (Solid& solid : solids)
    for (Vec3& x : solid.mesh.positions) {
      const auto known = in_file.find({x.x(), x.y(), x.z()});
      x = known == in_file.end() ? Vec3(x / unit) : known->second;
    }
  write_solids(path, solids);
}

}  // namespace tdbd::mesh
