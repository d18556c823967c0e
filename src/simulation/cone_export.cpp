#include "simulation/cone_export.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "simulation/cone_file.hpp"

namespace tdbd::simulation {
namespace {

/// The shortest digits that read back to the bit.
std::string list_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) text += fmt::format("{}{}", text.empty() ? "" : ", ", x);
  return "[" + text + "]";
}

std::string shell_text(const std::vector<bit::ShellPoint>& shell) {
  std::string text;
  for (const bit::ShellPoint& p : shell) text += (text.empty() ? "" : ", ") + list_text({p.s, p.r});
  return "[" + text + "]";
}

std::string kind_text(bit::ToothKind kind) {
  for (const auto& [name, named] : tooth_kinds())
    if (named == kind) return name;
  return "unknown";
}

std::string row_text(const bit::ToothRow& row) {
  const bit::ToothShape& t = row.shape;
  return fmt::format(
      "\n[[cones.rows]]\ns = {}\nsink = {}\nlean = {}\ngage = {}\nangles = {}\nkind = \"{}\"\n"
      "diameter = {}\nwidth = {}\nprotrusion = {}\ncrest_length = {}\ncrest_width = {}\n"
      "tip_radius = {}\nhalf_angle = {}\nembedding = {}\ndensity = {}\n",
      row.s, row.sink, row.lean, row.place == bit::RowPlace::gage, list_text(row.angles),
      kind_text(t.kind), t.diameter, t.width, t.protrusion, t.crest_length, t.crest_width,
      t.tip_radius, t.half_angle, t.embedding, t.density);
}

std::string cone_text(const bit::ConeLayout& c) {
  std::string text = fmt::format(
      "\n[[cones]]\nazimuth = {}\njournal_angle = {}\noffset = {}\nskew = {}\napex = {}\n"
      "foot_height = {}\nbody_cuts = {}\ndensity = {}\nshell = {}\n",
      c.azimuth, c.journal_angle, c.offset, c.skew, c.apex, c.foot_height,
      c.body == bit::Cutting::cuts, c.density, shell_text(c.shell));
  for (const bit::ToothRow& row : c.rows) text += row_text(row);
  return text;
}

}  // namespace

std::string cone_bit_text(const bit::Bit& bit) {
  const bit::ConeLayout& first = bit.cones.front().layout;
  std::string text = fmt::format(
      "# A roller cone bit as built, in SI (m, rad, kg/m3).\nname = {}\n"
      "interference = \"report\"\n\n[mesh]\nsegments = {}\nfacets = {}\n",
      nlohmann::json(bit.name).dump(), first.segments, first.facets);
  if (bit.shank.radius > 0.0)
    text += fmt::format("\n[shank]\nradius = {}\nlength = {}\nheight = {}\ndensity = {}\n",
                        bit.shank.radius, bit.shank.length, bit.shank.height, bit.shank.density);
  for (const bit::Cone& cone : bit.cones) text += cone_text(cone.layout);
  return text;
}

}  // namespace tdbd::simulation
