#include "bit/files/bit_export_solids.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "bit/files/bit_export.hpp"
#include "bit/files/solid_cones.hpp"
#include "bit/part_kind.hpp"
#include "core/whole_file.hpp"
#include "mesh/files/solids.hpp"
#include "rotation/rotation_vector.hpp"

namespace tdbd::bit {
namespace {

mesh::Solid solid_of(const Part& part) {
  mesh::Solid solid{part.name, part.mesh_P};
  for (Vec3& x : solid.mesh.positions) x = part.X_BP * x;
  return solid;
}

std::string rule_text(const Part& part, const std::string& match) {
  std::string text = fmt::format(
      "\n[[solids.rules]]\nmatch = {}\nname = {}\nkind = {}\ncutting = {}\ndensity = {:.17g}  # "
      "kg/m3\ngroup = {}\n",
      quoted(match), quoted(part.name), quoted(kind_name(part.kind)), part.cutting == Cutting::cuts,
      part.density, part.group);
  if (part.cutter < 0)
    return text + fmt::format("update_direction = {}\n", vector_text(part.update_direction_B));
  return text + fmt::format("cutter_position = {}  # m\ncutter_rotation_vector = {}  # rad\n",
                            vector_text(part.X_BP.p), vector_text(rotation::log(part.X_BP.R)));
}

}  // namespace

void export_solids(const std::filesystem::path& folder, const Bit& bit, const std::string& format) {
  const bool has_names = format == "stl" || format == "obj";
  std::vector<mesh::Solid> solids;
  solids.reserve(bit.parts.size());
  std::string toml = fmt::format(
      "# A bit whose parts are in one mesh file.\nname = {}\n\n[solids]\nfile = \"bit.{}\"\nunit = "
      "\"1 m\"\n",
      quoted(bit.name), format);
  for (const Part& part : bit.parts) {
    solids.push_back(solid_of(part));
    toml += rule_text(part, has_names ? part.name : fmt::format("solid-{}", solids.size()));
  }
  for (const Cone& cone : bit.cones) toml += cone_text_of(cone);
  mesh::write_solids(folder / ("bit." + format), solids);
  write_text(folder / "solids.toml", toml);
}

}  // namespace tdbd::bit
