#include "bit/cone/tracking.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/cone_generate.hpp"
#include "reference/bit/rolled_prints.hpp"

namespace tdbd::bit::tracking_test {

constexpr double penetration = 3e-3;  // m

/// One ring of N equal pitches, whose prints are `width` wide.
PrintRing ring_of(int teeth, double radius, double width) {
  return {radius, 0.7, 0.4, spaced_angles(teeth, 0.2, {}), width};
}

/// Half the angle at the axis of places on a ring that are closer than `distance` to one of it.
double near_angle(double radius, double distance) { return 2 * std::asin(distance / 2 / radius); }

double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

/// N i prints fit into a revolution: with whole N i every tooth falls into an earlier print.
TEST(Tracking, is_complete_where_a_whole_number_of_prints_fits_into_a_revolution) {
  const double radius = 0.1, width = 0.01;
  for (const double prints_per_revolution : {13.0, 17.0, 20.0}) {
    const TrackingShare t =
        tracking({ring_of(12, radius, width)}, {prints_per_revolution / 12}, {.lags = 5})[0];
    for (const double share : t.share) EXPECT_EQ(share, 1.0);
    const double covered = prints_per_revolution * near_angle(radius, 0.25 * width) / pi;
    EXPECT_NEAR(t.random_phase, covered, 1e-12);
  }
}

/// Half a pitch out: no tooth in the last revolution's prints, all in those of the one before it.
TEST(Tracking, is_nothing_at_half_a_pitch_and_complete_two_revolutions_back) {
  const TrackingShare t = tracking({ring_of(12, 0.1, 0.01)}, {16.5 / 12}, {.lags = 4})[0];
  EXPECT_EQ(t.share, (std::vector<double>{0.0, 1.0, 0.0, 1.0}));
}

/// Each ring counts by its prints; one without some lags counts as none there.
TEST(Tracking, of_rings_together_is_their_mean_by_prints) {
  const TrackingShare alone = combined({{3, {0.5, 0.25}, 0.125}});
  EXPECT_EQ(alone.prints, 3);
  EXPECT_EQ(alone.share, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(alone.random_phase, 0.125);
  const TrackingShare both = combined({{1, {1.0}, 0.5}, {3, {0.5, 0.25}, 0.0}});
  EXPECT_EQ(both.prints, 4);
  EXPECT_EQ(both.share, (std::vector<double>{0.625, 0.1875}));
  EXPECT_EQ(both.random_phase, 0.125);
  EXPECT_EQ(combined({}).prints, 0);
}

/// By the golden ratio the phases of the revolutions spread evenly over the pitch (Weyl), so that
/// over many of them the share is that of a random phase, 2 near / pitch, to the discrepancy.
TEST(Tracking, is_that_of_a_random_phase_by_the_golden_ratio) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0), radius = 0.1, width = 0.02;
  const double per_revolution = 16 + golden;
  constexpr int lags = 987;  // a Fibonacci number
  const TrackingShare t = tracking({ring_of(12, radius, width)}, {per_revolution / 12},
                                   {.revolutions = 2, .lags = lags})[0];
  const double expected = near_angle(radius, 0.25 * width) * per_revolution / pi;
  EXPECT_NEAR(mean(t.share), expected, 0.2 / lags);
  EXPECT_NEAR(t.random_phase, expected, 1.8 / per_revolution * expected);
}

/// A ring far from another has nothing to do with it; one beside it has.
TEST(Tracking, joins_rings_that_lie_side_by_side) {
  const PrintRing a = ring_of(12, 0.1, 0.01);
  PrintRing b = ring_of(12, 0.101, 0.01);
  b.azimuth_B += 2 * pi / 3;
  const TrackingOptions options;
  const double alone = tracking({a}, {17.0 / 12}, options)[0].random_phase;
  // of the second ring, by the law of cosines, what is as near as a quarter of the width
  const double ra = a.radius, rb = b.radius, far = 0.25 * a.width;
  const double beside = std::acos((ra * ra + rb * rb - far * far) / (2.0 * ra * rb));
  EXPECT_NEAR(alone, 17.0 * near_angle(ra, far) / pi, 1e-12);
  EXPECT_NEAR(tracking({a, b}, {17.0 / 12, 17.0 / 12}, options)[0].random_phase,
              17.0 * (near_angle(ra, far) + beside) / pi, 1e-12);
  b.radius = 0.103;
  EXPECT_EQ(tracking({a, b}, {17.0 / 12, 17.0 / 12}, options)[0].random_phase, alone);
}

Cone any_rows() {
  ConeLayout layout = toothed_cone();
  layout.offset = number(-6e-3, 6e-3);
  layout.skew = number(-2 * degree, 2 * degree);
  for (ToothRow& row : layout.rows) row.angles = spaced_angles(*rc::gen::inRange(3, 9), 0.3, {});
  return {"cone-1", layout, cone_pose(layout, number(-pi, pi))};
}

reference::RolledRow rolled(const Cone& cone, const ToothRow& row, double speed, double near) {
  reference::RolledRow r{cone.X_BK, {}, speed, near};
  for (const double angle : row.angles)
    r.tips_K.emplace_back(tooth_pose(cone.layout, row, angle) * Vec3(0, 0, row.shape.protrusion));
  return r;
}

/// Every touch-down is where a cone turned in small steps has it.
RC_GTEST_PROP(Tracking, prints_where_a_cone_in_small_steps_does, ()) {
  const Cone cone = any_rows();
  const double speed = number(1.0, 1.8), to = number(2.0, 9.0);
  for (const ToothRow& row : cone.layout.rows) {
    const PrintRing ring = print_ring(cone, row, penetration);
    const auto own = prints(ring, speed, 0.0, to);
    auto twin = reference::rolled_prints(rolled(cone, row, speed, 0.0), 0.0, to);
    std::ranges::sort(twin, {}, &reference::RolledPrint::turned);
    RC_ASSERT(own.size() == twin.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      RC_ASSERT(std::abs(own[i].turned - twin[i].turned) < 8e-8);
      const Vec3 place = ring.radius * Vec3(std::cos(own[i].azimuth), std::sin(own[i].azimuth), 0);
      RC_ASSERT((place - twin[i].place).norm() < 3.3e-9);
    }
  }
}

/// Shares of two rows against every pair of prints; between those for distances a little less and a
/// little more, since regular prints may all lie right at the border.
RC_GTEST_PROP(Tracking, counts_as_comparing_every_pair_does, ()) {
  constexpr double border = 1e-5;
  const Cone cone = any_rows();
  const double speed = number(1.0, 1.8);
  const std::vector<BitRow> rows{{0, 0, print_ring(cone, cone.layout.rows[0], penetration)},
                                 {0, 1, print_ring(cone, cone.layout.rows[1], penetration)}};
  TrackingOptions options;
  options.revolutions = 3;
  options.share_of_width = number(0.25, 4.0);  // with 4 widths the two rings are neighbours
  const auto shares = tracking(rows, {speed}, options);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto twin = [&](double factor) {
      std::vector<reference::RolledRow> twins;
      for (const ToothRow& row : cone.layout.rows)
        twins.push_back(
            rolled(cone, row, speed, factor * options.share_of_width * rows[i].ring.width));
      return reference::share_near_earlier(twins, i, options.revolutions);
    };
    RC_ASSERT(twin(1 - border) <= shares[i].share[0] + 1e-12);
    RC_ASSERT(shares[i].share[0] <= twin(1 + border) + 1e-12);
  }
}

/// N acos(1 - h/A) / pi, whatever the spacing.
RC_GTEST_PROP(Tracking, contact_ratio_is_the_mean_number_of_teeth_on_the_bottom, ()) {
  const Cone cone = any_rows();
  const double depth = number(1e-3, 20e-3);
  for (const ToothRow& row : cone.layout.rows)
    RC_ASSERT(std::abs(tooth_contact_ratio(cone, row, depth) -
                       reference::mean_tips_in_contact(rolled(cone, row, 1.0, 0.0), depth)) < 7e-4);
}

/// A hemisphere that stands upright leaves a print of its chord.
TEST(Tracking, a_print_is_as_wide_as_the_tooth_at_its_depth) {
  ConeLayout layout;
  layout.apex = -0.06;
  layout.shell = {{-0.01, 0.03}, {0.01, 0.03}};
  layout.facets = 128;
  ToothRow row;
  row.angles = {0.0, 1.0};
  row.shape.diameter = 12e-3;
  row.shape.protrusion = 6e-3;
  layout.rows = {row};
  const Cone cone{"cone-1", layout, cone_pose(layout, 0.0)};
  const double chord = 2 * std::sqrt(2 * 6e-3 * penetration - penetration * penetration);
  EXPECT_NEAR(print_width(cone, row, penetration), chord, 1.9e-3 * chord);
  EXPECT_NEAR(print_ring(cone, row, penetration).radius, 0.06, 1e-15);
}

}  // namespace tdbd::bit::tracking_test
