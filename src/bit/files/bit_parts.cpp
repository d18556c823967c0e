#include "bit/files/bit_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <string_view>

#include "bit/cutter/cutter.hpp"
#include "bit/files/file_checks.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "core/error.hpp"
#include "core/tolerance.hpp"
#include "core/types.hpp"
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

namespace {

/// Vertices of the face and its chamfers in the cutter's frame.
std::vector<Vec3> front_C(const Pose& X_BC, const std::vector<Part>& parts) {
  std::vector<Vec3> vertices;
  for (const Part& part : parts) {
    if (part.kind != PartKind::face && part.kind != PartKind::chamfer) continue;
    const Pose X_CP = inverse(X_BC) * part.X_BP;
    for (const Vec3& x_P : part.mesh_P.positions) vertices.push_back(X_CP * x_P);
  }
  return vertices;
}

double radius_of(const Vec3& x_C) { return x_C.tail<2>().norm(); }

/// The largest radius of the vertices for which `counts` is true; 0 if there are none.
template <class Counts>
double widest(const std::vector<Vec3>& vertices, const Counts& counts) {
  double radius = 0.0;
  for (const Vec3& x : vertices)
    if (counts(x)) radius = std::max(radius, radius_of(x));
  return radius;
}

/// Sets diameter and chamfer, from the rim of the face in front and the widest rim behind it.
bool take_shape(const std::vector<Vec3>& vertices, Cutter& c) {
  const double rim = widest(vertices, [](const Vec3&) { return true; }),
               slack = 2.0 * rim * tolerance::face_plane;
  if (!(rim > 0.0)) return false;
  double plane = -2.0 * rim;
  for (const Vec3& x : vertices)
    if (radius_of(x) >= rim - slack) plane = std::max(plane, x.x());
  const auto corners = std::ranges::count_if(
      vertices, [&](const Vec3& x) { return std::abs(x.x() - plane) <= slack; });
  c.diameter = 2.0 * rim;
  c.chamfer_angle = 0.5 * right_angle;
  if (-plane > slack) {
    c.chamfer = rim - widest(vertices, [&](const Vec3& x) { return x.x() >= -slack; });
    c.chamfer_angle = std::atan2(c.chamfer, -plane);
  }
  return corners >= 3 && (c.chamfer > 0.0 || -plane <= slack);
}

/// Sets azimuth, height, profile angle and rakes, bit (1).
void set_table_place(Cutter& c) {
  const Vec3 tip = c.X_BC * tip_C(c), x = c.X_BC.R.col(0), z = c.X_BC.R.col(2);
  c.tip_radius = tip.head<2>().norm();
  c.azimuth = std::atan2(tip.y(), tip.x());
  c.tip_height = -tip.z();
  const Vec3 t(-std::sin(c.azimuth), std::cos(c.azimuth), 0.0);
  const Vec3 out(std::cos(c.azimuth), std::sin(c.azimuth), 0.0);
  const double sine = std::clamp(z.dot(t), -1.0, 1.0);
  c.back_rake = std::asin(sine);
  c.profile_angle = std::atan2(-z.dot(out), -z.z());
  const Vec3 n = profile_normal_B(c), x0 = std::cos(c.back_rake) * t + sine * n;
  c.side_rake = std::atan2(x.dot(z.cross(x0)), x.dot(x0));
}

/// How far the parts extend behind the face.
double length_of(const Pose& X_BC, const std::vector<Part>& parts) {
  double length = 0.0;
  for (const Part& part : parts) {
    const Pose X_CP = inverse(X_BC) * part.X_BP;
    for (const Vec3& x_P : part.mesh_P.positions) length = std::max(length, -(X_CP * x_P).x());
  }
  return length;
}

/// The number in a name like "cutter-12/face"; 0 if it has none.
int number_in(std::string_view name) {
  constexpr std::string_view first = "cutter-";
  int number = 0;
  if (!name.starts_with(first)) return 0;
  const auto [end, error] =
      std::from_chars(name.data() + first.size(), name.data() + name.size(), number);
  return error == std::errc{} && end != name.data() + name.size() && *end == '/' ? number : 0;
}

/// The parts of the cutter to which a face belongs; empty if another face belongs to it, too.
std::vector<std::size_t> members_of(const std::vector<Part>& parts, std::size_t face) {
  if (parts[face].group < 0) return {face};
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].group != parts[face].group || !belongs_to_a_cutter(parts[i].kind)) continue;
    if (i != face && parts[i].kind == PartKind::face) return {};
    members.push_back(i);
  }
  return members;
}

void set_labels(const CutterLabels& given, Cutter& c) {
  c.blade = given.blade.value_or(c.blade);
  c.zone = given.zone.value_or(c.zone);
  c.under_exposure = given.under_exposure.value_or(c.under_exposure);
  c.wear = given.wear.value_or(c.wear);
}

void number(std::vector<Cutter>& cutters) {
  std::set<int> used;
  for (const Cutter& c : cutters)
    if (c.id > 0) used.insert(c.id);
  if (used.size() == cutters.size()) return;
  int next = 0;
  for (Cutter& c : cutters) c.id = ++next;
}

}  // namespace

std::optional<Cutter> cutter_from_meshes(Pose X_BC, const std::vector<Part>& parts) {
  Cutter c;
  std::vector<Vec3> vertices = front_C(X_BC, parts);
  if (vertices.empty()) return std::nullopt;
  const double front = std::ranges::max(vertices, {}, [](const Vec3& x) { return x.x(); }).x();
  if (std::abs(front) >
      tolerance::face_plane * 2.0 * widest(vertices, [](const Vec3&) { return true; })) {
    X_BC.p += front * X_BC.R.col(0);
    vertices = front_C(X_BC, parts);
  }
  if (!take_shape(vertices, c)) return std::nullopt;
  c.X_BC = X_BC;
  set_table_place(c);
  if (!(std::cos(c.side_rake) > 0.0)) return std::nullopt;
  c.length = length_of(X_BC, parts);
  c.table_thickness = std::min(c.length, chamfer_depth(c));
  return c;
}

void add_cutters(const PartsFromFiles& read, Bit& bit) {
  for (std::size_t i = 0; i < read.frames.size(); ++i) {
    const Part& face = bit.parts[i];
    if (face.kind != PartKind::face || face.cutting != Cutting::cuts || !read.frames[i]) continue;
    const std::vector<std::size_t> members = members_of(bit.parts, i);
    std::vector<Part> parts;
    parts.reserve(members.size());
    for (const std::size_t k : members) parts.push_back(bit.parts[k]);
    std::optional<Cutter> cutter = cutter_from_meshes(*read.frames[i], parts);
    if (!cutter) continue;
    cutter->id = number_in(face.name);
    if (i < read.labels.size()) set_labels(read.labels[i], *cutter);
    for (const std::size_t k : members) bit.parts[k].cutter = static_cast<int>(bit.cutters.size());
    bit.cutters.push_back(*cutter);
  }
  number(bit.cutters);
  bit.cutter_source = CutterSource::meshes;
}

}  // namespace tdbd::bit
