#include "bit/files/bit_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "bit/areas/area_rules.hpp"
#include "bit/areas/bit_areas.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/cutter/cutter_table.hpp"
#include "bit/files/bit_parts.hpp"
#include "bit/files/cone_file.hpp"
#include "bit/files/design_settings.hpp"
#include "bit/files/pdc_file.hpp"
#include "bit/files/solids_file.hpp"
#include "bit/pdc/pdc_bit.hpp"
#include "core/config/config.hpp"
#include "core/error.hpp"

namespace tdbd::bit {
namespace {

/// Adds the table's mistakes to those of the bit file.
std::vector<Cutter> read_table(Config& c, const std::string& table,
                               const CutterDefaults& defaults) {
  if (table.empty()) return {};
  try {
    return read_cutter_table(table, defaults);
  } catch (const InputError& e) {
    c.other_file(e.what());
    return {};
  }
}

double reach(const Bit& bit, int cutter) {
  double radius = 0.0;
  for (const Part& part : bit.parts)
    for (const Vec3& x_P : part.mesh_P.positions)
      if (part.cutter == cutter) radius = std::max(radius, (part.X_BP * x_P).head<2>().norm());
  return radius;
}

/// Throws if a cutter reaches beyond the gage given in the bit file. Doubts about the table come
/// first.
void require_cutters_inside_gage(const Bit& bit, double gage_radius, const std::string& file,
                                 const std::vector<BitDoubt>& doubts) {
  constexpr double slack = 5e-5;  // m: rounding of tables and tolerance of bits
  constexpr std::size_t few = 3;
  std::string lines;
  std::size_t count = 0;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i)
    if (const double r = reach(bit, static_cast<int>(i)); r > gage_radius + slack && ++count <= few)
      lines += fmt::format(
          "{}{}:{}: r_tip_mm: found cutter {} reaching {:.3f} mm from the axis, outside the bit, "
          "expected at most half of gage_diameter, {:.3f} mm",
          lines.empty() ? "" : "\n", file, bit.cutters[i].line, bit.cutters[i].id, 1e3 * r,
          1e3 * gage_radius);
  if (count > few) lines += fmt::format("\n... and {} more cutters", count - few);
  if (lines.empty()) return;
  std::string rows;
  for (const BitDoubt& d : doubts) rows += fmt::format("{}: {}\n", d.place, d.text);
  throw InputError(rows + lines);
}

/// In m. A design requires its gage diameter; a table does not.
double read_gage_radius(Config& c, bool designed) {
  GageDiameter s{designed ? 0.0 : std::numeric_limits<double>::infinity()};
  read_fields(c, s);
  return 0.5 * s.gage_diameter;
}

BitFile read_pdc_bit(Config& c, const std::string& name, DirectionRule directions,
                     InsideRule inside) {
  const bool designed = c.has("design");
  CutterTableFile from;
  if (!designed) read_fields(c, from);
  const std::string& table = from.table_file;
  const CutterDefaults defaults = read_table<CutterSettings>(c).cutters;
  PdcOptions options;
  options.meshing = read_table<CutterMeshSettings>(c).mesh;
  options.pads = read_table<PadSettings>(c).pads;
  options.blades = read_blades(c);
  options.directions = directions;
  options.inside = inside;
  const double gage_radius = read_gage_radius(c, designed);
  std::vector<Cutter> cutters =
      designed ? read_design(c.table(DesignSettings::table), gage_radius, defaults)
               : read_table(c, table, defaults);
  std::vector<BitDoubt> doubts;
  if (!designed) {
    doubts = check_table(c, table, cutters);
    check_gage(c, table, cutters, gage_radius, doubts);
  }
  adjust_cutters(c.table(Adjustment::table), cutters);
  check_pads(c, cutters, options.pads, doubts);
  if (options.blades) check_blades(c, cutters, *options.blades, doubts);
  c.finish_before("areas");
  Bit bit = pdc_bit(name, cutters, options);
  require_cutters_inside_gage(bit, gage_radius, designed ? c.files().front() : table, doubts);
  std::vector<std::string> without_density;
  apply_areas(c, bit, without_density);
  c.finish();
  return {std::move(bit), c.files(), c.fingerprint(), {}, std::move(doubts)};
}

/// The design values of a mesh body, which only reports use.
std::optional<BladeDimensions> read_body(Config& file) {
  if (!file.has(BodyDesign::table)) return std::nullopt;
  return read_table<BodyDesign>(file).blades;
}

/// The reports compare the body with what the cutters leave.
void require_body_and_cutters(Config& file, const Bit& bit) {
  if (!bit.blades) return;
  const std::string table(BodyDesign::table.name);
  if (std::ranges::count(bit.parts, PartKind::bit_body, &Part::kind) == 0)
    file.problem(table, "a bit without a part of kind bit-body",
                 "such a part, or no table [body_design]");
  else if (bit.cutters.empty())
    file.problem(table, "a bit without cutters",
                 "faces with the frames of their cutters, or no table [body_design]");
}

BitFile read_mesh_bit(Config& c, const std::string& name, DirectionRule directions,
                      InsideRule inside, Densities densities) {
  Bit bit;
  bit.name = name;
  PartsFromFiles read = c.has("solids") ? read_solid_parts(c, directions, inside, densities)
                                        : read_parts(c, directions, inside, densities);
  bit.blades = read_body(c);
  c.finish_before("areas");
  set_profile_directions(read, directions, inside);
  bit.parts = std::move(read.parts);
  bit.cones = std::move(read.cones);
  add_cutters(read, bit);
  require_body_and_cutters(c, bit);
  bit.gage_radius = largest_turned_radius(bit);
  apply_areas(c, bit, read.without_density);
  c.finish();
  return {std::move(bit), c.files(), c.fingerprint(), std::move(read.without_density)};
}

/// A bit has one source. With a table beside another source, reading continues, because the rest of
/// the file is still meaningful. Combinations of designs, parts and cones are meaningless.
void require_one_source(Config& c) {
  if (c.has("table") && !c.has("cones") && (c.has("parts") || c.has("design"))) {
    c.text("table", std::nullopt);  // read, so that it is not reported as an unknown key, too
    c.problem("table", c.has("parts") ? "parts as well" : "design as well", "one of the two");
  }
  if (c.has("design") && c.has("parts")) {
    c.problem("parts", "design as well", "one of the two");
    c.stop_at_problems();
  }
  if (c.has("cones") && (c.has("parts") || c.has("table") || c.has("design") || c.has("solids"))) {
    c.problem("cones", "parts, solids, a table or a design as well", "one of them");
    c.stop_at_problems();
  }
  if (c.has("solids") && (c.has("parts") || c.has("table") || c.has("design"))) {
    c.problem("solids", "parts, a table or a design as well", "one of them");
    c.stop_at_problems();
  }
}

}  // namespace

std::vector<KeyTable> bit_tables() {
  const std::string command = "bit";
  std::vector<KeyTable> all{
      table_of<NameOfBit, CutterTableFile, TableCheck, GageDiameter, UnitCheck,
               InterferenceSetting>(command, NameOfBit::table),
      table_of<CutterMeshSettings, ConeMeshSettings>(
          command, {"mesh", "the meshes of cutters, or of cones and their teeth"}),
      table_of<ConeSettings, ConeJournal>(command, ConeSettings::table),
      table_of<PartSettings, MeshFile, PartDirection, CutterLabels>(command, PartSettings::table),
      table_of<SolidRuleSettings, PartDirection, CutterLabels>(command, SolidRuleSettings::table),
      table_of<AreaSelector, AreaProperties>(command, AreaProperties::table)};
  for (KeyTable& table :
       tables_of<CutterSettings, PadSettings, Adjustment, BladeSettings, DesignSettings,
                 ProfileSettings, DesignBladeSettings, DiameterByPlace, OverlapByPlace,
                 BackRakeByPlace, SideRakeByPlace, WearByPlace, BackupSettings, GageRowSettings,
                 JournalSettings, ToothSettings, ToothRowSettings, ShankSettings, LegSettings,
                 SolidSettings, SolidConeSettings, BodyDesign>(command))
    all.push_back(std::move(table));
  return all;
}

namespace {

BitFile read_bit_of(Config& c, DirectionRule directions, InsideRule inside, Densities densities) {
  NameOfBit top;
  read_fields(c, top);
  const std::string& name = top.name;
  require_one_source(c);
  if (c.has("cones")) {
    Bit bit = read_cone_bit(c, name);
    return {std::move(bit), c.files(), c.fingerprint()};
  }
  return c.has("parts") || c.has("solids") ? read_mesh_bit(c, name, directions, inside, densities)
                                           : read_pdc_bit(c, name, directions, inside);
}

}  // namespace

BitFile read_bit(const std::string& path, DirectionRule directions, InsideRule inside,
                 Densities densities, const std::vector<std::string>& overrides,
                 const std::string& origin) {
  Config c = Config::read_file(path, overrides, origin);
  BitFile file = read_bit_of(c, directions, inside, densities);
  for (const ConfigDoubt& d : c.doubts()) file.doubts.push_back({d.place, d.key, d.text});
  return file;
}

}  // namespace tdbd::bit
