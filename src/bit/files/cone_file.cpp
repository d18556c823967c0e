#include "bit/files/cone_file.hpp"

#include <fmt/format.h>

#include <limits>

#include "bit/areas/bit_areas.hpp"
#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_faults.hpp"
#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cone/legs.hpp"
#include "bit/files/pdc_file.hpp"
#include "core/config/config.hpp"
#include "core/error.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

/// Reads angles from a list, or from a number of teeth and the pattern of the gaps between them.
std::vector<double> angles_of(Config& c, const ToothRowSettings& s) {
  if (c.has("angles")) return s.row.angles;
  for (const double ratio : s.spacing)
    if (!(ratio > 0.0)) {
      c.problem("spacing", fmt::format("{}", ratio), "ratios above 0");
      return {};
    }
  return spaced_angles(static_cast<int>(s.teeth), s.first_angle, s.spacing);
}

ToothRow read_row(Config& c, const ToothShape& usual) {
  ToothRowSettings s;
  read_fields(c, s);
  s.row.angles = angles_of(c, s);
  ToothSettings tooth{usual};
  read_fields(c, tooth);
  s.row.shape = tooth.shape;
  return s.row;
}

void note(std::vector<Config>& rows, Config& cone, const ConeFault& fault) {
  Config& at = fault.row < 0 ? cone : rows[static_cast<std::size_t>(fault.row)];
  at.problem(fault.key, fault.found, fault.expected);
}

/// Reads one cone. Its geometry is checked if all of it could be read.
ConeLayout read_cone(Config& c, ConeLayout cone, const ToothShape& usual) {
  const std::size_t before = c.problem_count();
  ConeSettings s;
  read_fields(c, s);
  ConeJournal journal{{cone}};
  read_fields(c, journal);
  cone = journal.journal.cone;
  cone.azimuth = s.azimuth;
  cone.density = s.density;
  cone.body = s.body_cuts ? Cutting::cuts : Cutting::never;
  for (const auto& [place, radius] : s.shell) cone.shell.push_back({place, radius});
  std::vector<Config> rows = c.tables(ToothRowSettings::table);
  for (Config& row : rows) cone.rows.push_back(read_row(row, usual));
  if (c.problem_count() == before)
    for (const ConeFault& fault : cone_faults(cone)) note(rows, c, fault);
  return cone;
}

ConeLayout read_cone_defaults(Config& file) {
  ConeLayout cone = read_table<JournalSettings>(file).cone;
  const auto mesh = read_table<ConeMeshSettings>(file);
  cone.segments = mesh.segments;
  cone.facets = mesh.facets;
  if (cone.facets % 4 != 0)
    file.table(ConeMeshSettings::table)
        .problem("facets", fmt::format("{}", cone.facets), "a multiple of 4");
  return cone;
}

/// Heights default to those of the shank.
Legs read_legs(Config& file, const Shank& shank) {
  LegSettings s;
  s.legs.shoulder = shank.height;
  s.legs.top = shank.height + 0.5 * shank.length;
  return read_table(file, s).legs;
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
      if (c.distance < 0.0) tables.legs.problem("clearance", clearance_text(c), "a gap");
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
  for (const auto& named : ToothSettings::kinds)
    if (!named.name.empty()) kinds.emplace_back(std::string(named.name), named.value);
  return kinds;
}

Bit read_cone_bit(Config& file, const std::string& name) {
  GageDiameter given{std::numeric_limits<double>::infinity()};
  read_fields(file, given);
  const double gage = given.gage_diameter;
  InterferenceSetting setting;
  read_fields(file, setting);
  const Interference interference = setting.interference;
  const ConeLayout usual_cone = read_cone_defaults(file);
  const ToothShape usual_tooth = read_table<ToothSettings>(file).shape;
  std::vector<Config> cones = file.tables(ConeSettings::table);
  std::vector<ConeLayout> layouts;
  layouts.reserve(cones.size());
  for (Config& c : cones) layouts.push_back(read_cone(c, usual_cone, usual_tooth));
  const bool has_legs = file.has(LegSettings::table);
  const Shank shank = read_table<ShankSettings>(file).shank;
  const Legs legs = has_legs ? read_legs(file, shank) : Legs{};
  LegTables tables{file.table(LegSettings::table), file.table(ShankSettings::table), cones};
  file.finish_before("areas");
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
