#include "bit/report/tracking_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "bit/cone/cone_rolling.hpp"
#include "bit/cone/tracking.hpp"
#include "core/error.hpp"

namespace tdbd::bit {
namespace {

using Json = nlohmann::ordered_json;

constexpr int lags = 6;
constexpr int sweep_revolutions = 5;
constexpr double sweep_from = 1.0, sweep_step = 0.005;
constexpr int sweep_points = 161;

/// A row of the bit and its tracking. No prints if its teeth never lose contact with the bottom.
struct RowFigures {
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

std::vector<RowFigures> figures_of(const Bit& bit, const ConeOperation& o) {
  std::vector<RowFigures> figures;
  const std::vector<BitRow> rows = bit_rows(bit, o.penetration);
  const auto shares = tracking(rows, o.cone_speeds, options_for(o));
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t j = 0; j < bit.cones[k].layout.rows.size(); ++j) {
      const ToothRow& row = bit.cones[k].layout.rows[j];
      RowFigures& f = figures.emplace_back();
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
TrackingShare together(const std::vector<RowFigures>& figures, const Cone* cone) {
  std::vector<TrackingShare> shares;
  for (const RowFigures& f : figures)
    if (cone == nullptr || f.cone == cone) shares.push_back(f.tracking);
  return combined(shares);
}

void add_shares(Json& json, const TrackingShare& t) {
  const bool any = t.prints > 0;
  json["tracking_share"] = any ? Json(t.share.front()) : Json();
  json["tracking_share_random_phase"] = any ? Json(t.random_phase) : Json();
  json["tracking_share_by_lag"] = t.share;
}

Json row_json(const RowFigures& f) {
  Json json{{"prints_per_revolution", f.speed * static_cast<double>(f.row->angles.size())},
            {"print_width_m", f.width},
            {"tooth_contact_ratio", f.contact_ratio}};
  add_shares(json, f.tracking);
  return json;
}

void add_to_cone(const Cone& cone, double speed, const std::vector<RowFigures>& figures,
                 Json& json) {
  json["speed_ratio"] = speed;
  json["rolling_ratio_gage_row"] = rolling_ratio_of_gage_row(cone);
  add_shares(json, together(figures, &cone));
  for (const RowFigures& f : figures)
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
  const std::vector<RowFigures> figures = figures_of(bit, o);
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
  const std::vector<RowFigures> figures = figures_of(bit, o);
  std::string text =
      fmt::format("{:<8} {:>3} {:>6} {:>7} {:>10} {:>9} {:>10} {:>12}\n", "cone", "row", "speed",
                  "contact", "prints/rev", "width mm", "tracking %", "at random %");
  for (const RowFigures& f : figures) {
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
