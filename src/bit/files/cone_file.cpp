#include "bit/files/cone_file.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>
#include <vector>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_faults.hpp"
#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_parts.hpp"
#include "core/angles.hpp"
#include "core/config/toml_text.hpp"
#include "core/error.hpp"

namespace tdbd::bit {
namespace {

enum class Interference { refuse, report };

ToothShape read_shape(Config& c, ToothShape t) {
  t.kind = c.choice<ToothKind>("kind", tooth_kinds(), t.kind);
  const auto length = [&](const char* key, double& value) {
    value = c.quantity(key, "m", value, Range::positive());
  };
  length("diameter", t.diameter);
  length("width", t.width);
  length("protrusion", t.protrusion);
  length("crest_length", t.crest_length);
  length("crest_width", t.crest_width);
  length("tip_radius", t.tip_radius);
  length("embedding", t.embedding);
  t.half_angle = c.quantity("half_angle", "rad", t.half_angle, Range::within(0.05, 1.5));
  t.density = c.quantity("density", "kg/m3", t.density, Range::non_negative());
  return t;
}

/// Angles from a list, or from a number of teeth and the pattern of the gaps between them.
std::vector<double> read_angles(Config& c) {
  if (c.has("angles")) return c.list("angles", "rad", std::nullopt);
  const int teeth = static_cast<int>(c.integer("teeth", std::nullopt, 1, 1000));
  const double first = c.quantity("first_angle", "rad", 0.0);
  const std::vector<double> spacing = c.list("spacing", "1", std::vector<double>{});
  for (const double ratio : spacing)
    if (!(ratio > 0.0)) {
      c.problem("spacing", fmt::format("{}", ratio), "ratios above 0");
      return {};
    }
  return spaced_angles(teeth, first, spacing);
}

ToothRow read_row(Config& c, const ToothShape& usual) {
  ToothRow row;
  row.s = c.quantity("s", "m", std::nullopt);
  row.sink = c.quantity("sink", "m", 0.0);
  row.lean = c.quantity("lean", "rad", 0.0, Range::within(-right_angle, right_angle));
  row.place = c.flag("gage", false) ? RowPlace::gage : RowPlace::inner;
  row.angles = read_angles(c);
  row.shape = read_shape(c, usual);
  return row;
}

void read_journal(Config& c, const char* angle, ConeLayout& cone) {
  cone.journal_angle =
      c.quantity(angle, "rad", cone.journal_angle, Range::within(0.0, right_angle));
  cone.offset = c.quantity("offset", "m", cone.offset);
  cone.skew = c.quantity("skew", "rad", cone.skew, Range::within(-right_angle, right_angle));
  cone.apex = c.quantity("apex", "m", cone.apex);
  cone.foot_height = c.quantity("foot_height", "m", cone.foot_height);
}

void note(std::vector<Config>& rows, Config& cone, const ConeFault& fault) {
  Config& at = fault.row < 0 ? cone : rows[static_cast<std::size_t>(fault.row)];
  at.problem(fault.key, fault.found, fault.expected);
}

/// One cone; its geometry is checked if everything about it could be read.
ConeLayout read_cone(Config& c, ConeLayout cone, const ToothShape& usual) {
  const std::size_t before = c.problem_count();
  cone.azimuth = c.quantity("azimuth", "rad", std::nullopt);
  read_journal(c, "journal_angle", cone);
  cone.density = c.quantity("density", "kg/m3", cone.density, Range::non_negative());
  cone.body = c.flag("body_cuts", false) ? Cutting::cuts : Cutting::never;
  for (const auto& [s, r] : c.pairs("shell", "m", std::nullopt)) cone.shell.push_back({s, r});
  std::vector<Config> rows = c.tables("rows");
  for (Config& row : rows) cone.rows.push_back(read_row(row, usual));
  if (c.problem_count() == before)
    for (const ConeFault& fault : cone_faults(cone)) note(rows, c, fault);
  return cone;
}

ConeLayout read_cone_defaults(Config& file) {
  ConeLayout cone;
  Config journal = file.table("journal");
  read_journal(journal, "angle", cone);
  Config mesh = file.table("mesh");
  cone.segments = static_cast<int>(mesh.integer("segments", cone.segments, 8, 4096));
  cone.facets = static_cast<int>(mesh.integer("facets", cone.facets, 8, 128));
  if (cone.facets % 4 != 0)
    mesh.problem("facets", fmt::format("{}", cone.facets), "a multiple of 4");
  return cone;
}

Shank read_shank(Config c) {
  Shank shank;
  shank.radius = c.quantity("radius", "m", 0.0, Range::non_negative());
  shank.length = c.quantity("length", "m", 0.1, Range::positive());
  shank.height = c.quantity("height", "m", 0.1);
  shank.density = c.quantity("density", "kg/m3", shank.density, Range::non_negative());
  return shank;
}

/// Row of a part "cone-1/row-2/tooth-1" on its cone, or the key of its shell.
std::string key_of(const std::string& part) {
  const std::size_t at = part.find("/row-");
  if (at == std::string::npos) return "shell";
  return fmt::format("rows[{}]", std::stoi(part.substr(at + 5)) - 1);
}

/// Notes every overlap, at the line of whichever of the two rows or shells comes first in the file.
void note_overlaps(const Bit& bit, std::vector<Config>& cones) {
  for (const Clearance& c : cone_clearances(bit.cones))
    for (std::size_t k = 0; k < cones.size(); ++k)
      if (c.distance < 0.0 && c.part_a.starts_with(bit.cones[k].name + "/"))
        cones[k].problem(key_of(c.part_a), clearance_text(c), "a gap");
}

/// Builds the bit; whatever prevents it is noted at its line.
Bit build(std::vector<ConeLayout> layouts, std::optional<double> gage_radius, const Shank& shank,
          const std::string& name, std::vector<Config>& cones) {
  try {
    return cone_bit(name, std::move(layouts), gage_radius, shank);
  } catch (const ConeBitError& e) {
    cones[e.cone].problem(e.key, e.found, e.expected);
    return {};
  }
}

/// The shortest digits that read back to the bit.
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

}  // namespace

std::vector<std::pair<std::string, ToothKind>> tooth_kinds() {
  return {{"milled-chisel", ToothKind::milled_chisel},
          {"hemispherical", ToothKind::hemispherical},
          {"conical", ToothKind::conical},
          {"chisel", ToothKind::chisel}};
}

Bit read_cone_bit(Config& file, const std::string& name) {
  const double gage = file.quantity("gage_diameter", "m", std::numeric_limits<double>::infinity(),
                                    Range::positive());
  const auto interference = file.choice<Interference>(
      "interference", {{"refuse", Interference::refuse}, {"report", Interference::report}},
      Interference::refuse);
  const ConeLayout usual_cone = read_cone_defaults(file);
  Config teeth = file.table("teeth");
  const ToothShape usual_tooth = read_shape(teeth, {});
  std::vector<Config> cones = file.tables("cones");
  std::vector<ConeLayout> layouts;
  layouts.reserve(cones.size());
  for (Config& c : cones) layouts.push_back(read_cone(c, usual_cone, usual_tooth));
  const Shank shank = read_shank(file.table("shank"));
  file.finish();
  std::optional<double> gage_radius;
  if (gage < std::numeric_limits<double>::infinity()) gage_radius = 0.5 * gage;
  try {
    Bit bit = build(std::move(layouts), gage_radius, shank, name, cones);
    if (interference == Interference::refuse) note_overlaps(bit, cones);
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
  for (const Cone& cone : bit.cones) text += cone_text(cone.layout);
  return text;
}

}  // namespace tdbd::bit
