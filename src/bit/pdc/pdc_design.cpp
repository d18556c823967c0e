#include "bit/pdc/pdc_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bit/bit.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

double cone_end_radius(const ProfileDesign& p) {
  return p.nose_place - p.nose_radius * std::sin(p.cone_angle);
}

ProfileSpot on_cone(const ProfileDesign& p, double s) {
  const double r = s * std::cos(p.cone_angle);
  const double h = p.nose_radius * (1.0 - std::cos(p.cone_angle)) +
                   (cone_end_radius(p) - r) * std::tan(p.cone_angle);
  return {r, h, -p.cone_angle, Region::cone};
}

ProfileSpot on_nose(const ProfileDesign& p, double angle) {
  return {p.nose_place + p.nose_radius * std::sin(angle), p.nose_radius * (1.0 - std::cos(angle)),
          angle, Region::nose};
}

ProfileSpot on_shoulder(const ProfileDesign& p, double angle) {
  const ProfileSpot start = on_nose(p, p.shoulder_angle);
  const double radius = shoulder_radius(p);
  return {start.r + radius * (std::sin(angle) - std::sin(p.shoulder_angle)),
          start.h + radius * (std::cos(p.shoulder_angle) - std::cos(angle)), angle,
          Region::shoulder};
}

}  // namespace

double shoulder_radius(const ProfileDesign& p) {
  const double sine = std::sin(p.shoulder_angle);
  return (p.gage_radius - p.nose_place - p.nose_radius * sine) / (1.0 - sine);
}

double shoulder_angle_for(const ProfileDesign& p, double radius) {
  return std::asin((p.gage_radius - p.nose_place - radius) / (p.nose_radius - radius));
}

std::array<double, 4> region_ends(const ProfileDesign& p) {
  const double cone = cone_end_radius(p) / std::cos(p.cone_angle);
  const double nose = cone + p.nose_radius * (p.shoulder_angle + p.cone_angle);
  const double shoulder = nose + shoulder_radius(p) * (right_angle - p.shoulder_angle);
  return {cone, nose, shoulder, shoulder + p.gage_length};
}

ProfileSpot spot_at(const ProfileDesign& p, double s) {
  const auto [cone, nose, shoulder, gage] = region_ends(p);
  if (s < cone) return on_cone(p, s);
  if (s < nose) return on_nose(p, -p.cone_angle + (s - cone) / p.nose_radius);
  if (s < shoulder) return on_shoulder(p, p.shoulder_angle + (s - nose) / shoulder_radius(p));
  const ProfileSpot end = on_shoulder(p, right_angle);
  return {p.gage_radius, end.h + s - shoulder, right_angle, Region::gage};
}

namespace {

/// of the cone and at the beginning of the shoulder
constexpr double steepest_profile = 89.0 * degree;
constexpr double largest_rake = 60.0 * degree, largest_side_rake = 45.0 * degree;

/// Collects problems.
struct Check {
  std::vector<DesignProblem> problems;

  void require(bool fine, const char* key, const std::string& found, const std::string& expected) {
    if (!fine) problems.push_back({key, found, expected});
  }
};

void check_profile(const ProfileDesign& p, Check& check) {
  check.require(p.gage_radius > 0.0, "gage_radius", mm_text(p.gage_radius), "a positive radius");
  check.require(p.nose_radius > 0.0, "profile.nose_radius", mm_text(p.nose_radius),
                "a positive radius");
  check.require(p.gage_length >= 0.0, "profile.gage_length", mm_text(p.gage_length),
                "a length >= 0");
  check.require(p.cone_angle >= 0.0 && p.cone_angle <= steepest_profile, "profile.cone_angle",
                degree_text(p.cone_angle), "an angle in 0..89 deg");
  check.require(p.shoulder_angle >= 0.0 && p.shoulder_angle <= steepest_profile,
                "profile.shoulder_angle", degree_text(p.shoulder_angle), "an angle in 0..89 deg");
  check.require(p.nose_place > 0.0 && p.nose_place < p.gage_radius, "profile.nose_place",
                mm_text(p.nose_place) + " from the axis",
                "a nose between the axis and the gage at " + mm_text(p.gage_radius));
}

/// Checks that the regions follow one another without turning back.
void check_folds(const ProfileDesign& p, Check& check) {
  const double cone = p.nose_place - p.nose_radius * std::sin(p.cone_angle);
  check.require(cone >= 0.0, "profile.nose_radius",
                fmt::format("{}, a nose that begins at radius {}, across the axis",
                            mm_text(p.nose_radius), mm_text(cone)),
                "at most " + mm_text(p.nose_place / std::sin(p.cone_angle)));
  const double shoulder = shoulder_radius(p);
  check.require(
      shoulder > 0.0, "profile.shoulder_angle",
      fmt::format("{}, a profile that folds: the nose's arc ends at radius {}, outside the "
                  "gage at {}",
                  degree_text(p.shoulder_angle),
                  mm_text(p.nose_place + p.nose_radius * std::sin(p.shoulder_angle)),
                  mm_text(p.gage_radius)),
      "a smaller angle, a smaller nose_radius or a smaller nose_place");
}

void check_law(const RegionLaw& law, const char* key, double lo, double hi, double unit,
               const char* expected, Check& check) {
  for (const auto& [at, value] : {std::pair("axis", law.axis), std::pair("nose", law.nose),
                                  std::pair("shoulder", law.shoulder), std::pair("gage", law.gage)})
    check.require(value >= lo && value <= hi, fmt::format("{}.{}", key, at).c_str(),
                  fmt::format("{:.6g}", value / unit), expected);
}

void check_cutters(const PdcDesign& d, Check& check) {
  const auto& [cone, nose, shoulder, gage] = d.diameter;
  for (const auto& [at, value] : {std::pair("cone", cone), std::pair("nose", nose),
                                  std::pair("shoulder", shoulder), std::pair("gage", gage)})
    check.require(value > 2.0 * (d.shape.chamfer + d.shape.land),
                  fmt::format("diameter.{}", at).c_str(), mm_text(value),
                  "a positive diameter, more than twice the chamfers' width");
  check_law(d.overlap, "overlap", 0.0, 0.95, 1.0, "a share in 0..0.95", check);
  check_law(d.back_rake, "back_rake", -5.0 * degree, largest_rake, degree, "an angle in -5..60 deg",
            check);
  check_law(d.side_rake, "side_rake", -largest_side_rake, largest_side_rake, degree,
            "an angle in -45..45 deg", check);
  const double least = std::min({cone, nose, shoulder, gage});
  check_law(d.wear, "wear", 0.0, 0.5 * least, 1e-3, "a height in mm from 0 to a cutter's radius",
            check);
}

void check_layout(const PdcDesign& d, Check& check) {
  check.require(!d.blades.empty(), "blades", "none", "at least one blade");
  check.require(d.clearance > 0.0, "clearance", mm_text(d.clearance), "a positive gap");
  check.require(d.backups.under_exposure >= 0.0, "backup.under_exposure",
                mm_text(d.backups.under_exposure), "a depth >= 0");
  check.require(d.backups.behind > 0.0, "backup.behind", mm_text(d.backups.behind),
                "a distance > 0");
  check.require(d.gage.cutters >= 0, "gage.cutters", fmt::format("{}", d.gage.cutters),
                "at least 0");
  const double cone = d.profile.nose_place - d.profile.nose_radius * std::sin(d.profile.cone_angle);
  check.require(d.first_radius >= 0.0 && d.first_radius <= cone, "first_radius",
                mm_text(d.first_radius),
                "a radius from the axis to the cone's end at " + mm_text(cone));
}

}  // namespace

std::vector<DesignProblem> design_problems(const PdcDesign& d) {
  Check check;
  check_profile(d.profile, check);
  if (check.problems.empty()) check_folds(d.profile, check);
  check_cutters(d, check);
  if (check.problems.empty()) check_layout(d, check);
  return check.problems;
}

double law_at(const RegionLaw& law, const ProfileDesign& p, double s) {
  const auto [cone, nose, shoulder, gage] = region_ends(p);
  if (s < cone) return std::lerp(law.axis, law.nose, s / cone);
  if (s < nose) return std::lerp(law.nose, law.shoulder, (s - cone) / (nose - cone));
  if (s < shoulder) return std::lerp(law.shoulder, law.gage, (s - nose) / (shoulder - nose));
  return law.gage;
}

double choice_in(const RegionChoice& choice, Region region) {
  switch (region) {
    case Region::cone:
      return choice.cone;
    case Region::nose:
      return choice.nose;
    case Region::shoulder:
      return choice.shoulder;
    case Region::gage:
      break;
  }
  return choice.gage;
}

}  // namespace tdbd::bit
