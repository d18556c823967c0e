#include "bit/files/adjust_file.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "bit/cutter/cutter_frame.hpp"
#include "bit/files/bit_file.hpp"
#include "core/angles.hpp"
#include "core/error.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::bit::adjust_file_test {

const std::string bit_b = TDBD_SOURCE_DIR "/cases/bits/bit-b.toml";

std::vector<Cutter> cutters_with(const std::vector<std::string>& overrides) {
  return read_bit(bit_b, DirectionRule::hybrid, InsideRule::down, Densities::as_given, overrides)
      .bit.cutters;
}

std::string mistake_of(const std::vector<std::string>& overrides) {
  try {
    cutters_with(overrides);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

/// Changes of all cutters, of a blade and of one cutter add up, and the frames follow.
RC_GTEST_PROP(AdjustFile, changes_add_up, ()) {
  const auto angle = [](int n) { return std::to_string(n) + " deg"; };
  const int all = *battery::integer(0, 5), blade = *battery::integer(0, 5),
            one = *battery::integer(0, 5);
  const int turn = *battery::integer(-10, 10);
  const std::vector<Cutter> before = cutters_with({});
  const std::vector<Cutter> after = cutters_with(
      {"adjust.back_rake=" + angle(all), "adjust.blade.3.back_rake=" + angle(blade),
       "adjust.cutter.2.back_rake=" + angle(one), "adjust.blade.3.azimuth=" + angle(turn)});
  for (std::size_t i = 0; i < before.size(); ++i) {
    const int more = all + (before[i].blade == 3 ? blade : 0) + (before[i].id == 2 ? one : 0);
    const double turned = before[i].blade == 3 ? turn * degree : 0.0;
    constexpr double rounding = 1e-14;
    RC_ASSERT(std::abs(after[i].back_rake - before[i].back_rake - more * degree) < rounding);
    RC_ASSERT(std::abs(after[i].azimuth - before[i].azimuth - turned) < 10.0 * rounding);
    RC_ASSERT(after[i].X_BC.R == cutter_pose(after[i]).R);
    RC_ASSERT(after[i].X_BC.p == cutter_pose(after[i]).p);
  }
}

/// The way along the profile is at right angles to the profile's normal.
TEST(AdjustFile, moves_along_the_tangent) {
  const std::vector<Cutter> before = cutters_with({}),
                            after = cutters_with({"adjust.cutter.6.along=2 mm"});
  const auto moved = std::ranges::find(after, 6, &Cutter::id) - after.begin();
  const auto i = static_cast<std::size_t>(moved);
  const Vec3 way = tip_B(after[i]) - tip_B(before[i]);
  EXPECT_NEAR(way.norm(), 2e-3, 1e-16);
  EXPECT_NEAR(way.dot(profile_normal_B(before[i])), 0.0, 1e-17);
  EXPECT_GT(after[i].tip_radius, before[i].tip_radius);
}

TEST(AdjustFile, refuses_what_the_bit_does_not_have) {
  EXPECT_EQ(mistake_of({"adjust.blade.9.azimuth=1 deg"}),
            "bit.set: adjust.blade.9.azimuth: found a table of 9, expected the number of a blade");
  EXPECT_EQ(mistake_of({"adjust.cutter.first.back_rake=1 deg"}),
            "bit.set: adjust.cutter.first.back_rake: found a table of first, expected the number "
            "of a cutter");
  EXPECT_EQ(mistake_of({"adjust.bak_rake=1 deg"}),
            "bit.set: adjust.bak_rake: found an unknown key, expected back_rake");
  EXPECT_NE(mistake_of({"adjust.back_rake=60 deg"}).find("expected an angle in -5..60"),
            std::string::npos);
  EXPECT_NE(mistake_of({"adjust.side_rake=50 deg"}).find("expected an angle in -45..45"),
            std::string::npos);
  EXPECT_NE(mistake_of({"adjust.cutter.1.along=-20 mm"}).find("expected a radius >= 0"),
            std::string::npos);
}

}  // namespace tdbd::bit::adjust_file_test
