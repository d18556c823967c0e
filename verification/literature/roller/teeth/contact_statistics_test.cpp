#include "reference/literature/roller/teeth/contact_statistics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/roller/teeth/ma_azar.hpp"
#include "reference/literature/roller/teeth/tooth_law.hpp"
#include "verification/battery/generators.hpp"

namespace tdbd::reference::contact_statistics_test {

using battery::integer;
using battery::number;

constexpr double pi = std::numbers::pi, degree = pi / 180.0;
constexpr double speed = 3.0 * pi;  // 90 rpm
constexpr double ratio = 1.37;

RollerRow even_row(int teeth) {
  RollerRow row{80e-3, 60e-3, 6e-3, {}};
  for (int i = 0; i < teeth; ++i) row.angles.push_back(2.0 * pi * i / teeth);
  return row;
}

const RollerCone worked_cone{0.0, 36.0 * degree, 4e-3, 0.0, 0.0, {}};

struct Worked {
  double depth, degrees, share, mean, milliseconds, path, forward;
};

constexpr Worked worked[] = {{1e-3, 11.6502, 0.064723, 1.618, 31.495, 5.520, 5.39},
                             {2e-3, 16.5044, 0.091691, 2.292, 44.619, 7.971, 7.79},
                             {3e-3, 20.2491, 0.112495, 2.812, 54.742, 9.965, 9.75}};

TEST(ContactStatistics, give_the_worked_examples) {
  for (const Worked& w : worked) {
    const RowContact c = row_contact(worked_cone, even_row(25), {w.depth, ratio, speed});
    EXPECT_NEAR(c.half_angle / degree, w.degrees, 0.5e-4);
    EXPECT_NEAR(c.share, w.share, 0.5e-6);
    EXPECT_NEAR(c.mean, w.mean, 0.5e-3);
    EXPECT_NEAR(1e3 * c.duration, w.milliseconds, 0.5e-3);
  }
}

TEST(ContactStatistics, two_millimetres_in_three_teeth_touch_in_29_of_100_cases) {
  const RowContact c = row_contact(worked_cone, even_row(25), {2e-3, ratio, speed});
  const double three = c.mean - 2.0;
  EXPECT_NEAR(three, 0.292, 0.5e-3);
  EXPECT_NEAR(c.variance, three * (1.0 - three), 1e-15);
}

/// Horizontal way of a tip through the rock while it touches, and how much of it is forward at the
/// lowest point: sums over the kinematics.
TEST(ContactStatistics, the_tip_goes_the_worked_way_through_the_rock) {
  constexpr int steps = 2000;
  for (const Worked& w : worked) {
    const RowContact c = row_contact(worked_cone, even_row(25), {w.depth, ratio, speed});
    double path = 0.0, forward = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double t = ((i + 0.5) / steps - 0.5) * c.duration, dt = c.duration / steps;
      const RollerMotion bit{steady_course(0.0, speed, t), {}};
      const Vec3 v_W = in_space(worked_cone, bit,
                                tooth_state(worked_cone, {80e-3, 60e-3, 0.0}, bit,
                                            steady_course(0.0, -ratio * speed, t)))
                           .velocity;
      path += dt * v_W.head<2>().norm();
      forward += dt * v_W.y();
    }
    EXPECT_NEAR(1e3 * path, w.path, 0.5e-3);
    EXPECT_NEAR(1e3 * forward, w.forward, 0.5e-2);
  }
}

/// Teeth that touch, counted at evenly spaced angles of the cone by the kinematics.
RC_GTEST_PROP(ContactStatistics, are_those_of_teeth_counted_one_by_one, ()) {
  const int teeth = *integer(1, 40), samples = 4000;
  RollerCone cone = worked_cone;
  cone.journal_angle = *number(0.0, 1.2);
  const double height = 60e-3 * std::cos(cone.journal_angle);
  const double depth = height * *number(0.001, 0.5);
  const RowContact c = row_contact(cone, even_row(teeth), {depth, ratio, speed});
  cone.rows = {even_row(teeth)};
  const double bottom = tooth_state(cone, {80e-3, 60e-3, 0.0}, {}, {}).place.z() - depth;
  std::vector<ToothState> tooth;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < samples; ++i) {
    place_teeth({{cone}}, {}, {Course{-2.0 * pi * (i + 0.5) / samples / teeth, 0.0, 0.0}}, tooth);
    int in = 0;
    for (const ToothState& x : tooth) in += x.place.z() > bottom ? 1 : 0;
    sum += in;
    squares += in * in;
  }
  const double mean = sum / samples;
  constexpr double of_a_sample = 2.0 / samples;  // each end of the contact may miss by one
  RC_ASSERT(std::abs(mean - c.mean) <= of_a_sample);
  RC_ASSERT(std::abs(squares / samples - mean * mean - c.variance) <= 3.0 * of_a_sample);
}

TEST(ContactStatistics, rows_add_means_and_variances) {
  const RowContact a = row_contact(worked_cone, even_row(25), {2e-3, ratio, speed});
  const RowContact b = row_contact(worked_cone, even_row(15), {1e-3, ratio, speed});
  const ContactStatistics both = together({a, b});
  EXPECT_EQ(both.mean, a.mean + b.mean);
  EXPECT_EQ(both.variance, a.variance + b.variance);
}

TEST(ContactStatistics, a_row_above_the_bottom_never_touches_and_a_drowned_one_always) {
  const RowContact above = row_contact(worked_cone, even_row(5), {-1e-3, ratio, speed});
  EXPECT_EQ(above.mean, 0.0);
  const RowContact under = row_contact(worked_cone, even_row(5), {1.0, ratio, 0.0});
  EXPECT_EQ(under.mean, 5.0);
  EXPECT_EQ(under.variance, 0.0);
  EXPECT_EQ(under.duration, 0.0);
}

RollerBit three_cones() {
  RollerBit bit;
  for (int k = 0; k < 3; ++k) {
    bit.cones.push_back(worked_cone);
    bit.cones.back().azimuth = 2.0 * pi * (k - 1) / 3.0;
    bit.cones.back().rows = {even_row(15 + k), even_row(25)};
  }
  return bit;
}

TEST(ContactStatistics, of_a_bit_are_those_of_its_rows) {
  const RollerBit bit = three_cones();
  const BitContact contact = bit_contact(bit, {1.3, ratio, 1.5}, speed, 2e-3);
  ASSERT_EQ(contact.rows.size(), 6U);
  const RowContact third = row_contact(bit.cones[1], bit.cones[1].rows[0], {2e-3, ratio, speed});
  EXPECT_EQ(contact.rows[2].mean, third.mean);
  EXPECT_EQ(contact.rows[2].impressions, third.impressions);
  EXPECT_EQ(contact.all.mean, together(contact.rows).mean);
}

std::string refusal_of(const RollerBit& bit) {
  try {
    bit_contact(bit, {1.0}, speed, 1e-3);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ContactStatistics, reject_bits_that_the_model_does_not_support) {
  EXPECT_EQ(refusal_of({}), "Ma and Azar: found a bit without cones, expected a roller cone bit");
  EXPECT_EQ(refusal_of(three_cones()),
            "Ma and Azar: found 1 cone speeds, expected one for each of 3 cones");
  RollerBit bit = three_cones();
  bit.cones[2].azimuth += 0.125;
  EXPECT_EQ(refusal_of(bit),
            "Ma and Azar: found cone 3 0.125 rad off its place, expected cones at equal angles");
  bit = three_cones();
  bit.cones[1].elevation = 2e-3;
  EXPECT_EQ(refusal_of(bit),
            "Ma and Azar: found cone 2 0.002 m below the first, expected all at one elevation");
}

std::string refusal(const RollerRow& row, double depth) {
  try {
    row_contact(worked_cone, row, {depth, ratio, speed});
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ContactStatistics, reject_rows_that_the_model_does_not_support) {
  RollerRow row = even_row(5);
  row.angles[2] += 0.01;
  EXPECT_EQ(refusal(row, 1e-3),
            "Ma and Azar: found a row of 5 teeth of several pitches, expected teeth at equal "
            "angles");
  EXPECT_EQ(refusal(even_row(0), 1e-3),
            "Ma and Azar: found a row without teeth, expected at least one");
  RollerRow on_the_journal = even_row(1);
  on_the_journal.radius = 0.0;
  EXPECT_EQ(refusal(on_the_journal, 1e-3),
            "Ma and Azar: found a row on its journal, expected one around it");
  EXPECT_EQ(refusal(even_row(5), std::nan("")),
            "Ma and Azar: found a penetration that is not finite, expected metres");
}

/// The bit's angle when tooth j of a row has made its i-th lowest stand, and the print's azimuth.
double print_azimuth(double azimuth, int teeth, double shift, int i) {
  return azimuth + 2.0 * pi * (i + shift) / (teeth * ratio);
}

/// Prints laid one by one: those of a later passage lie as far from the earlier ones as said.
RC_GTEST_PROP(ContactStatistics, prints_are_apart_by_their_offset, ()) {
  const int teeth = *integer(3, 30);
  const double shift = *number(0.0, 1.0);
  const double impressions = teeth * ratio, pitch = 2.0 * pi / impressions;
  // The next cone stands a third of a turn behind and passes a third of a turn later.
  const double next = print_azimuth(-2.0 * pi / 3.0, teeth, shift, 4 * teeth);
  double nearest = 1.0;
  for (int i = 0; i < 8 * teeth; ++i)
    nearest = std::min(nearest, std::abs(next - print_azimuth(0.0, teeth, 0.0, i)) / pitch);
  RC_ASSERT(std::abs(nearest - print_offset(impressions, 1.0 / 3.0, shift)) <= 1e-10);
}

TEST(ContactStatistics, a_row_tracks_when_its_impressions_are_whole) {
  EXPECT_TRUE(tracks(33.0, 1.0));
  EXPECT_FALSE(tracks(33.5, 1.0));
  EXPECT_DOUBLE_EQ(print_offset(33.5, 1.0), 0.5);
  EXPECT_TRUE(tracks(33.0, 1.0 / 3.0));
  EXPECT_FALSE(tracks(34.0, 1.0 / 3.0));
  EXPECT_TRUE(tracks(34.0, 1.0 / 3.0, 1.0 / 3.0));
}

}  // namespace tdbd::reference::contact_statistics_test

namespace tdbd::reference::tooth_law_test {

/// A worked table: mm, kN, mm.
ToothTable worked() {
  return {{0, 0.5e-3, 1e-3, 1.5e-3, 2e-3, 2.5e-3},
          {0, 2e3, 5e3, 9e3, 14e3, 20e3},
          {0, 1.5e-3, 2.6e-3, 3.5e-3, 4.3e-3, 5e-3}};
}

std::string message_of(const ToothLaw& law) {
  try {
    check_tooth_law(law, "Huang and Cawthorne");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

/// A file that goes when the test ends.
struct TableFile {
  std::filesystem::path path;
  explicit TableFile(const std::string& text)
      : path(std::filesystem::temp_directory_path() /
             (std::string("tooth-law-") +
              testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv")) {
    std::ofstream(path) << text;
  }
  ~TableFile() { std::filesystem::remove(path); }
  TableFile(const TableFile&) = delete;
  TableFile& operator=(const TableFile&) = delete;

  std::string message() const {
    try {
      read_tooth_table(path.string(), "Huang and Cawthorne");
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  }
};

TEST(ToothLaw, a_table_is_its_rows_and_straight_between_them) {
  const ToothLaw law = worked();
  EXPECT_EQ(tooth_force(law, 1.5e-3), 9e3);
  EXPECT_NEAR(tooth_force(law, 1.75e-3), 11.5e3, 1e-9);
  EXPECT_NEAR(crater_radius(law, 0.25e-3), 0.75e-3, 1e-15);
  EXPECT_EQ(tooth_force(law, -1e-3), 0.0);
  EXPECT_EQ(crater_radius(law, 0.0), 0.0);
  EXPECT_EQ(tooth_force(law, 9e-3), 20e3);
  EXPECT_EQ(deepest_known(law), 2.5e-3);
}

TEST(ToothLaw, a_power_is_a_power_and_its_crater_a_cap) {
  const ToothLaw law = PowerTooth{5000.0 / std::pow(1e-3, 1.5), 1.5, 6e-3};
  EXPECT_NEAR(tooth_force(law, 1e-3), 5000.0, 1e-9);
  EXPECT_NEAR(tooth_force(law, 4e-3), 40000.0, 1e-8);
  EXPECT_NEAR(crater_radius(law, 6e-3), 6e-3, 1e-15);
  EXPECT_NEAR(crater_radius(law, 1e-3), std::sqrt(11.0) * 1e-3, 1e-15);
  const ToothLaw slow = PowerTooth{5000.0 / std::pow(1e-3, 1.25), 1.25, 6e-3};
  EXPECT_NEAR(tooth_force(slow, 16e-3), 5000.0 * 32.0, 1e-6);
}

RC_GTEST_PROP(ToothLaw, neither_force_nor_crater_falls_with_depth, ()) {
  const ToothLaw law =
      *rc::gen::arbitrary<bool>() ? ToothLaw(worked()) : ToothLaw(PowerTooth{1e8, 1.5, 6e-3});
  const double a = *battery::number(-1.0, 8.0), b = *battery::number(0.0, 1.0);
  RC_ASSERT(tooth_force(law, (a + b) * 1e-3) >= tooth_force(law, a * 1e-3));
  RC_ASSERT(crater_radius(law, (a + b) * 1e-3) >= crater_radius(law, a * 1e-3));
}

TEST(ToothLaw, reports_which_row_is_not_monotone) {
  ToothTable table = worked();
  EXPECT_EQ(message_of(table), "");
  table.force[3] = 4e3;
  EXPECT_EQ(
      message_of(table),
      "Huang and Cawthorne: table of single-tooth tests: row 4: force: found 4000 after 5000, "
      "expected a monotone table");
  table = worked();
  table.depth[2] = table.depth[1];
  EXPECT_NE(message_of(table).find("row 3: depth: found 0.0005 after 0.0005, expected depths that"),
            std::string::npos);
  table = worked();
  table.radius[0] = 1e-3;
  EXPECT_NE(message_of(table).find("row 1: crater_radius: found 0.001, expected 0"),
            std::string::npos);
  table.depth.pop_back();
  EXPECT_NE(message_of(table).find("found 5 depths, 6 forces and 6 radii"), std::string::npos);
  EXPECT_NE(message_of(PowerTooth{-1.0, 1.5, 6e-3}).find("the law's factor: found -1"),
            std::string::npos);
}

TEST(ToothLaw, is_read_in_the_units_of_its_header) {
  const TableFile file(
      "# synthetic\nforce [kN], depth [mm], crater_radius [in]\n0, 0, 0\n2, 0.5, 0.1\n");
  const ToothTable table = read_tooth_table(file.path.string(), "Huang and Cawthorne");
  EXPECT_EQ(table.depth[1], 0.5e-3);
  EXPECT_EQ(table.force[1], 2000.0);
  EXPECT_NEAR(table.radius[1], 2.54e-3, 1e-15);
  EXPECT_EQ(table.lines[1], 4);
}

TEST(ToothLaw, reports_where_a_file_is_wrong) {
  const std::string header = "depth [mm], force [kN], crater_radius [mm]\n";
  EXPECT_NE(TableFile(header + "0, 0, 0\n1, 5, 2\n2, 4, 3\n")
                .message()
                .find(".csv:4: force: found 4000 after 5000, expected a monotone table"),
            std::string::npos);
  EXPECT_NE(TableFile(header + "0, 0, 0\n1, x, 2\n").message().find(":3: force: found x, expected"),
            std::string::npos);
  EXPECT_NE(TableFile(header + "0, 0\n").message().find(":2: crater_radius: found nothing"),
            std::string::npos);
  EXPECT_NE(TableFile("depth, force [kN], crater_radius [mm]\n0,0,0\n1,1,1\n")
                .message()
                .find(":1: depth: found"),
            std::string::npos);
  EXPECT_NE(TableFile("depth [mm], force [kN]\n0,0\n")
                .message()
                .find("crater_radius: found no such column"),
            std::string::npos);
  EXPECT_EQ(TableFile("").message().substr(0, 21), "Huang and Cawthorne: ");
}

}  // namespace tdbd::reference::tooth_law_test
