#include "bit/report/cone_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bit/cone/leg_clearance.hpp"
#include "bit/report/bit_output.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

std::string cone_text(const Bit& bit, int index) {
  const Cone& cone = bit.cones[static_cast<std::size_t>(index)];
  const ConeMass m = cone_mass(bit, index);
  std::string text = fmt::format(
      "{}: azimuth {:.2f} deg, journal {:.2f} deg, offset {:.2f} mm, skew {:.2f} deg, apex {:.3f} "
      "mm\n  mass {:.4f} kg, Ic {:.6f} kg m2, asymmetry {:.2e}, centre {:.4f} mm off the axis\n",
      cone.name, cone.layout.azimuth / degree, cone.layout.journal_angle / degree,
      1e3 * cone.layout.offset, cone.layout.skew / degree, 1e3 * cone.layout.apex, m.body_K.mass,
      m.axial_inertia, m.asymmetry, 1e3 * m.centre_off_axis);
  text += fmt::format("  {:>3} {:>6} {:>6} {:>10} {:>9} {:>8} {:>9} {:>8}\n", "row", "teeth",
                      "place", "cone r mm", "bit r mm", "h mm", "reach mm", "rolling");
  int number = 0;
  for (const ToothRow& row : cone.layout.rows) {
    const RowMeasures r = row_measures(cone, row);
    text += fmt::format("  {:>3} {:>6} {:>6} {:>10.3f} {:>9.3f} {:>8.3f} {:>9.3f} {:>8.4f}\n",
                        ++number, row.angles.size(), row.place == RowPlace::gage ? "gage" : "inner",
                        1e3 * r.radius, 1e3 * r.bit_radius, 1e3 * r.height, 1e3 * r.reach,
                        r.rolling_ratio);
  }
  return text;
}

nlohmann::ordered_json rows_json(const Cone& cone) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const ToothRow& row : cone.layout.rows) {
    const RowMeasures r = row_measures(cone, row);
    rows.push_back({{"teeth", row.angles.size()},
                    {"gage", row.place == RowPlace::gage},
                    {"angles_rad", row.angles},
                    {"tip_cone_radius_m", r.radius},
                    {"tip_bit_radius_m", r.bit_radius},
                    {"tip_height_m", r.height},
                    {"reach_m", r.reach},
                    {"rolling_ratio", r.rolling_ratio}});
  }
  return rows;
}

}  // namespace

std::string cones_text(const Bit& bit) {
  std::string text;
  for (int i = 0; i < static_cast<int>(bit.cones.size()); ++i) text += cone_text(bit, i);
  for (const Clearance& c : cone_clearances(bit.cones))
    text += "between cones: " + clearance_text(c) + "\n";
  for (const LegClearance& c : leg_clearances(bit))
    text += "between legs and cones: " + clearance_text(c) + "\n";
  return text;
}

nlohmann::ordered_json cones_json(const Bit& bit) {
  nlohmann::ordered_json cones = nlohmann::ordered_json::array();
  for (int i = 0; i < static_cast<int>(bit.cones.size()); ++i) {
    const Cone& cone = bit.cones[static_cast<std::size_t>(i)];
    const ConeMass m = cone_mass(bit, i);
    const Vec3 z_B = cone.X_BK.R.col(2);
    cones.push_back({{"name", cone.name},
                     {"azimuth_rad", cone.layout.azimuth},
                     {"journal_angle_rad", cone.layout.journal_angle},
                     {"offset_m", cone.layout.offset},
                     {"skew_rad", cone.layout.skew},
                     {"apex_m", cone.layout.apex},
                     {"axis", vector_json(z_B)},
                     {"origin_m", vector_json(cone.X_BK.p)},
                     {"mass_kg", m.body_K.mass},
                     {"axial_inertia_kg_m2", m.axial_inertia},
                     {"asymmetry", m.asymmetry},
                     {"centre_off_axis_m", m.centre_off_axis},
                     {"rows", rows_json(cone)}});
  }
  return cones;
}

}  // namespace tdbd::bit
