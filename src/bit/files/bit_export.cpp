#include "bit/files/bit_export.hpp"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "bit/areas/bit_areas.hpp"
#include "bit/bit.hpp"
#include "bit/cone/swept_parts.hpp"
#include "bit/cutter/cutter_table.hpp"
#include "bit/files/cone_file.hpp"
#include "bit/files/solids_file.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "core/config/config.hpp"
#include "core/error.hpp"
#include "io/whole_file.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/files.hpp"
#include "mesh/files/solids.hpp"
#include "mesh/repair/repair.hpp"
#include "rotation/screw.hpp"

namespace tdbd::bit {
namespace {

/// The parts of a cutter are written in its frame, from which their update direction follows.
Part for_export(const Bit& bit, Part part) {
  if (part.cutter < 0) return part;
  const Pose& X_BC = bit.cutters[static_cast<std::size_t>(part.cutter)].X_BC;
  if (X_BC.R == part.X_BP.R && X_BC.p == part.X_BP.p) return part;
  const Pose X_CP = inverse(X_BC) * part.X_BP;
  for (Vec3& x : part.mesh_P.positions) x = X_CP * x;
  part.X_BP = X_BC;
  return part;
}

/// The value of the key `unit`: a quantity, such as "1 mm".
std::string unit_text(const mesh::LengthUnit& unit) {
  const bool has_number = unit.name.find_first_of("0123456789") == 0;
  return toml_string(has_number ? unit.name : "1 " + unit.name);
}

/// What the mesh of a cutter's face does not show (CutterLabels). Empty for any other part.
std::string labels_text(const Bit& bit, const Part& part) {
  if (part.cutter < 0 || part.kind != PartKind::face) return "";
  const Cutter& c = bit.cutters[static_cast<std::size_t>(part.cutter)];
  std::string text = c.blade > 0 ? fmt::format("blade = {}\n", c.blade) : "";
  if (!c.zone.empty()) text += fmt::format("zone = {}\n", toml_string(c.zone));
  if (c.under_exposure > 0.0) text += fmt::format("under_exposure = {}  # m\n", c.under_exposure);
  if (c.wear > 0.0) text += fmt::format("wear = {}  # m\n", c.wear);
  return text;
}

/// The table [body_design] of a body with blades.
std::string body_text_of(const Bit& bit) {
  if (!bit.blades) return "";
  return fmt::format(
      "\n[body_design]\nexposure = {}  # m\nslot_depth = {}  # m\njunk_slot_area = {}  # m2\n",
      bit.blades->exposure, bit.blades->slot_depth, bit.blades->junk_slot_area);
}

std::string part_text(const Bit& bit, const Part& part, const std::string& file,
                      const mesh::LengthUnit& unit) {
  std::string text = fmt::format(
      "\n[[parts]]\nname = {}\nkind = {}\nfile = {}\nunit = {}\ncutting = {}\n{}"
      "density = {}  # kg/m3\ngroup = {}\nposition = {}  # m\nrotation_vector = {}  # rad\n",
      toml_string(part.name), toml_string(kind_name(part.kind)), toml_string(file), unit_text(unit),
      final_cutting(part) == Cutting::cuts,
      final_cutting(part) == Cutting::rubs ? "rubs = true\n" : "", part.density, part.group,
      toml_vector(part.X_BP.p), toml_vector(rotation::log(part.X_BP.R)));
  if (part.cutter < 0)
    text += fmt::format("update_direction = {}\n", toml_vector(part.update_direction_B));
  return text + labels_text(bit, part);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RunError(fmt::format("{}: {}", folder.string(), error.message()));
}

std::string rule_text(const Bit& bit, const Part& part, const std::string& match) {
  std::string text = fmt::format(
      "\n[[solids.rules]]\nmatch = {}\nname = {}\nkind = {}\ncutting = {}\n{}density = {}  # "
      "kg/m3\ngroup = {}\n",
      toml_string(match), toml_string(part.name), toml_string(kind_name(part.kind)),
      final_cutting(part) == Cutting::cuts,
      final_cutting(part) == Cutting::rubs ? "rubs = true\n" : "", part.density, part.group);
  if (part.cutter < 0)
    return text + fmt::format("update_direction = {}\n", toml_vector(part.update_direction_B));
  const Pose& X_BC = bit.cutters[static_cast<std::size_t>(part.cutter)].X_BC;
  return text +
         fmt::format("cutter_position = {}  # m\ncutter_rotation_vector = {}  # rad\n",
                     toml_vector(X_BC.p), toml_vector(rotation::log(X_BC.R))) +
         labels_text(bit, part);
}

/// The parts in the frame of the bit, with their names.
std::vector<mesh::Solid> solids_B(const Bit& bit) {
  std::vector<mesh::Solid> solids;
  solids.reserve(bit.parts.size());
  for (const Part& part : bit.parts) solids.push_back({part.name, mesh_B(part)});
  return solids;
}

}  // namespace

mesh::LengthUnit unit_of_format(const ExportOptions& options, const std::string& format) {
  return format == "ply" ? mesh::LengthUnit{} : options.unit;
}

void export_bit(const std::filesystem::path& folder, const Bit& bit, const ExportOptions& options) {
  const mesh::LengthUnit unit = unit_of_format(options, options.parts);
  std::string toml =
      fmt::format("# A bit as the meshes of its parts.\nname = {}\n", toml_string(bit.name));
  for (const Part& each : bit.parts) {
    const Part part = for_export(bit, each);
    const std::string file = fmt::format("parts/{}.{}", part.name, options.parts);
    make_folder((folder / file).parent_path());
    mesh::write_mesh(folder / file, part.mesh_P, unit);
    toml += part_text(bit, part, file, unit);
  }
  toml += body_text_of(bit) + areas_text(bit);
  if (!bit.cones.empty()) toml = cone_bit_text(bit);
  write_text(folder / "bit.toml", toml);
}

void write_cutter_table(const std::filesystem::path& folder, const Bit& bit) {
  if (bit.cutters.empty() || bit.cutter_source == CutterSource::meshes) return;
  write_text(folder / "cutters.csv", cutter_table_text(bit.name, bit.cutters));
}

void write_profile(const std::filesystem::path& folder, const Bit& bit) {
  constexpr double spacing = 0.25e-3;
  std::string csv = "r_m,z_m\n";
  for (const ProfilePoint& p : exposure_profile(swept_parts(bit), spacing))
    csv += fmt::format("{:.9g},{:.9g}\n", p.r, p.z);
  write_text(folder / "profile.csv", csv);
}

void export_solids(const std::filesystem::path& folder, const Bit& bit,
                   const ExportOptions& options) {
  const std::string& format = options.solids;
  const mesh::LengthUnit unit = unit_of_format(options, format);
  const bool has_names = (format == "stl" && options.stl == mesh::StlKind::text) || format == "obj";
  std::string toml = fmt::format(
      "# A bit whose parts are in one mesh file.\nname = {}\n\n[solids]\nfile = \"bit.{}\"\nunit = "
      "{}\n",
      toml_string(bit.name), format, unit_text(unit));
  std::size_t number = 0;
  for (const Part& part : bit.parts) {
    ++number;
    toml += rule_text(bit, part, has_names ? part.name : fmt::format("solid-{}", number));
  }
  for (const Cone& cone : bit.cones) toml += cone_text_of(cone);
  toml += body_text_of(bit) + areas_text(bit);
  mesh::write_solids(folder / ("bit." + format), solids_B(bit), {unit, options.stl});
  write_text(folder / "solids.toml", toml);
}

mesh::TriangleMesh united_parts(const Bit& bit, const ExportOptions& options) {
  const mesh::LengthUnit unit = unit_of_format(options, options.solids);
  const bool is_single = options.solids == "stl" && options.stl == mesh::StlKind::binary;
  const auto is_sound = [&](const mesh::TriangleMesh& m) {
    return !is_single || mesh::check_solid(mesh::in_single_precision(m, {unit, {}})).empty();
  };
  mesh::United united = mesh::unite(solids_B(bit), is_sound);
  if (united.refusal.empty()) return std::move(united.mesh);
  throw InputError(
      fmt::format("--united: {}: found parts whose union is no sound solid{}, expected one{}: {}",
                  bit.name, is_single ? " in the single precision of binary STL" : "",
                  is_single ? " (without --binary the file has all digits)" : "", united.refusal));
}

void export_united(const std::filesystem::path& folder, const Bit& bit,
                   const mesh::TriangleMesh& united, const ExportOptions& options) {
  mesh::write_solids(folder / ("bit-united." + options.solids), {{bit.name, united}},
                     {unit_of_format(options, options.solids), options.stl});
}

}  // namespace tdbd::bit
