#include "bit/report/cone_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "bit/cone/tracking.hpp"
#include "bit/report/bit_output.hpp"
#include "core/error.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

struct ConeSummary {
  ConeMass mass;
  double ratio = 0.0;
  ConeAssumptions assumptions;
};

ConeSummary summarize(const Bit& bit, int cone, double bit_speed) {
  const double ratio = rolling_ratio_of_gage_row(bit.cones[static_cast<std::size_t>(cone)]);
  return {cone_mass(bit, cone), ratio, cone_assumptions(bit, cone, bit_speed, ratio)};
}

}  // namespace

void add_assumptions(const Bit& bit, double bit_speed, nlohmann::ordered_json& file) {
  for (int k = 0; k < static_cast<int>(bit.cones.size()); ++k) {
    const auto [mass, ratio, a] = summarize(bit, k, bit_speed);
    file["cones"][static_cast<std::size_t>(k)].update(
        {{"asymmetry", mass.asymmetry},
         {"centre_off_axis_m", mass.centre_off_axis},
         {"assumptions",
          {{"bit_speed_rad_per_s", bit_speed},
           {"cone_ratio", ratio},
           {"unbalance_force_N", a.unbalance_force},
           {"unbalance_share_of_weight", a.unbalance_share},
           {"gravity_torque_N_m", a.gravity_torque},
           {"inertia_modulation_once", a.modulation_once},
           {"inertia_modulation_twice", a.modulation_twice},
           {"cone_frequency_Hz", a.frequency},
           {"momentum_torque_error_N_m", a.torque_error},
           {"momentum_torque_error_over_Ic_speed2", a.torque_share}}}});
  }
}

std::string assumptions_text(const Bit& bit, double bit_speed) {
  std::string text;
  for (int k = 0; k < static_cast<int>(bit.cones.size()); ++k) {
    const ConeAssumptions a = summarize(bit, k, bit_speed).assumptions;
    text += fmt::format(
        "{}: assumptions at {:.3f} rad/s of the bit, {:.3f} Hz of the cone: unbalance {:.3g} N "
        "({:.2g} of the weight), gravity {:.3g} N m, bit's inertia modulated by {:.2g} once and "
        "{:.2g} twice a turn, cone's momentum equation wrong by at most {:.3g} N m\n",
        bit.cones[static_cast<std::size_t>(k)].name, bit_speed, a.frequency, a.unbalance_force,
        a.unbalance_share, a.gravity_torque, a.modulation_once, a.modulation_twice, a.torque_error);
  }
  return text;
}

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

namespace {

using Json = nlohmann::ordered_json;

constexpr int lags = 6;
constexpr int sweep_revolutions = 5;
constexpr double sweep_from = 1.0, sweep_step = 0.005;
constexpr int sweep_points = 161;

/// A row of the bit and its tracking. No prints if its teeth never lose contact with the bottom.
struct RowSummary {
  const Cone* cone = nullptr;
  const ToothRow* row = nullptr;
  int number = 0;  ///< of the row on its cone, from 1
  double speed = 0.0;
  double contact_ratio = 0.0;
  double width = 0.0;  ///< m
  TrackingShare tracking;
};

TrackingOptions options_for(const ConeOperation& o) {
  TrackingOptions options;
  options.penetration = o.penetration;
  options.lags = lags;
  return options;
}

std::vector<RowSummary> summarize(const Bit& bit, const ConeOperation& o) {
  std::vector<RowSummary> figures;
  const std::vector<BitRow> rows = bit_rows(bit, o.penetration);
  const auto shares = tracking(rows, o.cone_speeds, options_for(o));
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t j = 0; j < bit.cones[k].layout.rows.size(); ++j) {
      const ToothRow& row = bit.cones[k].layout.rows[j];
      RowSummary& f = figures.emplace_back();
      f.cone = &bit.cones[k];
      f.row = &row;
      f.number = static_cast<int>(j) + 1;
      f.speed = o.cone_speeds[k];
      f.contact_ratio = tooth_contact_ratio(bit.cones[k], row, o.penetration);
      for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].cone == static_cast<int>(k) && rows[i].row == static_cast<int>(j)) {
          f.width = rows[i].ring.width;
          f.tracking = shares[i];
        }
    }
  return figures;
}

/// The combined share of the rows of one cone, or of all rows.
TrackingShare together(const std::vector<RowSummary>& figures, const Cone* cone) {
  std::vector<TrackingShare> shares;
  for (const RowSummary& f : figures)
    if (cone == nullptr || f.cone == cone) shares.push_back(f.tracking);
  return combined(shares);
}

void add_shares(Json& json, const TrackingShare& t) {
  const bool any = t.prints > 0;
  json["tracking_share"] = any ? Json(t.share.front()) : Json();
  json["tracking_share_random_phase"] = any ? Json(t.random_phase) : Json();
  json["tracking_share_by_lag"] = t.share;
}

Json row_json(const RowSummary& f) {
  Json json{{"prints_per_revolution", f.speed * static_cast<double>(f.row->angles.size())},
            {"print_width_m", f.width},
            {"tooth_contact_ratio", f.contact_ratio}};
  add_shares(json, f.tracking);
  return json;
}

void add_to_cone(const Cone& cone, double speed, const std::vector<RowSummary>& figures,
                 Json& json) {
  json["speed_ratio"] = speed;
  json["rolling_ratio_gage_row"] = rolling_ratio_of_gage_row(cone);
  add_shares(json, together(figures, &cone));
  for (const RowSummary& f : figures)
    if (f.cone == &cone) json["rows"][static_cast<std::size_t>(f.number) - 1].update(row_json(f));
}

/// The shares with all cones at one speed, from 1 to 1.8 times the bit's.
Json sweep_json(const Bit& bit, const ConeOperation& o) {
  const std::vector<BitRow> rows = bit_rows(bit, o.penetration);
  TrackingOptions options = options_for(o);
  options.revolutions = sweep_revolutions;
  options.lags = 1;
  Json ratios = Json::array(), shares = Json::array(), random = Json::array();
  for (int i = 0; i < sweep_points; ++i) {
    const double ratio = sweep_from + sweep_step * i;
    const std::vector<double> speeds(bit.cones.size(), ratio);
    const TrackingShare t = combined(tracking(rows, speeds, options));
    ratios.push_back(ratio);
    shares.push_back(t.share.empty() ? 0.0 : t.share.front());
    random.push_back(t.random_phase);
  }
  return {
      {"speed_ratio", ratios}, {"tracking_share", shares}, {"tracking_share_random_phase", random}};
}

}  // namespace

ConeOperation cone_operation(const Bit& bit, const std::vector<double>& cone_speeds,
                             double penetration) {
  ConeOperation o{cone_speeds, penetration};
  if (o.cone_speeds.empty())
    for (const Cone& cone : bit.cones) o.cone_speeds.push_back(rolling_ratio_of_gage_row(cone));
  if (o.cone_speeds.size() != bit.cones.size())
    throw InputError(
        fmt::format("--cone-speeds: found {} speeds, expected one for each of the {} cones",
                    o.cone_speeds.size(), bit.cones.size()));
  for (const double speed : o.cone_speeds)
    if (!(speed > 0.0 && speed < 100.0))
      throw InputError(fmt::format(
          "--cone-speeds: found {}, expected speeds over the bit's, above 0 and below 100", speed));
  return o;
}

void add_tracking(const Bit& bit, const ConeOperation& o, Json& file) {
  if (bit.cones.empty()) return;
  const std::vector<RowSummary> figures = summarize(bit, o);
  const TrackingOptions options = options_for(o);
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    add_to_cone(bit.cones[k], o.cone_speeds[k], figures, file["cones"][k]);
  Json whole{{"penetration_m", o.penetration},
             {"share_of_width", options.share_of_width},
             {"revolutions", options.revolutions}};
  add_shares(whole, together(figures, nullptr));
  whole["sweep"] = sweep_json(bit, o);
  file["tracking"] = whole;
}

std::string tracking_text(const Bit& bit, const ConeOperation& o) {
  if (bit.cones.empty()) return "";
  const std::vector<RowSummary> figures = summarize(bit, o);
  std::string text =
      fmt::format("{:<8} {:>3} {:>6} {:>7} {:>10} {:>9} {:>10} {:>12}\n", "cone", "row", "speed",
                  "contact", "prints/rev", "width mm", "tracking %", "at random %");
  for (const RowSummary& f : figures) {
    text += fmt::format("{:<8} {:>3} {:>6.3f} {:>7.2f}", f.cone->name, f.number, f.speed,
                        f.contact_ratio);
    if (f.tracking.prints > 0)
      text += fmt::format(" {:>10.1f} {:>9.2f} {:>10.1f} {:>12.1f}",
                          f.speed * static_cast<double>(f.row->angles.size()), 1e3 * f.width,
                          100.0 * f.tracking.share.front(), 100.0 * f.tracking.random_phase);
    text += "\n";
  }
  const TrackingShare all = together(figures, nullptr);
  if (all.prints == 0) return text;
  return text + fmt::format(
                    "all rows: {:.1f} % of the prints fall into one of the last revolution "
                    "(closer than {} of a width), {:.1f} % at random phase\n",
                    100.0 * all.share.front(), options_for(o).share_of_width,
                    100.0 * all.random_phase);
}

}  // namespace tdbd::bit
