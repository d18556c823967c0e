#include "bit/pdc/profile_design.hpp"

#include <cmath>

#include "core/angles.hpp"

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

}  // namespace tdbd::bit
