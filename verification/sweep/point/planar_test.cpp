#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/error.hpp"
#include "simulation/case/case.hpp"
#include "sweep/point/run_point.hpp"

namespace tdbd::sweep::planar_test {

simulation::Case case_with(const std::string& name, std::vector<std::string> settings) {
  settings.emplace_back("rock.edge_length='5 mm'");
  return simulation::read_case(TDBD_SOURCE_DIR "/cases/" + name, settings);
}

/// 15 m/h at 120 rpm are 15 m in 7200 revolutions; all that the bit sinks is cut, from a core of half a
/// millimetre to its rim.
TEST(Planar, cuts_as_deep_as_the_bit_sinks_in_a_revolution) {
  const simulation::Case c = case_with("bit-b-steady.toml", {"motion.rate_of_penetration='15 m/h'",
                                                             "motion.rotary_speed='120 rpm'"});
  const auto found = planar_summary(c, 0.8);
  const double advance = 15.0 / 7200.0;
  EXPECT_NEAR(found["advance_m"], advance, 1e-17);
  EXPECT_LT(found["cut_area_m2"], advance * c.bit.gage_radius);
  EXPECT_GT(found["cut_area_m2"], advance * (c.bit.gage_radius - 0.5e-3));
  EXPECT_GE(found["engaged_cutters"], 22);
  EXPECT_LE(found["engaged_cutters"], c.bit.cutters.size());
  EXPECT_LT(found["largest_cut_area_m2"], found["cut_area_m2"]);
  EXPECT_GE(found["mean_redundancy"], 1.0);
}

/// Half the normal force is half the weight on bit that the side force is divided by.
TEST(Planar, imbalance_of_drag_alone_goes_with_one_over_the_normal_forces) {
  const simulation::Case c = case_with("bit-b-steady.toml", {});
  const auto imbalance = [&](double ratio) -> double {
    return planar_summary(c, ratio)["imbalance"];
  };
  EXPECT_NEAR(imbalance(1e-7) / imbalance(2e-7), 2.0, 8e-9);
  EXPECT_LT(imbalance(0.8), imbalance(0.4));
}

/// Bit B under a sharp law of Detournay: 100 MPa, normal over cutting force 0.7, no friction.
simulation::Case sharp_case(const std::string& rate) {
  return case_with("bit-b-6000psi.toml",
                   {"motion.rate_of_penetration='" + rate + "'",
                    "forces={ law = 'detournay', eps = '100 MPa', zeta = 0.7, slip_speed = 0 }"});
}

/// Cutting costs eps per volume, whatever the layout: 2 pi T + W d = eps pi R^2 d in a revolution.
TEST(Planar, work_of_a_sharp_law_is_that_of_its_volume) {
  const auto found = planar_summary(sharp_case("15 m/h"), 0.8);
  const double R = case_with("bit-b-steady.toml", {}).bit.gage_radius, advance = found["advance_m"];
  const double work = 2.0 * std::numbers::pi * found["tob_n_m"].get<double>() +
                      found["wob_n"].get<double>() * advance;
  EXPECT_NEAR(work / (100e6 * std::numbers::pi * R * R * advance), 1.0, 2e-4);
}

/// With its ratio the classical model is the case's law, up to the slope of the cutters' paths,
/// which is 0.05 at a radius of 1 mm here.
TEST(Planar, imbalance_of_a_sharp_law_is_that_of_the_classical_model) {
  const auto found = planar_summary(sharp_case("2 m/h"), 0.7);
  const double classical = found["imbalance_of_normal_ratio"];
  EXPECT_NEAR(found["imbalance"].get<double>() / classical, 1.0, 2e-2);
  const double other = planar_summary(sharp_case("2 m/h"), 0.4)["imbalance_of_normal_ratio"];
  EXPECT_GT(std::abs(other / classical - 1.0), 0.1);
}

/// Without forces there is no law, and no weight.
TEST(Planar, without_forces_is_the_classical_model) {
  const auto found = planar_summary(case_with("bit-b-steady.toml", {}), 0.8);
  EXPECT_EQ(found["imbalance"], found["imbalance_of_normal_ratio"]);
  EXPECT_TRUE(found["wob_n"].is_null());
}

/// A law for all parts of one blade changes the balance as a law for all cutters cannot.
TEST(Planar, uses_the_laws_of_areas) {
  const auto imbalance = [](std::vector<std::string> settings) -> double {
    return planar_summary(case_with("bit-b-6000psi.toml", std::move(settings)), 0.8)["imbalance"];
  };
  const double plain = imbalance({});
  const double softer = imbalance({"forces.areas.soft={ names = 'cutter-1*/face', A1 = 0.2 }"});
  EXPECT_GT(std::abs(softer / plain - 1.0), 0.01);
}

TEST(Planar, rejects_teeth_and_a_bit_at_rest) {
  EXPECT_THROW(planar_summary(case_with("bit-r-steady.toml", {}), 0.8), InputError);
  const simulation::Case still = case_with("bit-b-steady.toml", {"motion.rate_of_penetration=0"});
  EXPECT_THROW(planar_summary(still, 0.8), InputError);
}

}  // namespace tdbd::sweep::planar_test
