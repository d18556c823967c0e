#include "bit/report/area_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bit/areas/area_rules.hpp"
#include "bit/profile/counted_cutters.hpp"

namespace tdbd::bit {
namespace {

using Json = nlohmann::ordered_json;

Json law_json(const PartLaw& law) {
  Json coefficients = Json::object();
  for (const auto& [key, value] : law.coefficients) coefficients[key] = value;
  return {{"name", law.law}, {"coefficients", coefficients}, {"areas", law.areas}};
}

Json areas_json(const Part& part) {
  Json areas = Json::object();
  if (!part.density_area.empty()) areas["density"] = part.density_area;
  if (!part.cutting_area.empty()) areas["cutting"] = part.cutting_area;
  if (!part.share_area.empty()) areas["share"] = part.share_area;
  if (!part.start_area.empty()) areas["start"] = part.start_area;
  return areas;
}

std::string start_key(StartEvent event) {
  if (event == StartEvent::wear) return "from_wear_m";
  return event == StartEvent::depth ? "from_depth_m" : "from_time_s";
}

Json part_json(const Bit& bit, const Part& part) {
  const std::string zone = zone_of(bit, part);
  Json j{{"name", part.name},
         {"kind", kind_name(part.kind)},
         {"zone", zone.empty() ? Json() : Json(zone)}};
  if (part.cutter >= 0) j["blade"] = bit.cutters[static_cast<std::size_t>(part.cutter)].blade;
  if (part.cone >= 0) j["cone"] = part.cone + 1;
  if (part.row >= 0) j["row"] = part.row + 1;
  j["density_kg_m3"] = part.density;
  if (!part.material.empty()) j["material"] = part.material;
  j["cutting"] = cutting_name(cutting_in_the_end(part));
  if (!part.share_area.empty()) j["share"] = part.share;
  if (part.start) j[start_key(part.start->event)] = part.start->from;
  if (part.start && part.start->event == StartEvent::wear) j["worn_names"] = part.start->worn_names;
  j["areas"] = areas_json(part);
  return j;
}

std::string start_text(const Part& part) {
  if (!part.start) return "";
  if (part.start->event == StartEvent::wear)
    return fmt::format("{:g} mm worn", 1e3 * part.start->from);
  return part.start->event == StartEvent::depth ? fmt::format("{:g} m", part.start->from)
                                                : fmt::format("{:g} s", part.start->from);
}

std::string share_text(const Part& part) {
  return cutting_in_the_end(part) == Cutting::cuts ? fmt::format("{:g}", part.share) : "";
}

std::string areas_of(const Part& part) {
  using Given = std::pair<std::string, std::string>;  // property, and area that defines it
  std::string text;
  for (const auto& [what, area] :
       {Given(part.material.empty() ? "density" : part.material, part.density_area),
        Given("cutting", part.cutting_area), Given("share", part.share_area),
        Given("start", part.start_area)})
    if (!area.empty()) text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", what, area);
  return text;
}

}  // namespace

Json properties_json(const Bit& bit, std::span<const PartLaw> laws) {
  Json parts = Json::array();
  for (std::size_t i = 0; i < bit.parts.size(); ++i) {
    parts.push_back(part_json(bit, bit.parts[i]));
    if (!laws.empty()) parts.back()["law"] = law_json(laws[i]);
  }
  return parts;
}

std::string areas_report(const Bit& bit) {
  if (std::ranges::all_of(bit.parts, [](const Part& p) { return areas_of(p).empty(); })) return "";
  std::string text = fmt::format("{:<24} {:>10} {:>9} {:>6} {:>6} {:>12}  {}\n", "part", "zone",
                                 "kg/m3", "cuts", "share", "from", "areas");
  for (const Part& p : bit.parts) {
    text += fmt::format("{:<24} {:>10} {:>9.0f} {:>6} {:>6} {:>12}  {}", p.name, zone_of(bit, p),
                        p.density, cutting_name(cutting_in_the_end(p)), share_text(p),
                        start_text(p), areas_of(p));
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  if (const std::string names = uncounted_names(bit); !names.empty())
    text += fmt::format("the analysis leaves out what does not cut from the start: {}\n", names);
  return text;
}

}  // namespace tdbd::bit
