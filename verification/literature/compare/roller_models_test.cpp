#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>

#include "reference/compare/models/roller_case.hpp"
#include "reference/literature/drag/spokes/hanson_hansen_cones.hpp"
#include "reference/literature/roller/bands/sheppard_lesage.hpp"
#include "reference/literature/roller/craters/huang_cawthorne.hpp"
#include "reference/literature/roller/craters/ma_zhou_deng.hpp"
#include "reference/literature/roller/teeth/contact_run.hpp"
#include "reference/literature/roller/teeth/contact_statistics.hpp"
#include "reference/literature/roller/teeth/ma_azar.hpp"
#include "reference/literature/roller/wheel/briggs_bit.hpp"
#include "reference/literature/roller/wheel/winters.hpp"
#include "verification/literature/compare/model_runs.hpp"

namespace tdbd::reference::roller_models_test {
namespace {

constexpr double weight = 28e3;     // N
constexpr double rounding = 1e-12;  // of sums in another order
constexpr double circle = 2.0 * std::numbers::pi;
constexpr std::size_t outer_row = 1;  // of bit R's first cone

/// Bit R, coarse, with what no model needs to find.
CompareCase bit_r(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides{"rock.edge_length='4 mm'", "time.step='2 ms'",
                                     "time.revolutions=2", "compare.spokes.spokes=24",
                                     "compare.spokes.spacing='4 mm'"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return model_runs::compare_case("bit-r", overrides);
}

RollerBit bit_of(const CompareCase& c) { return roller_bit_of(c.ours.bit); }

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum;
}

TEST(RollerModels, sheppard_and_lesage_agree_with_their_bands) {
  const CompareCase c = bit_r({"compare.roller.specific_energy='80 MPa'"});
  const Findings f = model_runs::run(c, "sheppard-lesage", weight);
  const BandRock rock{80e6, c.options.roller.normal_ratio};
  BandOptions options;
  options.half_angle = c.options.roller.half_angle;
  const double speed = c.ours.motion.rotary_speed;
  const SheppardLesage at = sheppard_lesage(bit_of(c), rock, speed, c.advance, options),
                       under = sheppard_lesage_under(bit_of(c), rock, speed, weight, options);
  EXPECT_EQ(model_runs::value(f, Quantity::weight), at.weight);
  EXPECT_EQ(model_runs::value(f, Quantity::torque), at.torque);
  EXPECT_EQ(model_runs::value(f, Quantity::rate_at_weight), under.rate);
  EXPECT_EQ(model_runs::value(f, Quantity::torque_at_weight), under.torque);
  const std::vector<double> ratios =
      model_runs::of_parts(f, PartQuantity::cone_speed_ratio, PartLevel::cone);
  ASSERT_EQ(ratios.size(), at.cones.size());
  for (std::size_t k = 0; k < ratios.size(); ++k) EXPECT_EQ(ratios[k], at.cones[k].ratio);
}

/// A specific energy found from the reference weight needs that weight at the case's rate.
TEST(RollerModels, sheppard_and_lesage_meet_a_weight_from_which_their_energy_is_found) {
  const CompareCase c = bit_r();
  const Findings f = model_runs::run(c, "sheppard-lesage", weight);
  const double root = 1e-6;  // of Brent's searches, nested
  EXPECT_NEAR(model_runs::value(f, Quantity::weight) / weight, 1.0, rounding);
  EXPECT_NEAR(model_runs::value(f, Quantity::rate_at_weight) / c.ours.motion.rate_of_penetration,
              1.0, root);
  EXPECT_EQ(f.notes.size(), 1u);
}

/// The mean of the counted revolution is nearly that of the statistics: cones turn 5/3 times, so that the rows of all
/// three together turn almost whole pitches.
TEST(RollerModels, ma_and_azar_find_the_teeth_that_the_kinematics_put_into_a_flat_bottom) {
  const CompareCase c = bit_r();
  const Findings f = model_runs::run(c, "ma-azar", weight);
  const RollerBit bit = bit_of(c);
  const std::vector<double> ratios(bit.cones.size(),
                                   rolling_ratio(bit.cones[0], bit.cones[0].rows[outer_row]));
  const double end = c.ours.time.step * static_cast<double>(c.ours.time.steps),
               counted = c.ours.time.step * static_cast<double>(counted_steps(c));
  const ContactRun run =
      contact_run(bit, {ratios, c.ours.motion.rotary_speed, c.advance, end, end - counted, 1e-3});
  EXPECT_NEAR(model_runs::value(f, Quantity::teeth_in_contact), run.mean, rounding);
  EXPECT_NEAR(model_runs::value(f, Quantity::teeth_in_contact_variance), run.variance, rounding);
  for (const PartLevel level : {PartLevel::tooth, PartLevel::row, PartLevel::cone})
    EXPECT_NEAR(model_runs::sum_of_parts(f, PartQuantity::teeth_in_contact, level), run.mean,
                rounding);
  constexpr double of_a_pitch = 1.5e-5;  // of the mean; seen: 6e-6
  const BitContact closed = bit_contact(bit, ratios, c.ours.motion.rotary_speed, c.advance);
  EXPECT_NEAR(model_runs::value(f, Quantity::teeth_in_contact) / closed.all.mean, 1.0, of_a_pitch);
}

/// The shipped bit R: skewed journals, rows of several pitches, one tooth on a journal.
TEST(RollerModels, answer_about_the_shipped_bit_r_with_its_skewed_journals) {
  const CompareCase c = model_runs::compare_case(
      "bit-r-skewed", {"rock.edge_length='6 mm'", "time.step='4 ms'", "time.revolutions=1.5",
                       "compare.spokes.spokes=24", "compare.spokes.spacing='4 mm'"});
  std::set<std::string> ours;
  for (const PartFinding& p : model_runs::run(c, "tdbd", weight).parts) ours.insert(p.part);
  for (const char* name : {"hanson-hansen", "briggs", "ma-azar", "ma-zhou-deng",
                           "huang-cawthorne-1", "huang-cawthorne-2", "sheppard-lesage"}) {
    const Findings f = model_runs::run(c, name, weight);
    for (const PartFinding& p : f.parts)
      EXPECT_TRUE(ours.contains(p.part)) << name << ": " << p.part;
  }
  const Findings bands = model_runs::run(c, "sheppard-lesage", weight);
  EXPECT_EQ(bands.notes.back(), "rows left out, whose teeth are on the journal's axis: 1");
  EXPECT_EQ(model_runs::of_parts(bands, PartQuantity::volume_per_revolution, PartLevel::row).size(),
            13u);
}

/// Cohesion of a rock of 100 MPa without friction: half of it.
TEST(RollerModels, briggs_agrees_with_sprockets_of_the_outer_row) {
  const CompareCase c = bit_r();
  const Findings f = model_runs::run(c, "briggs", weight);
  const RollerBit bit = bit_of(c);
  const double width = 2.0 * bit.cones[0].rows[outer_row].tooth_radius;
  const BriggsBit wheels = briggs_bit(bit, 0, outer_row, c.options.roller.tooth_half_angle, width);
  CoulombRock rock;
  rock.friction_angle = 0.0;
  rock.cohesion = 50e6;
  const BriggsDrilling d = briggs_under_weight(wheels, rock, weight, c.ours.motion.rotary_speed);
  EXPECT_EQ(model_runs::value(f, Quantity::rate_at_weight), d.rate);
  EXPECT_EQ(model_runs::value(f, Quantity::torque_at_weight), d.torque);
  EXPECT_EQ(model_runs::value(f, Quantity::cone_speed_ratio), d.cone_ratio);
}

TEST(RollerModels, winters_finds_the_rate_of_a_fit_to_known_ones) {
  const CompareCase c = bit_r({"compare.winters.weights=['20 kN', '40 kN', '80 kN']",
                               "compare.winters.rates=['2 m/h', '6 m/h', '15 m/h']"});
  const Findings f = model_runs::run(c, "winters", 40e3);
  EXPECT_NEAR(model_runs::value(f, Quantity::rate_at_weight), 6.0 / 3600.0, 1e-9 * 6.0 / 3600.0);
}

/// The schedule of models that run under a weight: two revolutions, the last of which counts, in steps of 0.25 ms.
RollerSchedule schedule_of(const CompareCase& c) {
  RollerSchedule s;
  s.bit_speed = c.ours.motion.rotary_speed;
  s.weight = weight;
  s.step = 0.25e-3;
  s.revolutions = c.ours.time.step * static_cast<double>(c.ours.time.steps) * s.bit_speed / circle;
  s.settle = s.revolutions - c.options.counted_revolutions;
  return s;
}

CraterDrillingOptions with_case(CraterDrillingOptions o, const CompareCase& c) {
  o.sliding.friction = tooth_friction(c, o.model);
  o.print.sphere_radius = largest_tooth(bit_of(c));
  o.first_ratio = outer_rolling_ratio(bit_of(c));
  return o;
}

void expect_run(const Findings& f, const RollerRun& run, const RollerSchedule& schedule) {
  EXPECT_EQ(model_runs::value(f, Quantity::rate_at_weight), run.rate);
  EXPECT_EQ(model_runs::value(f, Quantity::torque_at_weight), run.torque);
  EXPECT_EQ(model_runs::value(f, Quantity::teeth_in_contact), run.contacts);
  EXPECT_NEAR(model_runs::sum_of_parts(f, PartQuantity::teeth_in_contact, PartLevel::tooth),
              run.contacts, rounding * run.contacts);
  EXPECT_NEAR(model_runs::value(f, Quantity::cone_speed_ratio),
              -sum_of(run.cone_ratio) / static_cast<double>(run.cone_ratio.size()), rounding);
  EXPECT_NEAR(model_runs::sum_of_parts(f, PartQuantity::force_into_rock, PartLevel::tooth),
              sum_of(run.tooth_force), rounding * weight);
  EXPECT_NEAR(model_runs::sum_of_parts(f, PartQuantity::volume_per_revolution, PartLevel::tooth) *
                  schedule.revolutions,
              sum_of(run.tooth_volume), rounding);
}

TEST(RollerModels, ma_zhou_and_deng_agree_with_their_craters) {
  const CompareCase c = bit_r();
  const ToothTable table = tooth_table_of(c, bit_of(c), "Ma, Zhou and Deng");
  MaZhouDengOptions options;
  options.drilling = with_case(options.drilling, c);
  expect_run(model_runs::run(c, "ma-zhou-deng", weight),
             ma_zhou_deng(bit_of(c), table, schedule_of(c), options), schedule_of(c));
}

TEST(RollerModels, huang_and_cawthorne_agree_with_both_of_their_methods) {
  const CompareCase c = bit_r();
  const ToothTable table = tooth_table_of(c, bit_of(c), "Huang and Cawthorne");
  for (const auto& [name, way] : {std::pair("huang-cawthorne-1", PatentMethod::first),
                                  std::pair("huang-cawthorne-2", PatentMethod::second)}) {
    HuangCawthorneOptions options;
    options.way = way;
    options.drilling = with_case(options.drilling, c);
    options.first_ratio = options.drilling.first_ratio;
    expect_run(model_runs::run(c, name, weight),
               huang_cawthorne(bit_of(c), table, schedule_of(c), options), schedule_of(c));
  }
}

/// A long time step locks teeth into prints, so that these models use the smaller of 0.25 ms and
/// the step of the case; a note reports it.
TEST(RollerModels, of_craters_step_no_longer_than_a_quarter_of_a_millisecond) {
  const Findings fine = model_runs::run(bit_r({"time.step='0.2 ms'"}), "ma-zhou-deng", weight),
                 coarse = model_runs::run(bit_r(), "ma-zhou-deng", weight);
  EXPECT_EQ(coarse.series.step, 0.25e-3);
  EXPECT_EQ(coarse.notes.size(), 1u);
  EXPECT_EQ(fine.series.step, 0.2e-3);
  EXPECT_EQ(fine.notes.size(), 0u);
  EXPECT_NEAR(static_cast<double>(coarse.series.torque.size()) * 0.25e-3, 2.0 / 3.0, 0.25e-3);
}

/// Loads of rows are shares of the bit's, which is on average the weight; volumes are shares of a revolution's.
void expect_rows_to_carry(const Findings& f) {
  constexpr double bounce =
      5e-3;  // of the weight, by which momentum changes in a revolution; seen: 2e-3
  const double carried = noise_of(f.series.weight, 1).mean;
  EXPECT_NEAR(model_runs::sum_of_parts(f, PartQuantity::force_into_rock, PartLevel::tooth), carried,
              rounding * weight);
  EXPECT_NEAR(carried / weight, 1.0, bounce);
  const double removed = model_runs::value(f, Quantity::removed_per_revolution);
  EXPECT_NEAR(
      model_runs::sum_of_parts(f, PartQuantity::volume_per_revolution, PartLevel::tooth) / removed,
      1.0, rounding);
}

/// Flat rock under a soft spring, and a bit that turns evenly, as the comparison sets them up.
HansonHansenCones cones_of(const CompareCase& c) {
  constexpr double spring = 10.0, inertia = 1e6;  // m, kg m2
  ConesSetup s;
  s.system.stiffness = Vec3(0.0, 0.0, weight / spring).asDiagonal();
  s.system.top_z = spring;
  s.system.inertia = inertia;
  s.system.rate = c.ours.motion.rate_of_penetration;
  s.system.speed = c.ours.motion.rotary_speed;
  s.rock.pressure = 100e6;
  s.rock.friction = tooth_friction(c, "Hanson and Hansen");
  s.layout = {c.options.spokes, c.options.spoke_spacing};
  s.depth = 0.5;
  s.cone_ratio = outer_rolling_ratio(bit_of(c));
  return hanson_hansen_cones(bit_of(c), s);
}

/// 3 s until the bottom is the bit's own, then the revolution that counts, in steps of 0.1 ms.
TEST(RollerModels, hanson_and_hansen_agree_with_their_cones) {
  constexpr long before = 30'000, counted = 6'667;
  const CompareCase c = bit_r();
  const Findings f = model_runs::run(c, "hanson-hansen", weight);
  HansonHansenCones m = cones_of(c);
  for (long i = 0; i < before; ++i) advance(m);
  const HansonHansenState from = m.state;
  const double removed = m.removed;
  for (long i = 0; i < counted; ++i) advance(m);
  EXPECT_EQ(f.cost.steps, before + counted);
  EXPECT_EQ(model_runs::value(f, Quantity::rate_at_weight),
            (m.state[2] - from[2]) / (m.step * counted));
  EXPECT_EQ(model_runs::of_parts(f, PartQuantity::cone_speed_ratio, PartLevel::cone).front(),
            (from[bit_unknowns] - m.state[bit_unknowns]) / (m.state[6] - from[6]));
  EXPECT_NEAR(model_runs::value(f, Quantity::removed_per_revolution), m.removed - removed,
              rounding * m.removed);
  EXPECT_EQ(f.series.weight.back(), -m.load.force_W.z());
  EXPECT_EQ(f.series.torque.back(), -m.load.torque);
  expect_rows_to_carry(f);
}

/// No two rows of a model are equal, and every blank has a reason: model_runs::run checks both.
TEST(RollerModels, have_a_reason_for_every_blank_also_without_a_weight) {
  const CompareCase c = bit_r();
  for (const char* name : {"tdbd", "briggs", "winters", "ma-azar", "sheppard-lesage",
                           "ma-zhou-deng", "huang-cawthorne-1", "huang-cawthorne-2"})
    model_runs::run(c, name, weight);
  for (const char* name : {"briggs", "winters", "ma-azar"})
    EXPECT_FALSE(saying(model_runs::run(c, name, 0.0), Quantity::rate_at_weight).value) << name;
}

TEST(RollerModels, reject_a_bit_of_fixed_cutters_by_their_names) {
  const CompareCase cutters = model_runs::compare_case("bit-b", {});
  EXPECT_EQ(model_runs::refusal(cutters, "ma-azar", weight),
            "Ma and Azar: found a bit without cones, needs a roller cone bit");
  for (const char* name : {"briggs", "winters", "ma-zhou-deng", "huang-cawthorne-1",
                           "huang-cawthorne-2", "sheppard-lesage"}) {
    const std::string why = model_runs::refusal(cutters, name, weight);
    EXPECT_NE(why.find(": found a bit without cones, needs"), std::string::npos) << why;
  }
}

TEST(RollerModels, that_need_a_weight_report_it) {
  const CompareCase c = bit_r();
  for (const auto& [name, title] : {std::pair("ma-zhou-deng", "Ma, Zhou and Deng: "),
                                    std::pair("huang-cawthorne-2", "Huang and Cawthorne: "),
                                    std::pair("hanson-hansen", "Hanson and Hansen: ")}) {
    const std::string why = model_runs::refusal(c, name, 0.0);
    EXPECT_EQ(why.find(title), 0u) << why;
    EXPECT_NE(why.find("found no weight, needs compare.weight_on_bit"), std::string::npos) << why;
  }
  const std::string bands = model_runs::refusal(c, "sheppard-lesage", 0.0);
  EXPECT_EQ(bands.find("Sheppard and Lesage: found no specific energy"), 0u) << bands;
}

/// A file of single-tooth tests, gone with the test.
struct ToothFile {
  explicit ToothFile(const std::string& rows)
      : path(std::filesystem::path(testing::TempDir()) / "compare_tooth_table.csv") {
    std::ofstream(path) << "depth [mm], force [kN], crater_radius [mm]\n" << rows;
  }
  ~ToothFile() { std::filesystem::remove(path); }
  ToothFile(const ToothFile&) = delete;
  ToothFile& operator=(const ToothFile&) = delete;
  std::filesystem::path path;
};

TEST(RollerModels, reject_a_table_whose_forces_fall) {
  const ToothFile file("0, 0, 0\n1, 4, 3\n2, 3, 4\n");
  const CompareCase c = bit_r({"compare.roller.tooth_table='" + file.path.string() + "'"});
  for (const auto& [name, title] : {std::pair("ma-zhou-deng", "Ma, Zhou and Deng: "),
                                    std::pair("huang-cawthorne-1", "Huang and Cawthorne: ")}) {
    const std::string why = model_runs::refusal(c, name, weight);
    EXPECT_EQ(why.find(title), 0u) << why;
    EXPECT_NE(why.find(file.path.string() + ":4"), std::string::npos) << why;
  }
}

TEST(RollerModels, report_which_of_them_finds_no_depth_for_a_weight) {
  const CompareCase c = bit_r({"compare.roller.specific_energy='100 MPa'"});
  for (const auto& [name, title] :
       {std::pair("briggs", "Briggs: "), std::pair("ma-zhou-deng", "Ma, Zhou and Deng: "),
        std::pair("sheppard-lesage", "Sheppard and Lesage: ")}) {
    const std::string why = model_runs::refusal(c, name, 1e9);
    EXPECT_EQ(why.find(title), 0u) << name << ": " << why;
  }
}

TEST(RollerModels, of_teeth_need_a_law_of_teeth) {
  const CompareCase c = bit_r({"forces.law='none'"});
  const std::string why = model_runs::refusal(c, "hanson-hansen", weight);
  EXPECT_NE(why.find("forces.law = \"indentation\""), std::string::npos) << why;
}

}  // namespace
}  // namespace tdbd::reference::roller_models_test
