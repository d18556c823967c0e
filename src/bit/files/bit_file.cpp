#include "bit/files/bit_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "bit/areas/bit_area_keys.hpp"
#include "bit/areas/bit_areas.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/cutter/cutter_table.hpp"
#include "bit/files/adjust_file.hpp"
#include "bit/files/bit_parts.hpp"
#include "bit/files/blade_file.hpp"
#include "bit/files/cone_file.hpp"
#include "bit/files/design_file.hpp"
#include "bit/files/design_keys.hpp"
#include "bit/files/mesh_cutters.hpp"
#include "bit/files/pdc_keys.hpp"
#include "bit/files/solids_file.hpp"
#include "bit/pdc/pdc_bit.hpp"
#include "core/config/config.hpp"
#include "core/error.hpp"

namespace tdbd::bit {
namespace {

CutterDefaults read_cutter_defaults(Config c) {
  CutterDefaults d;
  d.chamfer = c.read(cutter_keys::chamfer);
  d.chamfer_angle = c.read(cutter_keys::chamfer_angle);
  d.length = c.read(cutter_keys::length);
  d.table_thickness = c.read(cutter_keys::table_thickness);
  d.land = c.read(cutter_keys::land);
  d.land_angle = c.read(cutter_keys::land_angle);
  return d;
}

CutterMeshing read_meshing(Config c) {
  CutterMeshing m;
  m.grading = c.read(cutter_mesh_keys::grading);
  m.rim_segments = static_cast<int>(c.read(cutter_mesh_keys::rim_segments));
  m.uniform_edge = c.read(cutter_mesh_keys::uniform_edge);
  return m;
}

GagePads read_pads(Config c) {
  GagePads p;
  p.count = static_cast<int>(c.read(gage_pad_keys::count));
  p.length = c.read(gage_pad_keys::length);
  p.width = c.read(gage_pad_keys::width);
  p.under_gage = c.read(gage_pad_keys::under_gage);
  p.thickness = c.read(gage_pad_keys::thickness);
  p.behind = c.read(gage_pad_keys::behind);
  return p;
}

/// The gage is that of the outermost tip, as far as it could be read.
void check_pads(Config& file, const std::vector<Cutter>& cutters, const GagePads& pads) {
  if (cutters.empty() || file.problem_count() > 0) return;
  Config c = file.table(gage_pad_keys::table);
  const double gage = std::ranges::max(cutters, {}, &Cutter::tip_radius).tip_radius;
  for (const PadProblem& p : pad_problems(pads, gage)) c.problem(p.key, p.found, p.expected);
}

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

/// Throws if a cutter reaches beyond the gage given in the bit file.
void require_cutters_inside_gage(const Bit& bit, double gage_radius, const std::string& file) {
  constexpr double slack = 5e-5;  // m: rounding of tables and tolerance of bits
  std::string lines;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i)
    if (const double r = reach(bit, static_cast<int>(i)); r > gage_radius + slack)
      lines += fmt::format(
          "{}{}:{}: r_tip_mm: found cutter {} reaching {:.3f} mm from the axis, outside the bit, "
          "expected at most half of gage_diameter, {:.3f} mm",
          lines.empty() ? "" : "\n", file, bit.cutters[i].line, bit.cutters[i].id, 1e3 * r,
          1e3 * gage_radius);
  if (!lines.empty()) throw InputError(lines);
}

/// A design requires its gage diameter; a table does not.
std::optional<double> any_gage(bool designed) {
  if (designed) return {};
  return std::numeric_limits<double>::infinity();
}

BitFile read_pdc_bit(Config& c, const std::string& name, DirectionRule directions,
                     InsideRule inside) {
  const bool designed = c.has("design");
  const std::string table = designed ? "" : c.read(bit_file_keys::cutter_table);
  const CutterDefaults defaults = read_cutter_defaults(c.table(cutter_keys::table));
  PdcOptions options;
  options.meshing = read_meshing(c.table(cutter_mesh_keys::table));
  options.pads = read_pads(c.table(gage_pad_keys::table));
  options.blades = read_blades(c);
  options.directions = directions;
  options.inside = inside;
  const double gage_radius = 0.5 * c.read(bit_file_keys::gage_diameter, any_gage(designed));
  std::vector<Cutter> cutters =
      designed ? read_design(c.table(design_keys::table), gage_radius, defaults)
               : read_table(c, table, defaults);
  adjust_cutters(c.table(adjust_keys::table), cutters);
  check_pads(c, cutters, options.pads);
  if (options.blades) check_blades(c, cutters, *options.blades);
  c.finish_before(bit_area_keys::areas);
  Bit bit = pdc_bit(name, cutters, options);
  require_cutters_inside_gage(bit, gage_radius, designed ? c.files().front() : table);
  std::vector<std::string> without_density;
  apply_areas(c, bit, without_density);
  c.finish();
  return {std::move(bit), c.files(), c.fingerprint()};
}

BitFile read_mesh_bit(Config& c, const std::string& name, DirectionRule directions,
                      InsideRule inside, Densities densities) {
  Bit bit;
  bit.name = name;
  PartsFromFiles read = c.has("solids") ? read_solid_parts(c, directions, inside, densities)
                                        : read_parts(c, directions, inside, densities);
  c.finish_before(bit_area_keys::areas);
  set_profile_directions(read, directions, inside);
  bit.parts = std::move(read.parts);
  bit.cones = std::move(read.cones);
  add_cutters(read, bit);
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

BitFile read_bit(const std::string& path, DirectionRule directions, InsideRule inside,
                 Densities densities, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides, "bit.set");
  const std::string name = c.read(bit_file_keys::name);
  require_one_source(c);
  if (c.has("cones")) {
    Bit bit = read_cone_bit(c, name);
    return {std::move(bit), c.files(), c.fingerprint()};
  }
  return c.has("parts") || c.has("solids") ? read_mesh_bit(c, name, directions, inside, densities)
                                           : read_pdc_bit(c, name, directions, inside);
}

}  // namespace tdbd::bit
