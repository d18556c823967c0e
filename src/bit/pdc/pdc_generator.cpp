#include "bit/pdc/pdc_generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "bit/cutter/cutter.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

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
  return azimuth - full_turn * std::floor(azimuth / full_turn);
}

/// The cutter with values that a table can represent, and its pose.
Cutter finished(Cutter c) {
  round_to_table(c);
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
  c.azimuth -= full_turn * std::floor(c.azimuth / full_turn);
  return finished(c);
}

std::string described(const Cutter& c) {
  return fmt::format("cutter {} ({}, blade {}, radius {:.6g} mm)", c.id, c.zone, c.blade,
                     1e3 * c.tip_radius);
}

/// Places a cutter among the others, or returns the cutter with which it collides.
std::optional<Cutter> place(Cutter c, double clearance, std::vector<Cutter>& placed) {
  for (const Cutter& other : placed)
    if (closer_than(c, other, clearance)) return other;
  c.id = static_cast<int>(placed.size()) + 1;
  placed.push_back(std::move(c));
  return {};
}

void place_or_report(Cutter c, const char* key, double clearance, Layout& layout) {
  const std::optional<Cutter> other = place(c, clearance, layout.cutters);
  if (!other) return;
  c.id = static_cast<int>(layout.cutters.size()) + 1;
  layout.problems.push_back({key, described(c) + " overlapping " + described(*other),
                             fmt::format("{:g} mm of clearance", 1e3 * clearance)});
}

/// Places a cutter on the next blade in order, from `next_turn` on, that has space at s.
bool place_on_some_blade(const PdcDesign& d, double s, const std::vector<int>& order,
                         std::size_t& next_turn, Layout& layout) {
  const double r = spot_at(d.profile, s).r;
  std::string ways;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int blade = order[(next_turn + k) % order.size()];
    if (r < d.blades[blade].start) continue;
    const auto other = place(finished(unplaced(d, s, blade)), d.clearance, layout.cutters);
    if (!other) {
      next_turn += k + 1;
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

/// A stretch of the profile on which the spacing varies linearly.
struct Stretch {
  double start, length;  ///< m
  double spacing;        ///< m, at the start
  double slope;          ///< of the spacing

  /// Integral of 1 / spacing over the first x metres.
  double count(double x) const {
    return slope == 0.0 ? x / spacing : std::log1p(slope * x / spacing) / slope;
  }
  /// Inverse of `count`.
  double place(double n) const {
    return start + (slope == 0.0 ? n * spacing : spacing * std::expm1(slope * n) / slope);
  }
};

Stretch stretch(const PdcDesign& d, Region region, double start, double end,
                double overlap_at_end) {
  const double diameter = choice_in(d.diameter, region), length = std::max(0.0, end - start);
  const double first = diameter * (1.0 - law_at(d.overlap, d.profile, start));
  const double last = diameter * (1.0 - overlap_at_end);
  return {start, length, first, length > 0.0 ? (last - first) / length : 0.0};
}

/// Arc lengths (m) of the face cutters' tips, from first_radius to the end of the shoulder, where
/// the gage radius is reached: bit (5), with the number of cutters rounded up to an integer, so
/// that neighbours overlap at least as much as required.
std::vector<double> face_places(const PdcDesign& d) {
  const auto [cone, nose, shoulder, gage] = region_ends(d.profile);
  const double first = d.first_radius / std::cos(d.profile.cone_angle);
  const std::array<Stretch, 3> stretches{
      stretch(d, Region::cone, first, cone, d.overlap.nose),
      stretch(d, Region::nose, cone, nose, d.overlap.shoulder),
      stretch(d, Region::shoulder, nose, shoulder, d.overlap.gage)};
  double total = 0.0;
  for (const Stretch& part : stretches) total += part.count(part.length);
  const int gaps = std::max(1, static_cast<int>(std::ceil(total)));
  std::vector<double> places;
  for (int k = 0; k < gaps; ++k) {
    double n = total * k / gaps;
    std::size_t i = 0;
    for (; i + 1 < stretches.size() && n > stretches[i].count(stretches[i].length); ++i)
      n -= stretches[i].count(stretches[i].length);
    places.push_back(stretches[i].place(n));
  }
  places.push_back(shoulder);
  return places;
}

void place_face(const PdcDesign& d, Layout& layout) {
  const std::vector<int> order = blade_order(static_cast<int>(d.blades.size()));
  std::size_t next_turn = 0;
  for (const double s : face_places(d))
    if (!place_on_some_blade(d, s, order, next_turn, layout)) return;
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
      place_or_report(finished(c), "gage.start", d.clearance, layout);
    }
  }
}

void place_backups(const PdcDesign& d, std::size_t face_count, Layout& layout) {
  for (std::size_t i = 0; i < face_count; ++i) {
    const Cutter face = layout.cutters[i];
    const bool wanted = d.blades[face.blade - 1].backups == Backups::behind_face_cutters;
    if (wanted && face.tip_radius >= d.backups.from && face.tip_radius <= d.backups.to)
      place_or_report(backup_of(face, d.backups), "backup.behind", d.clearance, layout);
  }
}

void require_cutters_on_every_blade(const PdcDesign& d, Layout& layout) {
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

Layout make_layout(const PdcDesign& d) {
  Layout layout{{}, design_problems(d)};
  if (!layout.problems.empty()) return layout;
  place_face(d, layout);
  if (!layout.problems.empty()) return layout;
  require_cutters_on_every_blade(d, layout);
  const std::size_t face_count = layout.cutters.size();
  place_gage(d, layout);
  place_backups(d, face_count, layout);
  return layout;
}

}  // namespace tdbd::bit
