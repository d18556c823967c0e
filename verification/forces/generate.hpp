#pragma once

#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/types.hpp"
#include "forces/law.hpp"
#include "forces/rock/rock_material.hpp"

namespace tdbd::forces {

/// A few roundings of a sum of terms of this size.
inline double rounding(double scale) { return 64 * 0x1p-53 * std::abs(scale); }

/// Scale of a force's rounding: its components before they were summed.
inline double size(const PartForce& f) { return f.normal + f.tangential; }

/// A number in [lo, hi], in 10 000 steps, so that shrinking finds round values.
inline double number(double lo, double hi) {
  return lo + (hi - lo) * *rc::gen::inRange(0, 10001) / 10000.0;
}

/// One of n, all equally likely at any size of example.
inline std::size_t index(std::size_t n) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, n));
}

inline Vec3 any_direction() {
  const double z = number(-1.0, 1.0), turn = number(0.0, 2 * pi), r = std::sqrt(1.0 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

inline Mat3 any_rotation() {
  return Eigen::AngleAxisd(number(-pi, pi), any_direction()).toRotationMatrix();
}

inline bit::PartKind any_kind() { return static_cast<bit::PartKind>(index(8)); }

/// A cut of any kind that moves anyhow: at rest, plunging and leaving the rock now and then.
inline PartCut any_cut() {
  PartCut c;
  c.kind = any_kind();
  c.cut_area = number(0.0, 30e-6);
  c.contact_area = number(0.0, 100e-6);
  c.engaged_edge = number(0.0, 20e-3);
  c.depth = number(0.0, 3e-3);
  c.back_rake = number(-20 * degree, 60 * degree);
  c.diameter = number(8e-3, 25e-3);
  c.point = number(0.0, 0.2) * any_direction();
  c.normal = any_direction();
  switch (index(8)) {
    case 0:
      c.velocity = Vec3::Zero();
      break;
    case 1:
      c.velocity = number(0.0, 2.0) * c.normal;
      break;
    case 2:
      c.velocity = -number(0.0, 2.0) * c.normal;
      break;
    default:
      c.velocity = number(0.0, 2.0) * any_direction();
  }
  c.strength.unconfined = number(5 * MPa, 200 * MPa);
  c.strength.pressure = number(0.0, 100 * MPa);
  c.strength.friction_angle = number(0.0, 55 * degree);
  c.strength.confined = c.strength.unconfined + number(1.0, 6.0) * c.strength.pressure;
  return c;
}

/// Any law with any coefficients in their ranges (ends that are open are cut at 10 usual units).
inline Law any_law(const std::vector<std::string_view>& names = law_names()) {
  Law law = law_named(names[index(names.size())]);
  for (const LawField& f : law_fields(law)) {
    const double unit = f.unit == "Pa"  ? 100 * MPa
                        : f.unit == "m" ? 5e-3
                        : f.unit == "N" ? 1e3
                                        : 1.0;
    const double lo = std::max(f.range.lo, -10 * unit), hi = std::min(f.range.hi, 10 * unit);
    *f.value = number(lo + (f.range.contains(lo) ? 0.0 : 1e-3 * unit), hi);
  }
  return law;
}

/// A cutter's part that drills straight on, x ahead and z into the rock, in rock of 100 MPa.
inline PartCut plain_cut(bit::PartKind kind) {
  PartCut c;
  c.kind = kind;
  c.cut_area = 10e-6;
  c.contact_area = 4e-6;
  c.engaged_edge = 10e-3;
  c.depth = 1e-3;
  c.back_rake = 20 * degree;
  c.diameter = 16e-3;
  c.point = Vec3(0.1, 0.0, 0.0);
  c.velocity = Vec3(1.0, 0.0, 0.0);
  c.normal = Vec3(0.0, 0.0, 1.0);
  c.strength = {.unconfined = 60 * MPa,
                .confined = 100 * MPa,
                .friction_angle = 30 * degree,
                .pressure = 20 * MPa};
  return c;
}

}  // namespace tdbd::forces
