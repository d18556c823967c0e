#include "bit/report/cone_report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bit/cone/cone_interference.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/cone/cone_parts.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/report/bit_report.hpp"
#include "core/types.hpp"

namespace tdbd::bit::cone_report_test {
namespace {

using Json = nlohmann::json;

/// Bit R, its cones lopsided by a heavy tooth each so that no number is 0.
const Bit& lopsided() {
  static const Bit bit = [] {
    Bit b = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
    for (int k = 0; k < 3; ++k)
      std::ranges::find_if(b.parts, [&](const Part& p) {
        return p.kind == PartKind::tooth && p.cone == k && p.row == 2;
      })->density *= 20.0 + k;
    return b;
  }();
  return bit;
}

const Json& analysis() {
  static const Json json = [] {
    ReportOptions options;
    options.bit_speed = 10.0;
    return Json::parse(analysis_json(lopsided(), options));
  }();
  return json;
}

Vec3 vector_of(const Json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

TEST(ConeReport, has_every_number_of_every_cone) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Cone& cone = lopsided().cones[k];
    const Json& found = analysis().at("cones").at(k);
    const ConeMass m = cone_mass(lopsided(), static_cast<int>(k));
    EXPECT_EQ(found.at("name"), cone.name);
    EXPECT_EQ(found.at("azimuth_rad"), cone.layout.azimuth);
    EXPECT_EQ(found.at("journal_angle_rad"), cone.layout.journal_angle);
    EXPECT_EQ(found.at("offset_m"), cone.layout.offset);
    EXPECT_EQ(found.at("skew_rad"), cone.layout.skew);
    EXPECT_EQ(found.at("apex_m"), cone.layout.apex);
    EXPECT_EQ(vector_of(found.at("axis")), cone.X_BK.R.col(2));
    EXPECT_EQ(vector_of(found.at("origin_m")), cone.X_BK.p);
    EXPECT_EQ(found.at("mass_kg"), m.body_K.mass);
    EXPECT_EQ(found.at("axial_inertia_kg_m2"), m.axial_inertia);
    EXPECT_EQ(found.at("asymmetry"), m.asymmetry);
    EXPECT_EQ(found.at("centre_off_axis_m"), m.centre_off_axis);
  }
}

TEST(ConeReport, has_every_number_of_every_row) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Cone& cone = lopsided().cones[k];
    const Json& rows = analysis().at("cones").at(k).at("rows");
    ASSERT_EQ(rows.size(), cone.layout.rows.size());
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const ToothRow& row = cone.layout.rows[j];
      const RowMeasures r = row_measures(cone, row);
      EXPECT_EQ(rows[j].at("teeth"), row.angles.size());
      EXPECT_EQ(rows[j].at("gage"), row.place == RowPlace::gage);
      EXPECT_EQ(rows[j].at("angles_rad"), row.angles);
      EXPECT_EQ(rows[j].at("tip_cone_radius_m"), r.radius);
      EXPECT_EQ(rows[j].at("tip_bit_radius_m"), r.bit_radius);
      EXPECT_EQ(rows[j].at("tip_height_m"), r.height);
      EXPECT_EQ(rows[j].at("reach_m"), r.reach);
      EXPECT_EQ(rows[j].at("rolling_ratio"), r.rolling_ratio);
    }
  }
}

TEST(ConeReport, has_what_is_assumed_of_every_cone) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double ratio = rolling_ratio_of_gage_row(lopsided().cones[k]);
    const ConeAssumptions a = cone_assumptions(lopsided(), static_cast<int>(k), 10.0, ratio);
    const Json& found = analysis().at("cones").at(k).at("assumptions");
    EXPECT_EQ(found.at("bit_speed_rad_per_s"), 10.0);
    EXPECT_EQ(found.at("cone_ratio"), ratio);
    EXPECT_EQ(found.at("unbalance_force_N"), a.unbalance_force);
    EXPECT_EQ(found.at("unbalance_share_of_weight"), a.unbalance_share);
    EXPECT_EQ(found.at("gravity_torque_N_m"), a.gravity_torque);
    EXPECT_EQ(found.at("inertia_modulation_once"), a.modulation_once);
    EXPECT_EQ(found.at("inertia_modulation_twice"), a.modulation_twice);
    EXPECT_EQ(found.at("cone_frequency_Hz"), a.frequency);
    EXPECT_EQ(found.at("momentum_torque_error_N_m"), a.torque_error);
    EXPECT_EQ(found.at("momentum_torque_error_over_Ic_speed2"), a.torque_share);
  }
}

/// The deepest of many places on the circle that a meridian's point goes round: radius and z.
std::pair<double, double> deepest(const Cone& cone, const ShellPoint& p) {
  constexpr int n = 20000;  // of the circle: depths to r (pi / n)^2 / 2
  Vec3 lowest = cone.X_BK * Vec3(p.r, 0.0, -p.s);
  for (int k = 1; k < n; ++k) {
    const double angle = full_turn * k / n;
    const Vec3 x = cone.X_BK * Vec3(p.r * std::cos(angle), p.r * std::sin(angle), -p.s);
    if (x.z() > lowest.z()) lowest = x;
  }
  return {lowest.head<2>().norm(), lowest.z()};
}

void expect_section(const Cone& cone, const Meridian& meridian, const Json& section) {
  ASSERT_EQ(section.at("meridian_sr_m").size(), meridian.size());
  ASSERT_EQ(section.at("meridian_rz_m").size(), meridian.size());
  for (std::size_t i = 0; i < meridian.size(); ++i) {
    EXPECT_EQ(section.at("meridian_sr_m")[i].at(0), meridian[i].s);
    EXPECT_EQ(section.at("meridian_sr_m")[i].at(1), meridian[i].r);
    const auto [radius, z] = deepest(cone, meridian[i]);
    const Json& there = section.at("meridian_rz_m")[i];
    EXPECT_NEAR(there.at(1).get<double>(), z, 1e-12);
    EXPECT_NEAR(there.at(0).get<double>(), radius, 1e-12);
  }
}

/// Of the shell and of each row: its meridian, and where it is deepest as the cone turns.
TEST(ConeReport, has_the_sections_of_every_cone_where_they_are_deepest) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Cone& cone = lopsided().cones[k];
    const Json& sections = analysis().at("cones").at(k).at("sections");
    ASSERT_EQ(sections.size(), cone.layout.rows.size() + 1);
    EXPECT_EQ(sections[0].at("part"), "shell");
    expect_section(cone, shell_meridian(cone.layout.shell), sections[0]);
    for (std::size_t j = 0; j < cone.layout.rows.size(); ++j) {
      EXPECT_EQ(sections[j + 1].at("part"), fmt::format("row-{}", j + 1));
      expect_section(cone, row_meridian(cone.layout, cone.layout.rows[j]), sections[j + 1]);
    }
  }
}

TEST(ConeReport, has_the_clearances_between_cones) {
  const std::vector<Clearance> clearances = cone_clearances(lopsided().cones);
  const Json& found = analysis().at("clearances");
  ASSERT_EQ(found.size(), clearances.size());
  ASSERT_GE(found.size(), 3U);
  const std::string text = cones_text(lopsided());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Clearance& c = clearances[k];
    EXPECT_EQ(found[k].at("part_a"), c.part_a);
    EXPECT_EQ(found[k].at("part_b"), c.part_b);
    EXPECT_EQ(found[k].at("distance_m"), c.distance);
    EXPECT_EQ(found[k].at("angle_a_rad"), c.angle_a);
    for (const double angle : {c.angle_a, c.angle_b}) {
      EXPECT_GE(angle, 0.0);
      EXPECT_LT(angle, full_turn);
    }
    EXPECT_EQ(found[k].at("angle_b_rad"), c.angle_b);
    EXPECT_EQ(vector_of(found[k].at("place_m")), c.place_B);
    EXPECT_NE(text.find("between cones: " + clearance_text(c) + "\n"), text.npos);
  }
}

/// Lines of a text, each as its words.
std::vector<std::vector<std::string>> words_of(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1);
  std::string word;
  for (const char c : text + "\n") {
    if (c != ' ' && c != '\n') {
      word += c;
      continue;
    }
    if (!word.empty()) lines.back().push_back(std::exchange(word, ""));
    if (c == '\n') lines.emplace_back();
  }
  return lines;
}

/// The text has the rows' numbers in millimetres, the place of each, and counts them from 1.
TEST(ConeReport, lists_every_row_in_millimetres) {
  const auto lines = words_of(cones_text(lopsided()));
  std::size_t line = 0;
  for (const Cone& cone : lopsided().cones) {
    EXPECT_EQ(lines.at(line).at(0), cone.name + ":");
    line += 3;  // two of the cone, one of the columns' names
    int number = 0;
    for (const ToothRow& row : cone.layout.rows) {
      const RowMeasures r = row_measures(cone, row);
      EXPECT_EQ(
          lines.at(line++),
          (std::vector<std::string>{
              std::to_string(++number), std::to_string(row.angles.size()),
              row.place == RowPlace::gage ? "gage" : "inner", fmt::format("{:.3f}", 1e3 * r.radius),
              fmt::format("{:.3f}", 1e3 * r.bit_radius), fmt::format("{:.3f}", 1e3 * r.height),
              fmt::format("{:.3f}", 1e3 * r.reach), fmt::format("{:.4f}", r.rolling_ratio)}));
    }
  }
}

/// A journal's numbers in degrees and millimetres, and the mass of its cone.
TEST(ConeReport, lists_every_cone_in_degrees_and_millimetres) {
  const std::string text = cones_text(lopsided());
  for (int k = 0; k < 3; ++k) {
    const ConeLayout& c = lopsided().cones[static_cast<std::size_t>(k)].layout;
    const ConeMass m = cone_mass(lopsided(), k);
    EXPECT_NE(text.find(fmt::format("azimuth {:.2f} deg, journal 36.00 deg, offset 4.00 mm, skew "
                                    "1.50 deg, apex {:.3f} mm\n",
                                    120.0 * k, 1e3 * c.apex)),
              text.npos)
        << text;
    EXPECT_NE(text.find(fmt::format("mass {:.4f} kg, Ic {:.6f} kg m2, asymmetry {:.2e}, centre "
                                    "{:.4f} mm off the axis",
                                    m.body_K.mass, m.axial_inertia, m.asymmetry,
                                    1e3 * m.centre_off_axis)),
              text.npos)
        << text;
  }
}

/// Of legs, too, and none of a bit without them.
TEST(ConeReport, has_the_gaps_between_legs_and_cones) {
  const std::vector<LegClearance> gaps = leg_clearances(lopsided());
  const Json& found = analysis().at("leg_clearances");
  ASSERT_EQ(found.size(), 9U);
  ASSERT_EQ(gaps.size(), 9U);
  const std::string text = cones_text(lopsided());
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    EXPECT_EQ(found[k].at("leg"), gaps[k].leg);
    EXPECT_EQ(found[k].at("part"), gaps[k].part);
    EXPECT_EQ(found[k].at("distance_m"), gaps[k].distance);
    EXPECT_EQ(found[k].at("angle_rad"), gaps[k].angle);
    EXPECT_EQ(vector_of(found[k].at("place_m")), gaps[k].place_B);
    EXPECT_NE(text.find("between legs and cones: " + clearance_text(gaps[k]) + "\n"), text.npos);
  }
  Bit bare = lopsided();
  std::erase_if(bare.parts, [](const Part& p) { return p.name.starts_with("leg-"); });
  EXPECT_EQ(cones_text(bare).find("legs"), std::string::npos);
}

TEST(ConeReport, lists_the_assumptions_of_every_cone) {
  const std::string text = assumptions_text(lopsided(), 10.0);
  EXPECT_EQ(std::ranges::count(text, '\n'), 3);
  for (int k = 0; k < 3; ++k) {
    const Cone& cone = lopsided().cones[static_cast<std::size_t>(k)];
    const ConeAssumptions a =
        cone_assumptions(lopsided(), k, 10.0, rolling_ratio_of_gage_row(cone));
    EXPECT_NE(text.find(fmt::format("{}: assumptions at 10.000 rad/s of the bit, {:.3f} Hz of the "
                                    "cone: unbalance {:.3g} N ({:.2g} of the weight), gravity "
                                    "{:.3g} N m, bit's inertia modulated by {:.2g} once and {:.2g} "
                                    "twice a turn, cone's momentum equation wrong by at most "
                                    "{:.3g} N m\n",
                                    cone.name, a.frequency, a.unbalance_force, a.unbalance_share,
                                    a.gravity_torque, a.modulation_once, a.modulation_twice,
                                    a.torque_error)),
              text.npos)
        << text;
  }
}

}  // namespace
}  // namespace tdbd::bit::cone_report_test
