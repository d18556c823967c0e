#include "bit/files/cone_file.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>
#include <vector>

#include "bit/areas/bit_area_keys.hpp"
#include "bit/areas/bit_areas.hpp"
#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_faults.hpp"
#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cone/legs.hpp"
#include "bit/files/cone_keys.hpp"
#include "bit/files/pdc_keys.hpp"
#include "core/config/toml_text.hpp"
#include "core/error.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

using cone_bit_keys::Interference;

ToothShape read_shape(Config& c, ToothShape t) {
  t.kind = c.read(tooth_keys::kind, std::optional(t.kind));
  const auto length = [&](const QuantityKey& key, double& value) { value = c.read(key, value); };
  length(tooth_keys::diameter, t.diameter);
  length(tooth_keys::width, t.width);
  length(tooth_keys::protrusion, t.protrusion);
  length(tooth_keys::crest_length, t.crest_length);
  length(tooth_keys::crest_width, t.crest_width);
  length(tooth_keys::tip_radius, t.tip_radius);
  length(tooth_keys::embedding, t.embedding);
  t.half_angle = c.read(tooth_keys::half_angle, t.half_angle);
  t.density = c.read(tooth_keys::density, t.density);
  return t;
}

/// Reads angles from a list, or from a number of teeth and the pattern of the gaps between them.
std::vector<double> read_angles(Config& c) {
  if (c.has(tooth_row_keys::angles)) return c.read(tooth_row_keys::angles);
  const int teeth = static_cast<int>(c.read(tooth_row_keys::teeth));
  const double first = c.read(tooth_row_keys::first_angle);
  const std::vector<double> spacing = c.read(tooth_row_keys::spacing, std::vector<double>{});
  for (const double ratio : spacing)
    if (!(ratio > 0.0)) {
      c.problem(tooth_row_keys::spacing, fmt::format("{}", ratio), "ratios above 0");
      return {};
    }
  return spaced_angles(teeth, first, spacing);
}

ToothRow read_row(Config& c, const ToothShape& usual) {
  ToothRow row;
  row.s = c.read(tooth_row_keys::s);
  row.sink = c.read(tooth_row_keys::sink);
  row.lean = c.read(tooth_row_keys::lean);
  row.place = c.read(tooth_row_keys::gage) ? RowPlace::gage : RowPlace::inner;
  row.angles = read_angles(c);
  row.shape = read_shape(c, usual);
  return row;
}

void read_journal(Config& c, const QuantityKey& angle, ConeLayout& cone) {
  cone.journal_angle = c.read(angle, cone.journal_angle);
  cone.offset = c.read(journal_keys::offset, cone.offset);
  cone.skew = c.read(journal_keys::skew, cone.skew);
  cone.apex = c.read(journal_keys::apex, cone.apex);
  cone.foot_height = c.read(journal_keys::foot_height, cone.foot_height);
}

void note(std::vector<Config>& rows, Config& cone, const ConeFault& fault) {
  Config& at = fault.row < 0 ? cone : rows[static_cast<std::size_t>(fault.row)];
  at.problem(fault.key, fault.found, fault.expected);
}

/// Reads one cone. Its geometry is checked if all of it could be read.
ConeLayout read_cone(Config& c, ConeLayout cone, const ToothShape& usual) {
  const std::size_t before = c.problem_count();
  cone.azimuth = c.read(bit_cone_keys::azimuth);
  read_journal(c, bit_cone_keys::journal_angle, cone);
  cone.density = c.read(bit_cone_keys::density);
  cone.body = c.read(bit_cone_keys::body_cuts) ? Cutting::cuts : Cutting::never;
  for (const auto& [s, r] : c.read(bit_cone_keys::shell)) cone.shell.push_back({s, r});
  std::vector<Config> rows = c.tables(tooth_row_keys::table);
  for (Config& row : rows) cone.rows.push_back(read_row(row, usual));
  if (c.problem_count() == before)
    for (const ConeFault& fault : cone_faults(cone)) note(rows, c, fault);
  return cone;
}

ConeLayout read_cone_defaults(Config& file) {
  ConeLayout cone;
  Config journal = file.table(journal_keys::table);
  read_journal(journal, journal_keys::angle, cone);
  Config mesh = file.table(cone_mesh_keys::table);
  cone.segments = static_cast<int>(mesh.read(cone_mesh_keys::segments));
  cone.facets = static_cast<int>(mesh.read(cone_mesh_keys::facets));
  if (cone.facets % 4 != 0)
    mesh.problem(cone_mesh_keys::facets, fmt::format("{}", cone.facets), "a multiple of 4");
  return cone;
}

Shank read_shank(Config& c) {
  Shank shank;
  shank.radius = c.read(shank_keys::radius);
  shank.length = c.read(shank_keys::length);
  shank.height = c.read(shank_keys::height);
  shank.density = c.read(shank_keys::density);
  return shank;
}

/// Heights default to those of the shank.
Legs read_legs(Config& c, const Shank& shank) {
  Legs legs;
  legs.width = c.read(leg_keys::width);
  legs.under_gage = c.read(leg_keys::under_gage);
  legs.clearance = c.read(leg_keys::clearance);
  legs.tip_radius = c.read(leg_keys::tip_radius, legs.tip_radius);
  legs.shoulder = c.read(leg_keys::shoulder, shank.height);
  legs.top = c.read(leg_keys::top, shank.height + 0.5 * shank.length);
  legs.density = c.read(leg_keys::density);
  legs.cutting = c.read(leg_keys::rubs) ? Cutting::rubs : Cutting::never;
  legs.inserts = static_cast<int>(c.read(leg_keys::inserts));
  legs.insert_diameter = c.read(leg_keys::insert_diameter);
  legs.insert_length = c.read(leg_keys::insert_length);
  legs.insert_protrusion = c.read(leg_keys::insert_protrusion);
  return legs;
}

/// The tables of a bit file on which its legs depend.
struct LegTables {
  Config legs, shank;
  std::vector<Config>& cones;
};

/// Adds the legs. Faults are recorded at their lines.
void build_legs(LegTables& tables, const Legs& legs, Interference interference, Bit& bit) {
  const std::vector<LegFault> faults = leg_faults(bit, legs);
  for (const LegFault& f : faults) {
    Config& at = f.table == LegTable::legs    ? tables.legs
                 : f.table == LegTable::shank ? tables.shank
                                              : tables.cones[f.cone];
    at.problem(f.key, f.found, f.expected);
  }
  if (!faults.empty()) return;
  add_legs(bit, legs);
  if (interference == Interference::refuse)
    for (const LegClearance& c : leg_clearances(bit))
      if (c.distance < 0.0) tables.legs.problem(leg_keys::clearance, clearance_text(c), "a gap");
}

/// The key of the row of a part "cone-1/row-2/tooth-1" on its cone, or of its shell.
std::string key_of(const std::string& part) {
  const std::size_t at = part.find("/row-");
  if (at == std::string::npos) return "shell";
  return fmt::format("rows[{}]", std::stoi(part.substr(at + 5)) - 1);
}

/// Records every overlap, at the line of that row or shell of the two that is first in the file.
void report_overlaps(const Bit& bit, std::vector<Config>& cones) {
  for (const Clearance& c : cone_clearances(bit.cones))
    for (std::size_t k = 0; k < cones.size(); ++k)
      if (is_clash(c) && c.part_a.starts_with(bit.cones[k].name + "/"))
        cones[k].problem(key_of(c.part_a), clearance_text(c), "a gap");
}

/// Builds the bit. Faults are recorded at their lines.
Bit build(std::vector<ConeLayout> layouts, std::optional<double> gage_radius, const Shank& shank,
          const std::string& name, std::vector<Config>& cones) {
  try {
    return cone_bit(name, std::move(layouts), gage_radius, shank);
  } catch (const ConeBitError& e) {
    cones[e.cone].problem(e.key, e.found, e.expected);
    return {};
  }
}

/// The shortest decimals that read back exactly.
std::string list_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) text += fmt::format("{}{}", text.empty() ? "" : ", ", x);
  return "[" + text + "]";
}

std::string shell_text(const std::vector<ShellPoint>& shell) {
  std::string text;
  for (const ShellPoint& p : shell) text += (text.empty() ? "" : ", ") + list_text({p.s, p.r});
  return "[" + text + "]";
}

std::string kind_text(ToothKind kind) {
  for (const auto& [name, named] : tooth_kinds())
    if (named == kind) return name;
  return "unknown";
}

std::string row_text(const ToothRow& row) {
  const ToothShape& t = row.shape;
  return fmt::format(
      "\n[[cones.rows]]\ns = {}\nsink = {}\nlean = {}\ngage = {}\nangles = {}\nkind = \"{}\"\n"
      "diameter = {}\nwidth = {}\nprotrusion = {}\ncrest_length = {}\ncrest_width = {}\n"
      "tip_radius = {}\nhalf_angle = {}\nembedding = {}\ndensity = {}\n",
      row.s, row.sink, row.lean, row.place == RowPlace::gage, list_text(row.angles),
      kind_text(t.kind), t.diameter, t.width, t.protrusion, t.crest_length, t.crest_width,
      t.tip_radius, t.half_angle, t.embedding, t.density);
}

std::string cone_text(const ConeLayout& c) {
  std::string text = fmt::format(
      "\n[[cones]]\nazimuth = {}\njournal_angle = {}\noffset = {}\nskew = {}\napex = {}\n"
      "foot_height = {}\nbody_cuts = {}\ndensity = {}\nshell = {}\n",
      c.azimuth, c.journal_angle, c.offset, c.skew, c.apex, c.foot_height, c.body == Cutting::cuts,
      c.density, shell_text(c.shell));
  for (const ToothRow& row : c.rows) text += row_text(row);
  return text;
}

std::string legs_text(const Legs& l) {
  const std::string tip = l.tip_radius > 0.0 ? fmt::format("tip_radius = {}\n", l.tip_radius) : "";
  return fmt::format(
      "\n[legs]\nwidth = {}\nunder_gage = {}\nclearance = {}\n{}shoulder = {}\ntop = {}\n"
      "density = {}\nrubs = {}\ninserts = {}\ninsert_diameter = {}\ninsert_length = {}\n"
      "insert_protrusion = {}\n",
      l.width, l.under_gage, l.clearance, tip, l.shoulder, l.top, l.density,
      l.cutting == Cutting::rubs, l.inserts, l.insert_diameter, l.insert_length,
      l.insert_protrusion);
}

}  // namespace

std::vector<std::pair<std::string, ToothKind>> tooth_kinds() {
  std::vector<std::pair<std::string, ToothKind>> kinds;
  for (const auto& named : tooth_keys::kind.values)
    if (!named.name.empty()) kinds.emplace_back(std::string(named.name), named.value);
  return kinds;
}

Bit read_cone_bit(Config& file, const std::string& name) {
  const double gage =
      file.read(bit_file_keys::gage_diameter, std::numeric_limits<double>::infinity());
  const auto interference = file.read(cone_bit_keys::interference);
  const ConeLayout usual_cone = read_cone_defaults(file);
  Config teeth = file.table(tooth_keys::table);
  const ToothShape usual_tooth = read_shape(teeth, {});
  std::vector<Config> cones = file.tables(bit_cone_keys::table);
  std::vector<ConeLayout> layouts;
  layouts.reserve(cones.size());
  for (Config& c : cones) layouts.push_back(read_cone(c, usual_cone, usual_tooth));
  const bool has_legs = file.has(leg_keys::table);
  LegTables tables{file.table(leg_keys::table), file.table(shank_keys::table), cones};
  const Shank shank = read_shank(tables.shank);
  const Legs legs = has_legs ? read_legs(tables.legs, shank) : Legs{};
  file.finish_before(bit_area_keys::areas);
  std::optional<double> gage_radius;
  if (gage < std::numeric_limits<double>::infinity()) gage_radius = 0.5 * gage;
  try {
    Bit bit = build(std::move(layouts), gage_radius, shank, name, cones);
    if (interference == Interference::refuse) report_overlaps(bit, cones);
    if (has_legs && file.problem_count() == 0) build_legs(tables, legs, interference, bit);
    std::vector<std::string> without_density;
    apply_areas(file, bit, without_density);
    file.finish();
    return bit;
  } catch (const InputError& e) {
    if (file.problem_count() > 0) throw;
    throw InputError(fmt::format("{}: {}", file.files().front(), e.what()));
  }
}

std::string cone_bit_text(const Bit& bit) {
  const ConeLayout& first = bit.cones.front().layout;
  std::string text = fmt::format(
      "# A roller cone bit as built, in SI (m, rad, kg/m3).\nname = {}\n"
      "interference = \"report\"\n\n[mesh]\nsegments = {}\nfacets = {}\n",
      toml_string(bit.name), first.segments, first.facets);
  if (bit.shank.radius > 0.0)
    text += fmt::format("\n[shank]\nradius = {}\nlength = {}\nheight = {}\ndensity = {}\n",
                        bit.shank.radius, bit.shank.length, bit.shank.height, bit.shank.density);
  if (bit.legs.width > 0.0) text += legs_text(bit.legs);
  for (const Cone& cone : bit.cones) text += cone_text(cone.layout);
  return text + areas_text(bit);
}

}  // namespace tdbd::bit
