#include "bit/files/cone_export.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bit/files/cone_file.hpp"

namespace tdbd::bit {
namespace {

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

std::string cone_bit_text(const Bit& bit) {
  const ConeLayout& first = bit.cones.front().layout;
  std::string text = fmt::format(
      "# A roller cone bit as built, in SI (m, rad, kg/m3).\nname = {}\n"
      "interference = \"report\"\n\n[mesh]\nsegments = {}\nfacets = {}\n",
      nlohmann::json(bit.name).dump(), first.segments, first.facets);
  if (bit.shank.radius > 0.0)
    text += fmt::format("\n[shank]\nradius = {}\nlength = {}\nheight = {}\ndensity = {}\n",
                        bit.shank.radius, bit.shank.length, bit.shank.height, bit.shank.density);
  for (const Cone& cone : bit.cones) text += cone_text(cone.layout);
  return text;
}

}  // namespace tdbd::bit
