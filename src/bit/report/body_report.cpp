#include "bit/report/body_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "bit/areas/area_rules.hpp"
#include "bit/body/bit_body.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "bit/report/bit_output.hpp"

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
  j["cutting"] = cutting_name(final_cutting(part));
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
  return final_cutting(part) == Cutting::cuts ? fmt::format("{:g}", part.share) : "";
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
                        p.density, cutting_name(final_cutting(p)), share_text(p), start_text(p),
                        areas_of(p));
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  if (const std::string names = excluded_cutter_names(bit); !names.empty())
    text += fmt::format("the analysis leaves out what does not cut from the start: {}\n", names);
  return text;
}

namespace {

/// The body of a bit with blades.
const Part& body_of(const Bit& bit) {
  return *std::ranges::find(bit.parts, PartKind::bit_body, &Part::kind);
}

Rubbing body_rubbing(const Bit& bit, double advance) {
  return rubbing(cutters_at(bit, cutting_at_start(bit)), body_of(bit), advance,
                 report_column_width);
}

/// Weight as a function of the depth of cut, for a rock of any strength S. Assumed: a sharp cutter
/// spends S per unit of volume and is pushed by `cutting` times that; what rubs presses with
/// `pressing` times S.
struct WeightCurve {
  static constexpr double cutting = 0.8, pressing = 1.5;
  static constexpr int values = 41;
  double touching = 0.0;                   ///< m per revolution
  std::vector<double> advances;            ///< m per revolution, from 0 to twice that of first
                                           ///< contact
  std::vector<double> area;                ///< m2, of all that rubs, projected along the axis
  std::vector<double> weight;              ///< m2, over S
  double slope = 0.0, slope_beyond = 0.0;  ///< m, before contact, and mean after it
};

WeightCurve weight_curve(const Bit& bit) {
  WeightCurve w;
  w.touching = body_rubbing(bit, 0.0).touching_advance;
  constexpr double usual = 0.1;  // gage radii per revolution, if first contact is unknown
  const bool touches = w.touching > 0.0 && std::isfinite(w.touching);
  const double most = touches ? 2.0 * w.touching : usual * bit.gage_radius;
  for (int k = 0; k < WeightCurve::values; ++k)
    w.advances.push_back(most * k / (WeightCurve::values - 1));
  const std::vector<Cutter> cutting = cutters_at(bit, cutting_at_start(bit));
  w.area.assign(w.advances.size(), 0.0);
  for (const Part& part : bit.parts) {
    if (part.cutting != Cutting::rubs) continue;
    const auto more = rubbing_areas(cutting, part, w.advances, report_column_width);
    std::ranges::transform(w.area, more, w.area.begin(), std::plus{});
  }
  w.slope = WeightCurve::cutting * bit.gage_radius;
  for (std::size_t k = 0; k < w.advances.size(); ++k)
    w.weight.push_back(w.slope * w.advances[k] + WeightCurve::pressing * w.area[k]);
  w.slope_beyond =
      w.slope + WeightCurve::pressing * w.area.back() / (most - (touches ? w.touching : 0.0));
  return w;
}

std::string place_text(const Vec3& x_B) {
  return fmt::format("radius {:.2f} mm, height {:.2f} mm", 1e3 * x_B.head<2>().norm(),
                     -1e3 * x_B.z());
}

}  // namespace

nlohmann::ordered_json body_json(const Bit& bit, double advance) {
  const Rubbing r = body_rubbing(bit, advance), at_rest = body_rubbing(bit, 0.0);
  const Cutting cutting = body_of(bit).cutting;
  const WeightCurve w = weight_curve(bit);
  return {{"exposure_m", bit.blades->exposure},
          {"slot_depth_m", bit.blades->slot_depth},
          {"junk_slot_area_m2", bit.blades->junk_slot_area},
          {"cuts", cutting == Cutting::cuts},
          {"rubs", cutting == Cutting::rubs},
          {"least_axial_clearance_m", r.clearance},
          {"least_axial_clearance_at_m", vector_json(r.clearance_at_B)},
          {"stands_proud_m", std::max(0.0, -at_rest.clearance)},
          {"touches_at_m_per_rev", r.touching_advance},
          {"touches_first_at_m", vector_json(r.touching_at_B)},
          {"points_measured", r.points},
          {"points_over_uncut_rock", r.over_uncut},
          {"weight_over_depth_of_cut",
           {{"cutting_stress_over_strength", WeightCurve::cutting},
            {"pressing_stress_over_strength", WeightCurve::pressing},
            {"slope_m", w.slope},
            {"slope_beyond_touch_m", w.slope_beyond},
            {"depth_of_cut_m_per_rev", w.advances},
            {"rubbing_area_m2", w.area},
            {"weight_over_strength_m2", w.weight}}}};
}

namespace {

/// What the body does at an advance, in a sentence.
std::string rubbing_text(const Rubbing& r, const Rubbing& at_rest, double advance) {
  if (r.points == 0) return "body: no cutter cuts above it, so its clearance is unknown\n";
  if (at_rest.clearance < 0.0)
    return fmt::format(
        "body: stands proud of the cutters by {:.3f} mm at {}: it rubs at any depth of cut\n",
        -1e3 * at_rest.clearance, place_text(at_rest.clearance_at_B));
  if (r.clearance < 0.0)
    return fmt::format(
        "body: rubs at {:.3f} mm per revolution: it is {:.3f} mm deep in the rock at {}\n"
        "  it touches the rock from {:.3f} mm per revolution on ({})\n",
        1e3 * advance, -1e3 * r.clearance, place_text(r.clearance_at_B), 1e3 * r.touching_advance,
        place_text(r.touching_at_B));
  return fmt::format(
      "body: at {:.3f} mm per revolution it clears the rock by {:.3f} mm along the axis ({})\n"
      "  it touches the rock from {:.3f} mm per revolution on ({})\n",
      1e3 * advance, 1e3 * r.clearance, place_text(r.clearance_at_B), 1e3 * r.touching_advance,
      place_text(r.touching_at_B));
}

}  // namespace

std::string body_text(const Bit& bit, double advance) {
  if (!bit.blades) return "";
  const WeightCurve w = weight_curve(bit);
  constexpr double n_per_mm = 1e3;  // per metre, at 1 MPa
  return fmt::format(
      "blades: exposure {:.3f} mm, slots {:.3f} mm deep, junk slot area {:.1f} mm2\n{}"
      "estimated weight on bit: {:.3g} N per mm of depth of cut and MPa of rock strength; {:.3g} N "
      "once the body touches\n",
      1e3 * bit.blades->exposure, 1e3 * bit.blades->slot_depth, 1e6 * bit.blades->junk_slot_area,
      rubbing_text(body_rubbing(bit, advance), body_rubbing(bit, 0.0), advance), n_per_mm * w.slope,
      n_per_mm * w.slope_beyond);
}

}  // namespace tdbd::bit
