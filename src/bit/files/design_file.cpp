#include "bit/files/design_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bit/pdc/pdc_generator.hpp"

namespace tdbd::bit {
namespace {

/// The angle at which the shoulder's arc begins: given, or from the arc's radius.
double read_shoulder(Config& c, const ProfileDesign& p) {
  const bool by_radius = c.has("shoulder_radius");
  const double given =
      c.quantity("shoulder_angle", "rad", by_radius ? std::optional(0.0) : std::nullopt,
                 Range::non_negative());
  if (!by_radius) return given;
  if (c.has("shoulder_angle"))
    c.problem("shoulder_angle", "shoulder_radius as well", "one of the two");
  const double radius = c.quantity("shoulder_radius", "m", std::nullopt, Range::positive());
  const double angle = shoulder_angle_for(p, radius);
  if (angle >= 0.0) return angle;
  const double left = p.gage_radius - p.nose_place;
  c.problem("shoulder_radius", fmt::format("{:.6g} mm, no arc between nose and gage", 1e3 * radius),
            fmt::format("at {} {:.6g} mm, what nose_place leaves to the gage",
                        p.nose_radius < left ? "least" : "most", 1e3 * left));
  return 0.0;
}

ProfileDesign read_profile(Config c, double gage_radius) {
  ProfileDesign p;
  p.gage_radius = gage_radius;
  p.cone_angle = c.quantity("cone_angle", "rad", std::nullopt, Range::non_negative());
  p.nose_place = c.quantity("nose_place", "m", std::nullopt, Range::positive());
  p.nose_radius = c.quantity("nose_radius", "m", std::nullopt, Range::positive());
  p.shoulder_angle = read_shoulder(c, p);
  p.gage_length = c.quantity("gage_length", "m", 0.05, Range::non_negative());
  return p;
}

/// A value that is not given is the same as the one before it.
RegionLaw read_law(Config c, const char* unit, std::optional<double> fallback) {
  RegionLaw law;
  law.axis = c.quantity("axis", unit, fallback);
  law.nose = c.quantity("nose", unit, law.axis);
  law.shoulder = c.quantity("shoulder", unit, law.nose);
  law.gage = c.quantity("gage", unit, law.shoulder);
  return law;
}

RegionChoice read_choice(Config c) {
  RegionChoice choice;
  choice.cone = c.quantity("cone", "m", std::nullopt, Range::positive());
  choice.nose = c.quantity("nose", "m", choice.cone, Range::positive());
  choice.shoulder = c.quantity("shoulder", "m", choice.nose, Range::positive());
  choice.gage = c.quantity("gage", "m", choice.shoulder, Range::positive());
  return choice;
}

std::vector<BladeDesign> read_blade_designs(Config& c) {
  std::vector<BladeDesign> blades;
  for (Config& blade : c.tables("blades")) {
    BladeDesign b;
    b.azimuth = blade.quantity("azimuth", "rad", std::nullopt);
    b.start = blade.quantity("start", "m", 0.0, Range::non_negative());
    if (blade.flag("backups", false)) b.backups = Backups::behind_face_cutters;
    blades.push_back(b);
  }
  return blades;
}

BackupRow read_backups(Config c) {
  BackupRow row;
  row.from = c.quantity("from", "m", row.from, Range::non_negative());
  row.to = c.quantity("to", "m", row.to, Range::positive());
  row.under_exposure = c.quantity("under_exposure", "m", row.under_exposure, Range::non_negative());
  row.behind = c.quantity("behind", "m", row.behind, Range::positive());
  return row;
}

GageRow read_gage(Config c) {
  GageRow row;
  row.cutters = static_cast<int>(c.integer("cutters", row.cutters, 0, 100));
  row.start = c.quantity("start", "1", row.start, Range::non_negative());
  row.spacing = c.quantity("spacing", "1", row.spacing, Range::positive());
  return row;
}

}  // namespace

std::vector<Cutter> read_design(Config c, double gage_radius, const CutterDefaults& shape) {
  PdcDesign d;
  d.shape = shape;
  d.profile = read_profile(c.table("profile"), gage_radius);
  d.blades = read_blade_designs(c);
  d.first_radius = c.quantity("first_radius", "m", std::nullopt, Range::non_negative());
  d.spiral = c.quantity("spiral", "rad", 0.0);
  d.clearance = c.quantity("clearance", "m", d.clearance, Range::positive());
  d.diameter = read_choice(c.table("diameter"));
  d.overlap = read_law(c.table("overlap"), "1", std::nullopt);
  d.back_rake = read_law(c.table("back_rake"), "rad", std::nullopt);
  d.side_rake = read_law(c.table("side_rake"), "rad", 0.0);
  d.wear = read_law(c.table("wear"), "m", 0.0);
  d.backups = read_backups(c.table("backup"));
  d.gage = read_gage(c.table("gage"));
  if (c.problem_count() > 0) return {};
  const Layout layout = lay_out(d);
  for (const DesignProblem& p : layout.problems) c.problem(p.key, p.found, p.expected);
  return layout.problems.empty() ? layout.cutters : std::vector<Cutter>{};
}

}  // namespace tdbd::bit
