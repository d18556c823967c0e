#include "bit/report/body_report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bit/body/bit_body.hpp"
#include "bit/cone/cone_measures.hpp"
#include "bit/cone/tracking.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/profile/bit_analysis.hpp"
#include "bit/report/bit_report.hpp"
#include "bit/report/cone_report.hpp"
#include "core/error.hpp"

namespace tdbd::bit::body_report_test {

constexpr double advance = 3e-3;  ///< m per revolution

const Bit& bladed() {
  static const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/generated.toml");
  return bit;
}

Rubbing rubbing_of_body() {
  const auto body = std::ranges::find(bladed().parts, PartKind::bit_body, &Part::kind);
  return rubbing(bladed().cutters, *body, advance, report_column_width);
}

Vec3 vector_of(const nlohmann::json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

TEST(BodyReport, has_the_blades_and_how_close_they_come_to_the_rock) {
  const nlohmann::json found = body_json(bladed(), advance);
  const Rubbing r = rubbing_of_body();
  EXPECT_EQ(found.at("exposure_m"), bladed().blades->exposure);
  EXPECT_EQ(found.at("slot_depth_m"), bladed().blades->slot_depth);
  EXPECT_EQ(found.at("junk_slot_area_m2"), bladed().blades->junk_slot_area);
  EXPECT_EQ(found.at("least_axial_clearance_m"), r.clearance);
  EXPECT_EQ(vector_of(found.at("least_axial_clearance_at_m")), r.clearance_at_B);
  EXPECT_EQ(found.at("touches_at_m_per_rev"), r.touching_advance);
  EXPECT_EQ(vector_of(found.at("touches_first_at_m")), r.touching_at_B);
  EXPECT_EQ(found.at("points_measured"), r.points);
  EXPECT_EQ(found.at("points_over_uncut_rock"), r.over_uncut);
}

TEST(BodyReport, states_whether_the_body_cuts_or_rubs) {
  Bit bit = bladed();
  const auto body = std::ranges::find(bit.parts, PartKind::bit_body, &Part::kind);
  for (const Cutting cutting : {Cutting::cuts, Cutting::rubs, Cutting::never}) {
    body->cutting = cutting;
    const nlohmann::json found = body_json(bit, advance);
    EXPECT_EQ(found.at("cuts"), cutting == Cutting::cuts);
    EXPECT_EQ(found.at("rubs"), cutting == Cutting::rubs);
  }
}

std::string place(const Vec3& x_B) {
  return fmt::format("(radius {:.2f} mm, height {:.2f} mm)", 1e3 * std::hypot(x_B.x(), x_B.y()),
                     -1e3 * x_B.z());
}

TEST(BodyReport, is_in_millimetres) {
  const Rubbing r = rubbing_of_body();
  const BladeDimensions& b = *bladed().blades;
  const nlohmann::json curve = body_json(bladed(), advance).at("weight_over_depth_of_cut");
  EXPECT_EQ(
      body_text(bladed(), advance),
      fmt::format(
          "blades: exposure {:.3f} mm, slots {:.3f} mm deep, junk slot area {:.1f} "
          "mm2\nbody: at 3.000 mm per revolution it clears the rock by "
          "{:.3f} mm along the axis {}\n  it touches the rock from {:.3f} mm per "
          "revolution on {}\nestimated weight on bit: {:.3g} N per mm of depth of cut and MPa "
          "of rock strength; {:.3g} N once the body touches\n",
          1e3 * b.exposure, 1e3 * b.slot_depth, 1e6 * b.junk_slot_area, 1e3 * r.clearance,
          place(r.clearance_at_B), 1e3 * r.touching_advance, place(r.touching_at_B),
          1e3 * curve.at("slope_m").get<double>(),
          1e3 * curve.at("slope_beyond_touch_m").get<double>()));
  Bit bare = bladed();
  bare.blades.reset();
  EXPECT_EQ(body_text(bare, advance), "");
}

/// A body that is lowered until it touches, and until it is lower than the cutters.
TEST(BodyReport, states_that_a_body_rubs) {
  const double touching = 1e3 * rubbing_of_body().touching_advance;
  EXPECT_NE(body_text(bladed(), 2e-3 * touching).find("mm per revolution: it is "),
            std::string::npos);
  Bit proud = bladed();
  const auto body = std::ranges::find(proud.parts, PartKind::bit_body, &Part::kind);
  body->X_BP.p.z() += 30e-3;
  const std::string text = body_text(proud, advance);
  EXPECT_NE(text.find("body: stands proud of the cutters by "), std::string::npos) << text;
  EXPECT_NE(text.find("it rubs at any depth of cut\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("by -"), std::string::npos) << text;
  const nlohmann::json found = body_json(proud, advance);
  EXPECT_GT(found.at("stands_proud_m").get<double>(), 10e-3);
  EXPECT_EQ(body_json(bladed(), advance).at("stands_proud_m"), 0.0);
}

Bit three_cutters() {
  Bit bit;
  for (const int id : {4, 7, 9}) bit.cutters.emplace_back().id = id;
  return bit;
}

TEST(OverlapReport, sums_the_pairs_and_names_the_worst) {
  const Bit bit = three_cutters();
  const std::vector<CutterOverlap> pairs{{0, 1, 2e-9}, {1, 2, 5e-9}};
  const auto json = overlaps_json(bit, pairs);
  EXPECT_DOUBLE_EQ(json.at("volume_m3").get<double>(), 7e-9);
  EXPECT_EQ(json.at("pairs").size(), 2U);
  EXPECT_EQ(json.at("pairs")[1].at("a"), "cutter-7");
  EXPECT_EQ(json.at("pairs")[1].at("b"), "cutter-9");
  const std::string text = overlaps_text(bit, pairs);
  EXPECT_NE(text.find("2 pairs of cutters overlap by 7.0 mm3, which the mass counts twice"),
            text.npos)
      << text;
  EXPECT_NE(text.find("5.0 mm3, cutters 7 and 9"), text.npos) << text;
  EXPECT_EQ(overlaps_text(bit, {}), "");
  EXPECT_EQ(overlaps_text(bit, {pairs.front()}),
            "warning: cutters 4 and 7 overlap by 2.0 mm3, which the mass counts twice\n");
}

const Bit& bit_r() {
  static const Bit bit = read(TDBD_SOURCE_DIR "/cases/bits/bit-r.toml");
  return bit;
}

nlohmann::ordered_json report_of(const Bit& bit, const ConeOperation& operation) {
  nlohmann::ordered_json file = {{"cones", nlohmann::ordered_json::array()}};
  for (const Cone& cone : bit.cones)
    file["cones"].push_back(
        {{"rows", std::vector<nlohmann::ordered_json>(cone.layout.rows.size(),
                                                      nlohmann::ordered_json::object())}});
  add_tracking(bit, operation, file);
  return file;
}

/// Of bit R with speeds of its cones that differ.
const nlohmann::ordered_json& report() {
  static const nlohmann::ordered_json json = report_of(bit_r(), {{1.3, 1.4, 1.5}, 4e-3});
  return json;
}

/// Of each cone by its own rows, and of them alone.
TEST(TrackingReport, gives_each_cone_the_shares_of_its_rows) {
  const Bit& bit = bit_r();
  const ConeOperation operation = cone_operation(bit, {}, 5e-3);
  const nlohmann::ordered_json file = report_of(bit, operation);
  const auto rows = bit_rows(bit, operation.penetration);
  const auto shares =
      tracking(rows, operation.cone_speeds, {.penetration = operation.penetration, .lags = 6});
  for (std::size_t k = 0; k < bit.cones.size(); ++k) {
    std::vector<TrackingShare> own;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].cone == static_cast<int>(k)) own.push_back(shares[i]);
    const TrackingShare expected = combined(own);
    EXPECT_EQ(file["cones"][k]["tracking_share_by_lag"].get<std::vector<double>>(), expected.share);
    EXPECT_EQ(file["cones"][k]["tracking_share_random_phase"].get<double>(), expected.random_phase);
  }
}

/// The share, at a random phase and by lags, of prints; of none there is no share.
void expect_shares(const nlohmann::ordered_json& found, const TrackingShare& t) {
  EXPECT_EQ(found.at("tracking_share_by_lag").get<std::vector<double>>(), t.share);
  EXPECT_EQ(found.at("tracking_share").is_null(), t.prints == 0);
  EXPECT_EQ(found.at("tracking_share_random_phase").is_null(), t.prints == 0);
  if (t.prints == 0) return;
  EXPECT_EQ(found.at("tracking_share"), t.share.front());
  EXPECT_EQ(found.at("tracking_share_random_phase"), t.random_phase);
}

/// The nose tooth of the first cone stands on the journal: it never lets go, and has no prints.
TEST(TrackingReport, has_every_row_with_prints_or_without) {
  const Bit& bit = bit_r();
  const std::vector<double> speeds{1.3, 1.4, 1.5};
  const auto rows = bit_rows(bit, 4e-3);
  const auto shares = tracking(rows, speeds, {.penetration = 4e-3, .lags = 6});
  ASSERT_NE(rows.front().row, 0);  // which is that of the nose
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t j = 0; j < bit.cones[k].layout.rows.size(); ++j) {
      const ToothRow& row = bit.cones[k].layout.rows[j];
      const auto& found = report().at("cones")[k].at("rows")[j];
      EXPECT_EQ(found.at("prints_per_revolution"),
                speeds[k] * static_cast<double>(row.angles.size()));
      EXPECT_EQ(found.at("tooth_contact_ratio"), tooth_contact_ratio(bit.cones[k], row, 4e-3));
      const auto at = std::ranges::find_if(rows, [&](const BitRow& r) {
        return r.cone == static_cast<int>(k) && r.row == static_cast<int>(j);
      });
      const bool prints = at != rows.end();
      EXPECT_EQ(found.at("print_width_m"), prints ? at->ring.width : 0.0);
      expect_shares(found,
                    prints ? shares[static_cast<std::size_t>(at - rows.begin())] : TrackingShare{});
    }
}

TEST(TrackingReport, has_the_whole_bit_and_its_settings) {
  const auto& whole = report().at("tracking");
  EXPECT_EQ(whole.at("penetration_m"), 4e-3);
  EXPECT_EQ(whole.at("share_of_width"), 0.25);
  EXPECT_EQ(whole.at("revolutions"), 20);
  expect_shares(whole, combined(tracking(bit_rows(bit_r(), 4e-3), {1.3, 1.4, 1.5},
                                         {.penetration = 4e-3, .lags = 6})));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(report().at("cones")[k].at("speed_ratio"), (std::vector{1.3, 1.4, 1.5})[k]);
    EXPECT_EQ(report().at("cones")[k].at("rolling_ratio_gage_row"),
              rolling_ratio_of_gage_row(bit_r().cones[k]));
  }
}

/// Of five revolutions with all cones at one speed, from 1 to 1.8.
TEST(TrackingReport, sweeps_the_speed_of_the_cones) {
  const auto& sweep = report().at("tracking").at("sweep");
  const auto ratios = sweep.at("speed_ratio").get<std::vector<double>>();
  ASSERT_EQ(ratios.size(), 161U);
  ASSERT_EQ(sweep.at("tracking_share").size(), 161U);
  ASSERT_EQ(sweep.at("tracking_share_random_phase").size(), 161U);
  const auto rows = bit_rows(bit_r(), 4e-3);
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    EXPECT_NEAR(ratios[k], 1.0 + 0.8 * static_cast<double>(k) / 160.0, 1e-15 * 2.0);
    const TrackingShare t = combined(tracking(rows, {ratios[k], ratios[k], ratios[k]},
                                              {.penetration = 4e-3, .revolutions = 5, .lags = 1}));
    EXPECT_EQ(sweep.at("tracking_share")[k], t.share.front());
    EXPECT_EQ(sweep.at("tracking_share_random_phase")[k], t.random_phase);
  }
}

TEST(TrackingReport, lists_rows_in_percent_and_millimetres) {
  const std::string text = tracking_text(bit_r(), {{1.3, 1.4, 1.5}, 4e-3});
  std::size_t lines = 2;  // the columns' names, and all rows
  for (std::size_t k = 0; k < 3; ++k) {
    const Cone& cone = bit_r().cones[k];
    for (std::size_t j = 0; j < cone.layout.rows.size(); ++j, ++lines) {
      const auto& row = report().at("cones")[k].at("rows")[j];
      std::string line = fmt::format("{:<8} {:>3} {:>6.3f} {:>7.2f}", cone.name, j + 1,
                                     1.3 + 0.1 * static_cast<double>(k),
                                     row.at("tooth_contact_ratio").get<double>());
      if (!row.at("tracking_share").is_null())
        line += fmt::format(" {:>10.1f} {:>9.2f} {:>10.1f} {:>12.1f}",
                            row.at("prints_per_revolution").get<double>(),
                            1e3 * row.at("print_width_m").get<double>(),
                            1e2 * row.at("tracking_share").get<double>(),
                            1e2 * row.at("tracking_share_random_phase").get<double>());
      EXPECT_NE(text.find(line + "\n"), text.npos) << line << "\nin\n" << text;
    }
  }
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(text, '\n')), lines);
  const auto& all = report().at("tracking");
  EXPECT_NE(text.find(fmt::format("all rows: {:.1f} % of the prints fall into one of the last "
                                  "revolution (closer than 0.25 of a width), {:.1f} % at random "
                                  "phase\n",
                                  1e2 * all.at("tracking_share").get<double>(),
                                  1e2 * all.at("tracking_share_random_phase").get<double>())),
            text.npos)
      << text;
}

TEST(TrackingReport, is_empty_without_cones) {
  Bit bare;
  EXPECT_EQ(tracking_text(bare, {}), "");
  nlohmann::ordered_json file = nlohmann::ordered_json::object();
  add_tracking(bare, {}, file);
  EXPECT_TRUE(file.empty());
}

std::string refusal(const std::vector<double>& speeds) {
  try {
    cone_operation(bit_r(), speeds, 5e-3);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ConeOperation, takes_one_speed_for_each_cone_or_lets_gage_rows_roll) {
  EXPECT_EQ(cone_operation(bit_r(), {1.1, 1.2, 99.9}, 4e-3).cone_speeds,
            (std::vector<double>{1.1, 1.2, 99.9}));
  EXPECT_EQ(cone_operation(bit_r(), {}, 4e-3).penetration, 4e-3);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(cone_operation(bit_r(), {}, 4e-3).cone_speeds[k],
              rolling_ratio_of_gage_row(bit_r().cones[k]));
  EXPECT_EQ(refusal({1.1, 1.2}),
            "--cone-speeds: found 2 speeds, expected one for each of the 3 cones");
  const std::string expected = ", expected speeds over the bit's, above 0 and below 100";
  EXPECT_EQ(refusal({1.1, 0.0, 1.2}), "--cone-speeds: found 0" + expected);
  EXPECT_EQ(refusal({1.1, 1.2, 100.0}), "--cone-speeds: found 100" + expected);
  EXPECT_EQ(refusal({1e-3, 1.2, -0.5}), "--cone-speeds: found -0.5" + expected);
}

}  // namespace tdbd::bit::body_report_test
