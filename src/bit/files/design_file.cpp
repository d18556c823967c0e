#include "bit/files/design_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bit/files/design_keys.hpp"
#include "bit/pdc/pdc_generator.hpp"

namespace tdbd::bit {
namespace {

/// The angle at which the shoulder's arc begins: given, or computed from the arc's radius.
double read_shoulder(Config& c, const ProfileDesign& p) {
  const bool by_radius = c.has(profile_keys::shoulder_radius);
  const double given =
      c.read(profile_keys::shoulder_angle, by_radius ? std::optional(0.0) : std::nullopt);
  if (!by_radius) return given;
  if (c.has(profile_keys::shoulder_angle))
    c.problem(profile_keys::shoulder_angle, "shoulder_radius as well", "one of the two");
  const double radius = c.read(profile_keys::shoulder_radius);
  const double angle = shoulder_angle_for(p, radius);
  if (angle >= 0.0) return angle;
  const double left = p.gage_radius - p.nose_place;
  c.problem(profile_keys::shoulder_radius,
            fmt::format("{:.6g} mm, no arc between nose and gage", 1e3 * radius),
            fmt::format("at {} {:.6g} mm, what nose_place leaves to the gage",
                        p.nose_radius < left ? "least" : "most", 1e3 * left));
  return 0.0;
}

ProfileDesign read_profile(Config c, double gage_radius) {
  ProfileDesign p;
  p.gage_radius = gage_radius;
  p.cone_angle = c.read(profile_keys::cone_angle);
  p.nose_place = c.read(profile_keys::nose_place);
  p.nose_radius = c.read(profile_keys::nose_radius);
  p.shoulder_angle = read_shoulder(c, p);
  p.gage_length = c.read(profile_keys::gage_length);
  return p;
}

/// Each value defaults to the previous one.
RegionLaw read_law(Config c, const region_keys::Keys& keys) {
  RegionLaw law;
  law.axis = c.read(keys.first);
  law.nose = c.read(keys.nose, law.axis);
  law.shoulder = c.read(keys.shoulder, law.nose);
  law.gage = c.read(keys.gage, law.shoulder);
  return law;
}

RegionChoice read_choice(Config c, const region_keys::Keys& keys) {
  RegionChoice choice;
  choice.cone = c.read(keys.first);
  choice.nose = c.read(keys.nose, choice.cone);
  choice.shoulder = c.read(keys.shoulder, choice.nose);
  choice.gage = c.read(keys.gage, choice.shoulder);
  return choice;
}

std::vector<BladeDesign> read_blade_designs(Config& c) {
  std::vector<BladeDesign> blades;
  for (Config& blade : c.tables(design_blade_keys::table)) {
    BladeDesign b;
    b.azimuth = blade.read(design_blade_keys::azimuth);
    b.start = blade.read(design_blade_keys::start);
    if (blade.read(design_blade_keys::backups)) b.backups = Backups::behind_face_cutters;
    blades.push_back(b);
  }
  return blades;
}

BackupRow read_backups(Config c) {
  BackupRow row;
  row.from = c.read(backup_keys::from);
  row.to = c.read(backup_keys::to);
  row.under_exposure = c.read(backup_keys::under_exposure);
  row.behind = c.read(backup_keys::behind);
  return row;
}

GageRow read_gage(Config c) {
  GageRow row;
  row.cutters = static_cast<int>(c.read(gage_row_keys::cutters));
  row.start = c.read(gage_row_keys::start);
  row.spacing = c.read(gage_row_keys::spacing);
  return row;
}

}  // namespace

std::vector<Cutter> read_design(Config c, double gage_radius, const CutterDefaults& shape) {
  PdcDesign d;
  d.shape = shape;
  d.profile = read_profile(c.table(profile_keys::table), gage_radius);
  d.blades = read_blade_designs(c);
  d.first_radius = c.read(design_keys::first_radius);
  d.spiral = c.read(design_keys::spiral);
  d.clearance = c.read(design_keys::clearance);
  d.diameter = read_choice(c.table(region_keys::diameter), region_keys::diameters);
  d.overlap = read_law(c.table(region_keys::overlap), region_keys::overlaps);
  d.back_rake = read_law(c.table(region_keys::back_rake), region_keys::back_rakes);
  d.side_rake = read_law(c.table(region_keys::side_rake), region_keys::side_rakes);
  d.wear = read_law(c.table(region_keys::wear), region_keys::wears);
  d.backups = read_backups(c.table(backup_keys::table));
  d.gage = read_gage(c.table(gage_row_keys::table));
  if (c.problem_count() > 0) return {};
  const Layout layout = make_layout(d);
  for (const DesignProblem& p : layout.problems) c.problem(p.key, p.found, p.expected);
  return layout.problems.empty() ? layout.cutters : std::vector<Cutter>{};
}

}  // namespace tdbd::bit
