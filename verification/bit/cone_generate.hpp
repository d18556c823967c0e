#pragma once

#include "bit/cone/cone_parts.hpp"
#include "bit/generate.hpp"

namespace tdbd::bit {

inline constexpr ToothKind all_tooth_kinds[] = {ToothKind::milled_chisel, ToothKind::hemispherical,
                                                ToothKind::conical, ToothKind::chisel};

/// Proportions that every kind of tooth allows.
inline ToothShape any_tooth() {
  ToothShape t;
  t.kind = *rc::gen::elementOf(
      std::vector<ToothKind>(std::begin(all_tooth_kinds), std::end(all_tooth_kinds)));
  t.diameter = number(8e-3, 16e-3);
  t.width = t.diameter * number(0.4, 1.2);
  t.protrusion = t.diameter * number(0.5, 0.9);
  t.crest_length = t.diameter * number(0.5, 1.0);
  t.crest_width = t.diameter * number(0.1, 0.4);
  t.tip_radius = t.diameter * number(0.1, 0.4);
  t.half_angle = number(0.5, 0.9);
  t.embedding = t.diameter * number(0.4, 0.8);
  return t;
}

/// A cone anywhere on a bit, without rows.
inline ConeLayout any_cone() {
  ConeLayout c;
  c.journal_angle = number(0, 70 * degree);
  c.offset = number(-10e-3, 10e-3);
  c.skew = number(-5 * degree, 5 * degree);
  c.azimuth = number(-pi, pi);
  c.apex = number(-20e-3, 20e-3);
  c.foot_height = number(-50e-3, 50e-3);
  c.shell = {{0.01, 0.01}, {0.04, 0.03}, {0.07, 0.05}, {0.09, 0.035}};
  return c;
}

/// One that drills: a row of each place, on the shell of any_cone.
inline ConeLayout toothed_cone() {
  ConeLayout c = any_cone();
  c.journal_angle = 36 * degree;
  ToothRow inner, gage;
  inner.s = 0.04;
  inner.angles = spaced_angles(8, 0.0, {});
  gage.s = 0.08;
  gage.angles = spaced_angles(12, 0.1, {1.0, 1.2});
  gage.place = RowPlace::gage;
  c.rows = {inner, gage};
  return c;
}

}  // namespace tdbd::bit
