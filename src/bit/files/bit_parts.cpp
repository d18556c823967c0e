#include "bit/files/bit_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "bit/files/file_checks.hpp"
#include "bit/files/mesh_cutters.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "core/error.hpp"
#include "mesh/files/files.hpp"
#include "rotation/screw.hpp"

namespace tdbd::bit {
namespace {

/// If no file is named, only that is reported: a key has at most one problem.
mesh::TriangleMesh read_part_mesh(Config& c, const std::string& name) {
  MeshFile s;
  read_fields(c, s);
  const std::string expected = "a closed mesh with outward normals (STL, OBJ, PLY or OFF)";
  if (contradicts_unit(c, s.file, s.unit)) return {};
  try {
    std::vector<std::string> warnings;
    mesh::TriangleMesh m = mesh::read_mesh(s.file, s.unit, &warnings);
    for (const std::string& w : warnings) c.doubt("file", w);
    report_mesh_faults(c, "file", s.file, {{name, m}}, expected);
    return m;
  } catch (const InputError& e) {
    c.problem("file", e.what(), expected);
    return {};
  }
}

bool has_frame(const Config& c) { return c.has("position") && c.has("rotation_vector"); }

/// A part with its own update direction may have any frame.
std::optional<Pose> frame_of_cutter(const Config& c, const Part& part) {
  if (!belongs_to_a_cutter(part.kind) || !has_frame(c) || c.has("update_direction"))
    return std::nullopt;
  return part.X_BP;
}

/// The direction derived from kind and frame.
Vec3 derived_direction(const Config& c, const Part& part, DirectionRule directions,
                       InsideRule inside) {
  if (part.kind == PartKind::gage_pad) return Vec3::UnitX();
  if (!belongs_to_a_cutter(part.kind) || !has_frame(c)) return Vec3::UnitZ();
  return update_direction(part.X_BP, directions, inside);
}

Part read_part(Config& c, DirectionRule directions, InsideRule inside) {
  PartSettings s;
  read_fields(c, s);
  Part part;
  part.name = s.name;
  if (c.has("name") && !is_part_name(part.name))
    c.problem("name", '"' + part.name + '"', "letters, digits, - and _, with / between");
  part.kind = part_kind_named(s.kind);
  part.mesh_P = read_part_mesh(c, part.name);
  part.cutting = s.cutting ? Cutting::cuts : s.rubs ? Cutting::rubs : Cutting::never;
  part.density = s.density;
  part.group = s.group;
  part.X_BP.p = s.position;
  part.X_BP.R = rotation::exp(s.rotation_vector);
  part.update_direction_B = read_direction(c, derived_direction(c, part, directions, inside));
  return part;
}

bool agree(const PartsFromFiles& read, std::size_t i, std::size_t j) {
  const Part &a = read.parts[i], &b = read.parts[j];
  return a.X_BP.R == b.X_BP.R && a.X_BP.p == b.X_BP.p &&
         a.update_direction_B == b.update_direction_B &&
         read.has_direction[i] == read.has_direction[j];
}

void compare_last_with_earlier(Config& c, const PartsFromFiles& read) {
  const std::size_t last = read.parts.size() - 1;
  const Part& part = read.parts[last];
  for (std::size_t i = 0; i < last; ++i) {
    const Part& other = read.parts[i];
    if (other.name == part.name)
      c.problem("name", '"' + part.name + "\" a second time", "a name of its own");
    if (part.group >= 0 && other.group == part.group && !agree(read, i, last))
      c.problem("group", "another frame or update direction than of " + other.name,
                "the same in one group");
  }
}

/// The parts of a part's group, or the part alone if it has none.
std::vector<Part> group_of(const std::vector<Part>& parts, const Part& part) {
  if (part.group < 0) return {part};
  std::vector<Part> group;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(group),
               [&](const Part& p) { return p.group == part.group; });
  return group;
}

/// If one part has a density, every part must have one, because a missing density would make the
/// mass wrong.
void require_every_density(std::vector<Config>& configs, const PartsFromFiles& read) {
  if (std::ranges::none_of(configs, [](const Config& c) { return c.has("density"); })) return;
  for (std::size_t i = 0; i < configs.size(); ++i)
    if (!configs[i].has("density"))
      configs[i].problem("density", "none for " + read.parts[i].name,
                         "one, as other parts have (0: its volume counts elsewhere)");
}

}  // namespace

PartsFromFiles read_parts(Config& file, DirectionRule directions, InsideRule inside,
                          Densities densities) {
  PartsFromFiles read;
  bool any_cuts = false;
  const bool ask = unit_check_enabled(file);
  double unit = 1.0;
  std::vector<Config> configs = file.tables(PartSettings::table);
  for (Config& c : configs) {
    const Part& part = read.parts.emplace_back(read_part(c, directions, inside));
    read.has_direction.push_back(c.has("update_direction") || has_frame(c) ||
                                 !belongs_to_a_cutter(part.kind));
    read.frames.push_back(frame_of_cutter(c, part));
    read_fields(c, read.labels.emplace_back());
    if (!c.has("density")) read.without_density.push_back(part.name);
    if (!c.has("density") && densities == Densities::required)
      c.problem("density", "none of " + part.name, expected_density);
    MeshFile mesh;
    read_fields(c, mesh);
    unit = mesh.unit;
    if (ask) unit_error(c, "unit", part.mesh_P, unit, part_along);
    any_cuts = any_cuts || part.cutting == Cutting::cuts;
    compare_last_with_earlier(c, read);
  }
  require_every_density(configs, read);
  if (ask) unit_error(file, "parts", read.parts, unit);
  if (!any_cuts) file.problem("parts", "no part that cuts", "at least one");
  return read;
}

void set_profile_directions(PartsFromFiles& read, DirectionRule directions, InsideRule inside) {
  if (std::count(read.has_direction.begin(), read.has_direction.end(), 0) == 0) return;
  constexpr double spacing = 0.5e-3;
  const auto profile = exposure_profile(read.parts, spacing);
  for (std::size_t i = 0; i < read.parts.size(); ++i)
    if (read.has_direction[i] == 0)
      read.parts[i].update_direction_B =
          profile_direction(profile, group_of(read.parts, read.parts[i]), directions, inside);
}

}  // namespace tdbd::bit
