#include "bit/report/bit_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "bit/body/body_overlap.hpp"
#include "bit/cutter/rim_reach.hpp"
#include "bit/mass_properties.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "bit/profile/engagement.hpp"
#include "bit/profile/exposure.hpp"
#include "bit/report/assumption_report.hpp"
#include "bit/report/bit_report_parts.hpp"
#include "bit/report/body_report.hpp"
#include "bit/report/overlap_report.hpp"
#include "bit/report/tracking_report.hpp"
#include "core/whole_file.hpp"

namespace tdbd::bit {
namespace {

using Json = nlohmann::ordered_json;

constexpr double column_width = 0.1e-3;  ///< m
constexpr int outline_points = 72;

Json outline_of(const Cutter& c) {
  Json points = Json::array();
  for (const Vec3& p : turned_outline(c, outline_points)) points.push_back({p.x(), p.z()});
  return points;
}

Json cutter_of(const Cutter& c, double overlap, double area, double volume) {
  return {{"name", "cutter-" + std::to_string(c.id)},
          {"blade", c.blade},
          {"zone", c.zone},
          {"tip_radius_m", c.tip_radius},
          {"tip_height_m", c.tip_height},
          {"azimuth_rad", c.azimuth},
          {"profile_angle_rad", c.profile_angle},
          {"back_rake_rad", c.back_rake},
          {"side_rake_rad", c.side_rake},
          {"under_exposure_m", c.under_exposure},
          {"wear_m", c.wear},
          {"overlap_with_next", std::isnan(overlap) ? Json() : Json(overlap)},
          {"area_m2", area},
          {"volume_m3_per_rev", volume},
          {"outline_rz_m", outline_of(c)}};
}

Json inertia_of(const Mat3& inertia) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back({inertia(i, 0), inertia(i, 1), inertia(i, 2)});
  return rows;
}

Json cutters_json(const Bit& bit, const Engagement& e) {
  const std::vector<double> overlap = overlaps(bit.cutters);
  const std::vector<double> exposure = exposures(bit.cutters);
  Json cutters = Json::array();
  for (std::size_t k = 0; k < bit.cutters.size(); ++k) {
    cutters.push_back(cutter_of(bit.cutters[k], overlap[k], e.area[k], e.volume[k]));
    cutters.back()["exposure_m"] = exposure[k];
    add_placing(bit.cutters[k], cutters.back());
  }
  return cutters;
}

}  // namespace

void write_analysis(const std::filesystem::path& folder, const Bit& bit,
                    const ReportOptions& options) {
  const Engagement e = engagement(bit.cutters, options.advance, column_width);
  const MassProperties mass = mass_properties(bit);
  Json file{{"schema", 1},
            {"name", bit.name},
            {"gage_radius_m", bit.gage_radius},
            {"penetration_m_per_rev", options.advance},
            {"imbalance_of_unit_law", imbalance(bit.cutters, e.area)},
            {"imbalance_vector_of_unit_law", vector_json(imbalance_vector(bit.cutters, e.area))},
            {"mean_redundancy", mean_redundancy(e.cutting)},
            {"mass_kg", mass.mass},
            {"centre_m", {mass.centre.x(), mass.centre.y(), mass.centre.z()}},
            {"inertia_kg_m2", inertia_of(mass.inertia)},
            {"column_width_m", e.column_width},
            {"cutters_cutting_at_radius", e.cutting},
            {"cutters", cutters_json(bit, e)},
            {"parts", parts_json(bit)}};
  add_body_profile(bit, file);
  if (!bit.cones.empty()) {
    add_cones(bit, file);
    add_tracking(bit, cone_operation(bit, options.cone_speeds, options.advance), file);
    add_assumptions(bit, options.bit_speed, file);
  }
  file["cutter_overlaps"] = overlaps_json(bit, cutter_overlaps(bit));
  if (!bit.cutters.empty()) file["cutters_in_body_m3"] = cutters_in_body(bit);
  if (bit.blades) file["body"] = body_json(bit, options.advance);
  write_text(folder / "analysis.json", file.dump(1) + "\n");
}

}  // namespace tdbd::bit
