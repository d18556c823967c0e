#include "bit/files/pdc_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "bit/body/blade_body.hpp"
#include "bit/files/design_settings.hpp"
#include "bit/pdc/pdc_generator.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

/// The angle at which the shoulder's arc begins: given, or computed from the arc's radius.
double shoulder_angle_of(Config& c, const ProfileSettings& s) {
  const ProfileDesign& p = s.profile;
  if (!c.has("shoulder_radius")) return p.shoulder_angle;
  if (c.has("shoulder_angle"))
    c.problem("shoulder_angle", "shoulder_radius as well", "one of the two");
  const double angle = shoulder_angle_for(p, s.shoulder_radius);
  if (angle >= 0.0) return angle;
  const double left = p.gage_radius - p.nose_place;
  c.problem("shoulder_radius",
            fmt::format("{:.6g} mm, no arc between nose and gage", 1e3 * s.shoulder_radius),
            fmt::format("at {} {:.6g} mm, what nose_place leaves to the gage",
                        p.nose_radius < left ? "least" : "most", 1e3 * left));
  return 0.0;
}

ProfileDesign read_profile(Config& design, double gage_radius) {
  ProfileSettings s;
  s.profile.gage_radius = gage_radius;
  s = read_table(design, s);
  Config c = design.table(ProfileSettings::table);
  s.profile.shoulder_angle = shoulder_angle_of(c, s);
  return s.profile;
}

template <class Settings>
RegionLaw read_law(Config& design) {
  const auto s = read_table<Settings>(design);
  return {s.first, s.nose, s.shoulder, s.gage};
}

std::vector<BladeDesign> read_blade_designs(Config& design) {
  std::vector<BladeDesign> blades;
  for (Config& table : design.tables(DesignBladeSettings::table)) {
    DesignBladeSettings s;
    read_fields(table, s);
    blades.push_back(s.blade);
  }
  return blades;
}

void add(const Adjustment& a, Cutter& c) {
  c.azimuth += a.azimuth;
  c.back_rake += a.back_rake;
  c.side_rake += a.side_rake;
  c.tip_radius += a.along * std::cos(c.profile_angle);
  c.tip_height += a.along * std::sin(c.profile_angle);
}

/// Adjusts the cutters whose number is the name of a table: [adjust.blade.2].
void adjust_some(Config c, int Cutter::*number, const char* what, std::vector<Cutter>& cutters) {
  for (const std::string& name : c.given()) {
    Config table = c.table(name);
    Adjustment a;
    read_fields(table, a);
    int wanted = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), wanted);
    long found = 0;
    for (Cutter& cutter : cutters)
      if (error == std::errc() && end == name.data() + name.size() && cutter.*number == wanted) {
        add(a, cutter);
        ++found;
      }
    const std::vector<std::string> given = table.given();
    if (found == 0 && !cutters.empty())
      table.problem(given.empty() ? "" : given.front(), "a table of " + name,
                    fmt::format("the number of a {}", what));
  }
}

/// Records values that a cutter table would not allow either.
void check_adjusted(Config& c, const Cutter& cutter) {
  const auto refuse = [&](const char* key, double found, const char* unit, const char* expected) {
    c.problem(key, fmt::format("{:.4g} {} of cutter {} in the end", found, unit, cutter.id),
              expected);
  };
  const double back = cutter.back_rake / degree, side = cutter.side_rake / degree;
  if (back < -5.0 || back > 60.0) refuse("back_rake", back, "deg", "an angle in -5..60");
  if (std::abs(side) > 45.0) refuse("side_rake", side, "deg", "an angle in -45..45");
  if (cutter.tip_radius < 0.0)
    refuse("along", 1e3 * cutter.tip_radius, "mm from the axis", "a radius >= 0");
}

}  // namespace

std::vector<Cutter> read_design(Config c, double gage_radius, const CutterDefaults& shape) {
  DesignSettings s;
  read_fields(c, s);
  PdcDesign d;
  d.shape = shape;
  d.profile = read_profile(c, gage_radius);
  d.blades = read_blade_designs(c);
  d.first_radius = s.first_radius;
  d.spiral = s.spiral;
  d.clearance = s.clearance;
  const auto diameter = read_table<DiameterByPlace>(c);
  d.diameter = {diameter.first, diameter.nose, diameter.shoulder, diameter.gage};
  d.overlap = read_law<OverlapByPlace>(c);
  d.back_rake = read_law<BackRakeByPlace>(c);
  d.side_rake = read_law<SideRakeByPlace>(c);
  d.wear = read_law<WearByPlace>(c);
  d.backups = read_table<BackupSettings>(c).row;
  d.gage = read_table<GageRowSettings>(c).row;
  if (c.problem_count() > 0) return {};
  const Layout layout = make_layout(d);
  for (const DesignProblem& p : layout.problems) c.problem(p.key, p.found, p.expected);
  return layout.problems.empty() ? layout.cutters : std::vector<Cutter>{};
}

std::optional<BladeOptions> read_blades(Config& file) {
  if (!file.has(BladeSettings::table)) return {};
  return read_table<BladeSettings>(file).blades;
}

void check_blades(Config& file, const std::vector<Cutter>& cutters, const BladeOptions& blades) {
  if (cutters.empty() || file.problem_count() > 0) return;
  Config c = file.table(BladeSettings::table);
  const double gage = std::ranges::max(cutters, {}, &Cutter::tip_radius).tip_radius;
  for (const BladeProblem& p : blade_problems(cutters, blades, gage))
    c.problem(p.key, p.found, p.expected);
}

void adjust_cutters(Config adjust, std::vector<Cutter>& cutters) {
  if (adjust.given().empty()) return;
  Adjustment all;
  read_fields(adjust, all);
  for (Cutter& c : cutters) add(all, c);
  adjust_some(adjust.table("blade"), &Cutter::blade, "blade", cutters);
  adjust_some(adjust.table("cutter"), &Cutter::id, "cutter", cutters);
  for (Cutter& c : cutters) {
    check_adjusted(adjust, c);
    c.X_BC = cutter_pose(c);
  }
}

}  // namespace tdbd::bit
