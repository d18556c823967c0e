#pragma once

#include <fmt/format.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "bit/cutter/cutter.hpp"
#include "bit/cutter/cutter_table.hpp"
#include "bit/pdc/pdc_bit.hpp"
#include "core/types.hpp"

namespace tdbd::bit {

/// A number in [lo, hi], in 10 000 steps, so that shrinking finds round values.
inline double number(double lo, double hi) {
  return lo + (hi - lo) * *rc::gen::inRange(0, 10001) / 10000.0;
}

/// A cutter anywhere on a bit, with its pose; sharp one time in a few.
inline Cutter any_cutter() {
  Cutter c;
  c.id = *rc::gen::inRange(1, 100);
  c.diameter = number(8e-3, 25e-3);
  c.tip_radius = number(0.0, 0.2);
  c.azimuth = number(-2 * pi, 2 * pi);
  c.tip_height = number(0.0, 0.1);
  c.profile_angle = number(-40 * degree, 100 * degree);
  c.back_rake = number(-5 * degree, 44 * degree);
  c.side_rake = number(-10 * degree, 10 * degree);
  c.chamfer = *rc::gen::inRange(0, 4) == 0 ? 0.0 : number(1e-4, 6e-4);
  c.chamfer_angle = number(45 * degree, 80 * degree);
  c.length = number(8e-3, 16e-3);
  c.table_thickness = number(1.5e-3, 3e-3);
  c.X_BC = cutter_pose(c);
  return c;
}

/// What the tables in cases/bits leave open, in these tests.
inline CutterDefaults chamfered() {
  CutterDefaults d;
  d.chamfer = 0.4e-3;
  return d;
}

/// One of the tables in cases/bits: 'a', 'b' or 'c'.
inline std::vector<Cutter> table(char letter) {
  return read_cutter_table(fmt::format(TDBD_SOURCE_DIR "/cases/bits/bit-{}.csv", letter),
                           chamfered());
}

inline Bit example_bit(char letter, const PdcOptions& options = {}) {
  return pdc_bit(std::string("bit-") + letter, table(letter), options);
}

/// Closed and consistently oriented: each directed edge occurs once and its opposite occurs once.
inline bool is_closed_and_oriented(const mesh::TriangleMesh& m) {
  std::map<std::pair<int, int>, int> count;
  for (const mesh::Triangle& t : m.triangles)
    for (int k = 0; k < 3; ++k) ++count[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, times] : count)
    if (times != 1 || !count.contains({edge.second, edge.first})) return false;
  return !count.empty();
}

}  // namespace tdbd::bit
