#include <gtest/gtest.h>

#include "simulation/result/summary.hpp"

namespace tdbd::simulation::end_warnings_test {

Case drilling(const std::vector<std::string>& settings) {
  std::vector<std::string> all{"rock.edge_length='4 mm'", "time.duration='4 ms'",
                               "output.means_from=0"};
  all.insert(all.end(), settings.begin(), settings.end());
  return read_case(TDBD_SOURCE_DIR "/cases/drill-bit-b.toml", all);
}

/// The texts after a run whose bit moved like this on the mean.
std::vector<std::string> texts(const Case& c, double rate, double rotary_speed, double removed) {
  Simulation s = start(c);
  s.state.steps_done = c.time.steps;
  if (removed > 0.0) s.state.ledger.removed.add(removed);
  s.statistics.loads.rop = {.count = 4, .mean = rate};
  s.statistics.loads.rotary_speed = {.count = 4, .mean = rotary_speed};
  std::vector<std::string> found;
  for (const CaseWarning& w : end_warnings(c, s)) {
    EXPECT_EQ(w.key, "motion");
    EXPECT_EQ(w.place, c.places.motion);
    found.push_back(w.text);
  }
  return found;
}

using Texts = std::vector<std::string>;

TEST(EndWarnings, are_none_of_a_bit_that_drills) {
  EXPECT_EQ(texts(drilling({}), 0.005, 12.0, 1e-6), Texts{});
}

TEST(EndWarnings, report_a_bit_that_removed_no_rock) {
  EXPECT_EQ(texts(drilling({}), 8.0, 12.0, 0.0), Texts{"the bit removed no rock in 4 steps"});
  EXPECT_EQ(texts(drilling({"motion.start=[0,0,-2]"}), 0.0, 12.0, 0.0),
            Texts{"the bit removed no rock in 4 steps: it stays 1.72 m or more from it"});
}

/// Narrowest are the worn cutters of 19 mm.
TEST(EndWarnings, report_an_advance_that_only_a_body_could_cut) {
  EXPECT_EQ(texts(drilling({}), 7.4, 12.0, 1e-6),
            Texts{"the bit advances 7.4 m/s, 3.87e+03 mm in a revolution: more than the 18.4 mm of "
                  "its narrowest cutting part, so that its body would have to cut"});
  EXPECT_EQ(texts(drilling({}), 0.09, 1e-3, 1e-6), Texts{}) << "slow, and it hardly turns";
  for (const double speed :
       {-12.0, 6.0, 0.1})  // either way round, and at less than a turn a second
    EXPECT_EQ(texts(drilling({}), 7.4, speed, 1e-6).size(), 1U) << speed;
  EXPECT_EQ(texts(drilling({}), 7.4, 0.0, 1e-6), Texts{}) << "it does not turn";
}

/// Of a bit whose rotary speed swings by this share of its mean, which rock resists.
Texts of_swings(double share, const std::string& section_at_face) {
  const Case c = drilling({"measure.section_at_face=" + section_at_face});
  Simulation s = start(c);
  s.state.steps_done = c.time.steps;
  s.state.ledger.removed.add(1e-6);
  s.statistics.loads.rop = {.count = 4, .mean = 5e-3};
  s.statistics.loads.rotary_speed = {.count = 4, .mean = 12.0};
  s.statistics.loads.tob = {.count = 4, .mean = 2e3};
  Trace& t = s.statistics.trace;
  t.dt = 0.1;
  for (const double speed : {1.0 + share, 1.0 - share, 1.0 + share, 1.0 - share}) {
    t.wob.push_back(1e4);
    t.rotary_speed.push_back(12.0 * speed);
    t.centre_W.emplace_back(0.0, 0.0);
  }
  Texts found;
  for (const CaseWarning& w : end_warnings(c, s)) found.push_back(w.text);
  return found;
}

TEST(EndWarnings, report_sections_ahead_of_the_faces_of_a_bit_that_sticks_and_slips) {
  EXPECT_EQ(
      of_swings(0.51, "as_ahead"),
      Texts{"the bit sticks and slips, severity 0.51, so that its depth of cut changes from "
            "turn to turn: measure.section_at_face = \"extrapolated\" is more accurate then"});
  EXPECT_EQ(of_swings(0.49, "as_ahead"), Texts{});
  EXPECT_EQ(of_swings(0.51, "extrapolated"), Texts{});
}

/// Of a bit under a set weight of 30 kN, after 64 steps that alternate by `swing` (N) about `weight`
/// (N), to which `rise` (N) is added in the second half.
Texts of_weights(double weight, double swing, double rise) {
  const Case c = drilling({});
  Simulation s = start(c);
  s.state.steps_done = c.time.steps;
  s.state.ledger.removed.add(1e-6);
  s.statistics.loads.rop = {.count = 64, .mean = 5e-3};
  s.statistics.loads.rotary_speed = {.count = 64, .mean = 12.0};
  s.statistics.loads.wob = {.count = 64, .mean = weight + 0.5 * rise};
  Trace& t = s.statistics.trace;
  t.dt = 0.1;
  for (int i = 0; i < 64; ++i) {
    t.wob.push_back(weight + (i / 4 % 2 == 0 ? swing : -swing) + (i < 32 ? 0.0 : rise));
    t.tob.push_back(2e3);
    t.rop.push_back(5e-3);
    t.rotary_speed.push_back(12.0);
    t.centre_W.emplace_back(0.0, 0.0);
    t.force_B.emplace_back(0.0, 0.0);
  }
  Texts found;
  for (const CaseWarning& w : end_warnings(c, s)) found.push_back(w.text);
  return found;
}

/// By more than one per cent, and by more than the interval of the mean.
TEST(EndWarnings, report_a_weight_that_is_not_the_set_one) {
  EXPECT_EQ(of_weights(30.2e3, 0.0, 0.0), Texts{});
  EXPECT_EQ(of_weights(28e3, 0.0, 0.0),
            Texts{"the mean weight on bit, 28 kN, differs from the set 30 kN by -6.7 %, more than "
                  "its 95 % interval of +-0 kN: the bit still accelerates, or dampers and springs "
                  "of [string] carry the rest; run longer, or change string.axial_damping"});
}

TEST(EndWarnings, report_means_that_drift) {
  EXPECT_EQ(of_weights(30e3, 100.0, 0.0), Texts{});
  EXPECT_EQ(of_weights(28e3, 100.0, 4e3),
            Texts{"the run is too short for its means, which cover 12.2 revolutions: from their "
                  "first to their second half they change, the weight on bit by +12 %; run "
                  "longer, or set a later output.means_from"});
}

TEST(SetWeight, is_the_mean_of_a_table_over_time) {
  const Case c =
      drilling({"motion.weight_on_bit={times=[0, 2e-3], values=[1e4, 3e4], between='linear'}"});
  EXPECT_NEAR(*set_weight(c, 0.0, 4e-3), 25e3, 25e3 * 1e-5) << "held at its last value";
  EXPECT_EQ(set_weight(drilling({}), 0.0, 4e-3), 30e3);
  EXPECT_EQ(set_weight(read_case(TDBD_SOURCE_DIR "/cases/bit-b-3000psi.toml", {}), 0.0, 1.0),
            std::nullopt);
}

TEST(EndWarnings, report_an_advance_that_steps_do_not_resolve) {
  EXPECT_EQ(
      texts(drilling({}), 19.0, 12.0, 1e-6),
      Texts{"the bit advances 19 m/s, 19 mm in a step: more than the 18.4 mm of its narrowest "
            "cutting part"});
}

}  // namespace tdbd::simulation::end_warnings_test
