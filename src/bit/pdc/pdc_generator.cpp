#include "bit/pdc/pdc_generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "bit/cutter/cutter_columns.hpp"
#include "bit/cutter/cutter_frame.hpp"
#include "bit/cutter/cutter_gap.hpp"
#include "bit/pdc/face_places.hpp"

namespace tdbd::bit {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

const char* zone_name(Region region) {
  switch (region) {
    case Region::cone:
      return "cone";
    case Region::nose:
      return "nose";
    case Region::shoulder:
      return "shoulder";
    case Region::gage:
      break;
  }
  return "gage";
}

double azimuth_of(const PdcDesign& d, int blade, double r) {
  const double azimuth = d.blades[blade].azimuth - d.spiral * r / d.profile.gage_radius;
  return azimuth - turn * std::floor(azimuth / turn);
}

/// The cutter with values that the table can hold, and its pose.
Cutter finished(Cutter c) {
  for (const NumberColumn& column : number_columns())
    c.*column.member = c.*column.member / column.unit * column.unit;
  c.X_BC = cutter_pose(c);
  return c;
}

Cutter unplaced(const PdcDesign& d, double s, int blade) {
  const ProfileSpot spot = spot_at(d.profile, s);
  Cutter c;
  c.blade = blade + 1;
  c.zone = zone_name(spot.region);
  c.diameter = choice_in(d.diameter, spot.region);
  c.tip_radius = spot.r;
  c.azimuth = azimuth_of(d, blade, spot.r);
  c.tip_height = spot.h;
  c.profile_angle = spot.angle;
  c.back_rake = law_at(d.back_rake, d.profile, s);
  c.side_rake = law_at(d.side_rake, d.profile, s);
  c.wear = law_at(d.wear, d.profile, s);
  take_shape(c, d.shape);
  return c;
}

Cutter backup_of(const Cutter& face, const BackupRow& row) {
  Cutter c = face;
  c.under_exposure = row.under_exposure;
  c.tip_radius -= row.under_exposure * std::sin(c.profile_angle);
  c.tip_height += row.under_exposure * std::cos(c.profile_angle);
  c.azimuth -= row.behind / c.tip_radius;
  c.azimuth -= turn * std::floor(c.azimuth / turn);
  return finished(c);
}

std::string described(const Cutter& c) {
  return fmt::format("cutter {} ({}, blade {}, radius {:.6g} mm)", c.id, c.zone, c.blade,
                     1e3 * c.tip_radius);
}

/// Puts a cutter among the others; tells which one is in its way otherwise.
std::optional<Cutter> place(Cutter c, double clearance, std::vector<Cutter>& placed) {
  for (const Cutter& other : placed)
    if (closer_than(c, other, clearance)) return other;
  c.id = static_cast<int>(placed.size()) + 1;
  placed.push_back(std::move(c));
  return {};
}

void place_or_complain(Cutter c, const char* key, double clearance, Layout& layout) {
  const std::optional<Cutter> other = place(c, clearance, layout.cutters);
  if (!other) return;
  c.id = static_cast<int>(layout.cutters.size()) + 1;
  layout.problems.push_back({key, described(c) + " overlapping " + described(*other),
                             fmt::format("{:g} mm of clearance", 1e3 * clearance)});
}

/// The next blade in order, after `turn_of`, that has room at s.
bool place_on_some_blade(const PdcDesign& d, double s, const std::vector<int>& order,
                         std::size_t& turn_of, Layout& layout) {
  const double r = spot_at(d.profile, s).r;
  std::string ways;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int blade = order[(turn_of + k) % order.size()];
    if (r < d.blades[blade].start) continue;
    const auto other = place(finished(unplaced(d, s, blade)), d.clearance, layout.cutters);
    if (!other) {
      turn_of += k + 1;
      return true;
    }
    ways += fmt::format("; on blade {} {} is in its way", blade + 1, described(*other));
  }
  layout.problems.push_back({"overlap",
                             fmt::format("no blade with room for cutter {} at radius {:.6g} mm{}",
                                         layout.cutters.size() + 1, 1e3 * r, ways),
                             "less overlap, smaller or shorter cutters, or other blades"});
  return false;
}

void place_face(const PdcDesign& d, Layout& layout) {
  const std::vector<int> order = blade_order(static_cast<int>(d.blades.size()));
  std::size_t turn_of = 0;
  for (const double s : face_places(d))
    if (!place_on_some_blade(d, s, order, turn_of, layout)) return;
}

void place_gage(const PdcDesign& d, Layout& layout) {
  const auto ends = region_ends(d.profile);
  for (int k = 0; k < d.gage.cutters; ++k) {
    const double s = ends[2] + d.diameter.gage * (d.gage.start + k * d.gage.spacing);
    if (s + 0.5 * d.diameter.gage > ends[3]) {
      layout.problems.push_back(
          {"gage.cutters",
           fmt::format("gage cutter {} reaching {:.6g} mm up the gage", k + 1,
                       1e3 * (s - ends[2] + 0.5 * d.diameter.gage)),
           fmt::format("at most the gage's length, {:.6g} mm", 1e3 * d.profile.gage_length)});
      return;
    }
    for (int blade = 0; blade < static_cast<int>(d.blades.size()); ++blade) {
      Cutter c = unplaced(d, s, blade);
      c.zone = zone_name(Region::gage);
      place_or_complain(finished(c), "gage.start", d.clearance, layout);
    }
  }
}

void place_backups(const PdcDesign& d, std::size_t face_count, Layout& layout) {
  for (std::size_t i = 0; i < face_count; ++i) {
    const Cutter face = layout.cutters[i];
    const bool wanted = d.blades[face.blade - 1].backups == Backups::behind_face_cutters;
    if (wanted && face.tip_radius >= d.backups.from && face.tip_radius <= d.backups.to)
      place_or_complain(backup_of(face, d.backups), "backup.behind", d.clearance, layout);
  }
}

void demand_cutters_on_every_blade(const PdcDesign& d, Layout& layout) {
  for (int blade = 0; blade < static_cast<int>(d.blades.size()); ++blade)
    if (std::ranges::count(layout.cutters, blade + 1, &Cutter::blade) == 0)
      layout.problems.push_back({fmt::format("blades[{}]", blade),
                                 fmt::format("blade {} without any cutter", blade + 1),
                                 "fewer blades, more overlap or smaller cutters"});
}

}  // namespace

std::vector<int> blade_order(int n) {
  std::vector<int> order;
  order.reserve(static_cast<std::size_t>(n));
  const int step = n % 2 == 0 ? n / 2 : std::max(1, n / 2);
  for (int k = 0; k < n; ++k) order.push_back(n % 2 == 0 ? k / 2 + k % 2 * step : k * step % n);
  return order;
}

Layout lay_out(const PdcDesign& d) {
  Layout layout{{}, design_problems(d)};
  if (!layout.problems.empty()) return layout;
  place_face(d, layout);
  if (!layout.problems.empty()) return layout;
  demand_cutters_on_every_blade(d, layout);
  const std::size_t face_count = layout.cutters.size();
  place_gage(d, layout);
  place_backups(d, face_count, layout);
  return layout;
}

}  // namespace tdbd::bit
