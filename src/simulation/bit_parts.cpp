#include "simulation/bit_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "mesh/check.hpp"
#include "mesh/files.hpp"
#include "rotation/rotation_vector.hpp"
#include "simulation/bit_output.hpp"

namespace tdbd::simulation {
namespace {

using bit::PartKind;

std::vector<std::pair<std::string, PartKind>> kinds() {
  std::vector<std::pair<std::string, PartKind>> names;
  for (const PartKind kind :
       {PartKind::face, PartKind::chamfer, PartKind::cse, PartKind::cutter_body, PartKind::gage_pad,
        PartKind::bit_body, PartKind::cone, PartKind::tooth})
    names.emplace_back(kind_name(kind), kind);
  return names;
}

/// Names become paths of files and keys of results.
bool is_part_name(const std::string& name) {
  const auto is_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '/';
  };
  return !name.empty() && name.front() != '/' && name.back() != '/' &&
         name.find("//") == std::string::npos && std::all_of(name.begin(), name.end(), is_word);
}

std::string without_line_breaks(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ';');
  return text;
}

mesh::TriangleMesh read_part_mesh(Config& c) {
  const std::string file = c.path("file", std::nullopt);
  const double unit = c.quantity("unit", "m", 1e-3, Range::positive());
  if (file.empty()) return {};
  const std::string expected = "a closed mesh with outward normals (STL, OBJ, PLY or OFF)";
  try {
    mesh::TriangleMesh m = mesh::read_mesh(file, unit);
    const auto defects = mesh::check_closed(m);
    if (!defects.empty())
      c.problem("file", file + ": " + without_line_breaks(mesh::describe(defects, 3)), expected);
    return m;
  } catch (const InputError& e) {
    c.problem("file", e.what(), expected);
    return {};
  }
}

bool belongs_to_a_cutter(PartKind kind) {
  return kind == PartKind::face || kind == PartKind::chamfer || kind == PartKind::cse ||
         kind == PartKind::cutter_body;
}

/// The direction that follows from kind and frame; none for a cutter whose frame is not known.
std::optional<Vec3> derived_direction(const bit::Part& part, bool has_frame,
                                      bit::DirectionRule directions, bit::InsideRule inside) {
  if (part.kind == PartKind::gage_pad) return Vec3::UnitX();
  if (!belongs_to_a_cutter(part.kind) || part.cutting == bit::Cutting::never) return Vec3::UnitZ();
  if (!has_frame) return std::nullopt;
  return bit::update_direction(part.X_BP, directions, inside);
}

Vec3 read_direction(Config& c, std::optional<Vec3> fallback) {
  const Vec3 u = c.vector("update_direction", "1", fallback);
  if (u.y() == 0.0 && u.norm() > 0.0) return u.normalized();
  c.problem("update_direction", fmt::format("({}, {}, {})", u.x(), u.y(), u.z()),
            "a direction at azimuth 0, (x, 0, z)");
  return Vec3::UnitZ();
}

bit::Part read_part(Config& c, bit::DirectionRule directions, bit::InsideRule inside) {
  bit::Part part;
  part.name = c.text("name", std::nullopt);
  if (c.has("name") && !is_part_name(part.name))
    c.problem("name", '"' + part.name + '"', "letters, digits, - and _, with / between");
  part.kind = c.choice<PartKind>("kind", kinds(), std::nullopt);
  part.mesh_P = read_part_mesh(c);
  part.cutting =
      c.flag("cutting", part.kind != PartKind::bit_body) ? bit::Cutting::cuts : bit::Cutting::never;
  part.density = c.quantity("density", "kg/m3", 0.0, Range::non_negative());
  part.group = static_cast<int>(c.integer("group", -1, -1, std::numeric_limits<int>::max()));
  const bool has_frame = c.has("position") && c.has("rotation_vector");
  part.X_BP.p = c.vector("position", "m", Vec3(Vec3::Zero()));
  part.X_BP.R = rotation::exp(c.vector("rotation_vector", "rad", Vec3(Vec3::Zero())));
  part.update_direction_B =
      read_direction(c, derived_direction(part, has_frame, directions, inside));
  return part;
}

bool agree(const bit::Part& a, const bit::Part& b) {
  return a.X_BP.R == b.X_BP.R && a.X_BP.p == b.X_BP.p &&
         a.update_direction_B == b.update_direction_B;
}

void compare_with_earlier(Config& c, const std::vector<bit::Part>& earlier, const bit::Part& part) {
  for (const bit::Part& other : earlier) {
    if (other.name == part.name)
      c.problem("name", '"' + part.name + "\" a second time", "a name of its own");
    if (part.group >= 0 && other.group == part.group && !agree(other, part))
      c.problem("group", "another frame or update direction than of " + other.name,
                "the same in one group");
  }
}

}  // namespace

std::vector<bit::Part> read_parts(Config& file, bit::DirectionRule directions,
                                  bit::InsideRule inside) {
  std::vector<bit::Part> parts;
  for (Config& c : file.tables("parts")) {
    bit::Part part = read_part(c, directions, inside);
    compare_with_earlier(c, parts, part);
    parts.push_back(std::move(part));
  }
  const bool any_cuts = std::any_of(parts.begin(), parts.end(), [](const bit::Part& part) {
    return part.cutting == bit::Cutting::cuts;
  });
  if (!any_cuts) file.problem("parts", "no part that cuts", "at least one");
  return parts;
}

}  // namespace tdbd::simulation
