#include "reference/literature/roller/roller_bit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "bit/cone/cone_bit.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/files/bit_file.hpp"
#include "core/error.hpp"
#include "reference/literature/roller/bracketed_root.hpp"
#include "reference/literature/roller/roller_bit_of.hpp"
#include "reference/literature/roller/teeth/ma_azar.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::reference::roller_bit_test {

TEST(RollerBit, journal_axes_are_a_right_handed_frame_with_the_direction_of_rotation) {
  RollerCone cone;
  cone.journal_angle = 0.6;
  const JournalAxes axes = journal_axes(cone);
  EXPECT_NEAR((axes.s.cross(axes.u) - Vec3::UnitY()).norm(), 0.0, 1e-15);
  EXPECT_GT(axes.s.z(), 0.0);
}

TEST(BracketedRoot, is_found_to_rounding_and_counted) {
  int asked = 0;
  const BracketedRoot root = bracketed_root(
      [&](double x) {
        ++asked;
        return std::cos(x) - x;
      },
      {.low = 0.0, .high = 1.0, .what = "Dottie"});
  EXPECT_NEAR(root.x, 0.7390851332151607, 2e-16);
  EXPECT_EQ(root.evaluations, asked);
  EXPECT_LE(asked, 14);
}

TEST(BracketedRoot, may_be_at_an_end) {
  const auto f = [](double x) { return x; };
  EXPECT_EQ(bracketed_root(f, {.low = 0.0, .high = 1.0, .what = ""}).x, 0.0);
  EXPECT_EQ(bracketed_root(f, {.low = -1.0, .high = 0.0, .what = ""}).x, 0.0);
}

TEST(BracketedRoot, reports_the_searched_interval) {
  try {
    bracketed_root([](double x) { return 1.0 + x * x; },
                   {.low = -1.0, .high = 2.0, .what = "Nobody: the nothing (m)"});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "Nobody: the nothing (m): found no root, the balance is 2 at -1 and 5 at 2, "
                 "expected a bracket at whose ends it has different signs");
  }
}

}  // namespace tdbd::reference::roller_bit_test

namespace tdbd::reference::roller_bit_of_test {

using battery::number;

bit::Bit shipped(const std::string& name) {
  return bit::read_bit(TDBD_SOURCE_DIR "/cases/bits/" + name + ".toml", bit::DirectionRule::hybrid,
                       bit::InsideRule::down)
      .bit;
}

/// Bit R, whose journals are skewed, or the same with another skew, journal angle and offset.
bit::Bit bit_r(double skew, double journal_angle, double offset) {
  const bit::Bit shipped_r = shipped("bit-r");
  std::vector<bit::ConeLayout> cones;
  for (bit::Cone cone : shipped_r.cones) {
    cone.layout.skew = skew;
    cone.layout.journal_angle = journal_angle;
    cone.layout.offset = offset;
    cone.layout.segments = 12;  // coarse and quick: tips are the same
    cone.layout.facets = 4;
    cones.push_back(cone.layout);
  }
  return bit::cone_bit("another bit-r", cones, std::nullopt, shipped_r.shank);
}

/// Teeth of the model and tips of our meshes, the bit and all cones turned and the bit lowered.
void expect_same_tips(const bit::Bit& ours) {
  const RollerBit roller = roller_bit_of(ours);
  RC_ASSERT(roller.cones.size() == ours.cones.size());
  const double turn = *number(-3.0, 3.0), depth = *number(-0.5, 0.5);
  std::vector<double> angles;
  std::vector<Course> turns;
  for (std::size_t k = 0; k < ours.cones.size(); ++k) {
    angles.push_back(*number(-3.0, 3.0));
    turns.push_back({angles.back(), 0.0, 0.0});
  }
  std::vector<ToothState> teeth;
  place_teeth(roller, {{turn, 0.0, 0.0}, {depth, 0.0, 0.0}}, turns, teeth);
  const Pose X_WB{Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix(), Vec3(0, 0, depth)};
  std::size_t next = 0;
  for (const bit::Part& part : ours.parts) {
    if (part.kind != bit::PartKind::tooth) continue;
    const Vec3 tip_W = X_WB * bit::part_pose(ours, part, angles) * bit::tooth_tip_P(part);
    RC_ASSERT(next < teeth.size());
    RC_ASSERT((teeth[next++].place - tip_W).norm() <= 1e-12);
  }
  RC_ASSERT(next == teeth.size());
}

RC_GTEST_PROP(RollerBitOf, has_the_tips_of_the_meshes_of_tdbd, ()) {
  static const bit::Bit r = shipped("bit-r"), compared = shipped("compare-r-4");
  expect_same_tips(r);
  expect_same_tips(compared);
}

/// Far beyond any real journal: skews to 0.5 rad, either sense of skew and offset.
RC_GTEST_PROP(RollerBitOf, has_the_tips_of_any_skewed_journal, ()) {
  expect_same_tips(bit_r(*number(-0.5, 0.5), *number(0.0, 1.4), *number(-0.02, 0.02)));
}

/// The plain journal is the same line: its offset is the distance of the journal from the bit's axis.
TEST(RollerBitOf, offsets_a_skewed_journal_by_its_distance_from_the_axis) {
  const bit::Bit r = shipped("bit-r");
  const RollerBit roller = roller_bit_of(r);
  for (std::size_t k = 0; k < r.cones.size(); ++k) {
    ASSERT_NE(r.cones[k].layout.skew, 0.0);
    const Pose& X_BK = r.cones[k].X_BK;
    const Vec3 across = X_BK.R.col(2).cross(Vec3::UnitZ()).normalized();
    EXPECT_NEAR(roller.cones[k].offset, std::abs(across.dot(X_BK.p)), 1e-15);
  }
}

/// The comparison's bit has the rows of the literature's worked examples.
TEST(RollerBitOf, the_compared_bit_has_the_worked_rows) {
  for (const double offset : {0.0, 4e-3, 8e-3}) {
    const RollerBit r = roller_bit_of(shipped(
        offset == 0.0 ? "compare-r" : "compare-r-" + std::to_string(std::lround(1e3 * offset))));
    ASSERT_EQ(r.cones.size(), 3U);
    for (const RollerCone& cone : r.cones) {
      EXPECT_NEAR(cone.journal_angle, 36.0 * std::numbers::pi / 180.0, 1e-15);
      EXPECT_EQ(cone.offset, offset);
      ASSERT_EQ(cone.rows.size(), 2U);
      EXPECT_EQ(cone.rows[0].angles.size(), 15U);
      EXPECT_EQ(cone.rows[1].angles.size(), 25U);
      constexpr double of_the_digits = 2e-12;  // m
      EXPECT_NEAR(cone.rows[0].along, 45e-3, of_the_digits);
      EXPECT_NEAR(cone.rows[0].radius, 40e-3, of_the_digits);
      EXPECT_NEAR(cone.rows[1].along, 80e-3, of_the_digits);
      EXPECT_NEAR(cone.rows[1].radius, 60e-3, of_the_digits);
      EXPECT_EQ(cone.rows[0].tooth_radius, 6e-3);
    }
  }
}

TEST(RollerBitOf, has_the_inertia_of_the_cones_of_tdbd) {
  const bit::Bit r = shipped("bit-r");
  const RollerBit roller = roller_bit_of(r);
  for (std::size_t k = 0; k < r.cones.size(); ++k) {
    const double ours = bit::cone_mass(r, static_cast<int>(k)).axial_inertia;
    EXPECT_NEAR(roller.cones[k].inertia, ours, 1e-12 * ours);
  }
}

/// Elevation 0 is the lowest tip: a row's lowest point is as high as our measures say.
TEST(RollerBitOf, is_as_high_as_the_bit_of_tdbd) {
  const bit::Bit r = shipped("bit-r");
  const RollerBit roller = roller_bit_of(r);
  for (std::size_t k = 0; k < r.cones.size(); ++k)
    for (std::size_t j = 0; j < roller.cones[k].rows.size(); ++j) {
      const bit::RowMeasures ours = bit::row_measures(r.cones[k], r.cones[k].layout.rows[j]);
      const RollerRow& row = roller.cones[k].rows[j];
      if (row.radius < 1e-9) continue;  // a tooth on the journal
      const Vec3 low = tooth_state(roller.cones[k], {row.along, row.radius, 0.0}, {}, {}).place;
      EXPECT_NEAR(-low.z(), ours.height, 1e-12);
      EXPECT_NEAR(low.head<2>().norm(), ours.bit_radius, 1e-12);
    }
}

std::string refusal(const bit::Bit& b) {
  try {
    roller_bit_of(b, "Ma and Yang");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(RollerBitOf, rejects_what_the_models_do_not_support) {
  EXPECT_EQ(refusal(shipped("bit-b")),
            "Ma and Yang: found a bit with 28 cutters, expected roller cones alone");
  EXPECT_EQ(refusal({}), "Ma and Yang: found a bit without cones, expected a roller cone bit");
  EXPECT_EQ(
      refusal(bit_r(0.1, std::numbers::pi / 2.0, 0.0)),
      "Ma and Yang: found a skewed journal along the bit's axis of cone-1, expected a skew of "
      "0 or a journal angle below 90 deg");
  EXPECT_EQ(refusal(bit_r(0.0, std::numbers::pi / 2.0, 0.0)), "");
  bit::Bit solid = shipped("bit-r");
  solid.cones[1].layout.rows.clear();
  EXPECT_EQ(refusal(solid),
            "Ma and Yang: found cone-2 without rows of teeth, expected a cone that is drawn, not "
            "read from meshes");
}

}  // namespace tdbd::reference::roller_bit_of_test
