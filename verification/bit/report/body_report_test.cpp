#include "bit/report/body_report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bit/body/rubbing.hpp"
#include "bit/files/bit_reading.hpp"
#include "bit/profile/engagement.hpp"

namespace tdbd::bit::body_report_test {
namespace {

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

TEST(BodyReport, tells_whether_the_body_cuts_or_rubs) {
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

TEST(BodyReport, tells_it_in_millimetres) {
  const Rubbing r = rubbing_of_body();
  const BladeFigures& b = *bladed().blades;
  const nlohmann::json curve = body_json(bladed(), advance).at("weight_over_depth_of_cut");
  EXPECT_EQ(body_text(bladed(), advance),
            fmt::format("blades: exposure {:.3f} mm, slots {:.3f} mm deep, junk slot area {:.1f} "
                        "mm2\nrubbing: at 3.000 mm per revolution the blades clear the rock by "
                        "{:.3f} mm along the axis {}\n  they touch it from {:.3f} mm per "
                        "revolution on {}\nweight over depth of cut, in rock of strength S: {:.3g} "
                        "N/mm per MPa of S before they touch, {:.3g} beyond\n",
                        1e3 * b.exposure, 1e3 * b.slot_depth, 1e6 * b.junk_slot_area,
                        1e3 * r.clearance, place(r.clearance_at_B), 1e3 * r.touching_advance,
                        place(r.touching_at_B), 1e3 * curve.at("slope_m").get<double>(),
                        1e3 * curve.at("slope_beyond_touch_m").get<double>()));
  Bit bare = bladed();
  bare.blades.reset();
  EXPECT_EQ(body_text(bare, advance), "");
}

}  // namespace
}  // namespace tdbd::bit::body_report_test
