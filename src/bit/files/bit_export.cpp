#include "bit/files/bit_export.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <system_error>

#include "bit/cone/swept_parts.hpp"
#include "bit/cutter/cutter_table_text.hpp"
#include "bit/files/cone_export.hpp"
#include "bit/part_kind.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "core/error.hpp"
#include "core/whole_file.hpp"
#include "mesh/files/files.hpp"
#include "rotation/rotation_vector.hpp"

namespace tdbd::bit {
namespace {

std::string part_text(const Part& part, const std::string& file) {
  std::string text = fmt::format(
      "\n[[parts]]\nname = {}\nkind = {}\nfile = {}\nunit = \"1 m\"\ncutting = {}\n{}"
      "density = {:.17g}  # kg/m3\ngroup = {}\nposition = {}  # m\nrotation_vector = {}  # rad\n",
      quoted(part.name), quoted(kind_name(part.kind)), quoted(file), part.cutting == Cutting::cuts,
      part.cutting == Cutting::rubs ? "rubs = true\n" : "", part.density, part.group,
      vector_text(part.X_BP.p), vector_text(rotation::log(part.X_BP.R)));
  if (part.cutter < 0)
    text += fmt::format("update_direction = {}\n", vector_text(part.update_direction_B));
  return text;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RunError(fmt::format("{}: {}", folder.string(), error.message()));
}

}  // namespace

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string vector_text(const Vec3& v) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x(), v.y(), v.z());
}

void export_bit(const std::filesystem::path& folder, const Bit& bit, const std::string& format) {
  std::string toml =
      fmt::format("# A bit as the meshes of its parts.\nname = {}\n", quoted(bit.name));
  for (const Part& part : bit.parts) {
    const std::string file = fmt::format("parts/{}.{}", part.name, format);
    make_folder((folder / file).parent_path());
    mesh::write_mesh(folder / file, part.mesh_P);
    toml += part_text(part, file);
  }
  if (!bit.cones.empty()) toml = cone_bit_text(bit);
  write_text(folder / "bit.toml", toml);
}

void write_cutter_table(const std::filesystem::path& folder, const Bit& bit) {
  if (bit.cutters.empty()) return;
  write_text(folder / "cutters.csv", cutter_table_text(bit.name, bit.cutters));
}

void write_profile(const std::filesystem::path& folder, const Bit& bit) {
  constexpr double spacing = 0.25e-3;
  std::string csv = "r_m,z_m\n";
  for (const ProfilePoint& p : exposure_profile(swept_parts(bit), spacing))
    csv += fmt::format("{:.9g},{:.9g}\n", p.r, p.z);
  write_text(folder / "profile.csv", csv);
}

}  // namespace tdbd::bit
