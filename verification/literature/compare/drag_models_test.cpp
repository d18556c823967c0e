#include <gtest/gtest.h>

#include <map>

#include "reference/compare/models/led_bit.hpp"
#include "reference/literature/drag/plane/warren_sinor.hpp"
#include "reference/literature/drag/planes/behr.hpp"
#include "reference/literature/drag/spokes/hanson_hansen_path.hpp"
#include "reference/literature/drag/spokes/langeveld_path.hpp"
#include "reference/literature/drag/wear/glowka_metres.hpp"
#include "verification/literature/compare/model_runs.hpp"

namespace tdbd::reference::drag_models_test {
namespace {

constexpr double weight = 20e3;           // N
constexpr double rounding = 1e-12;        // of sums in another order
constexpr double plane_column = 0.01e-3;  // m, the setting of the comparison for Warren and Sinor

const std::vector<std::string> drag_models{"warren-sinor", "behr", "glowka", "langeveld",
                                           "hanson-hansen"};

/// Bit B in few steps; Glowka's wear over a few metres.
CompareCase bit_b(const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides{"time.step='4 ms'", "time.revolutions=2",
                                     "compare.glowka.distance='2 m'"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return model_runs::compare_case("bit-b", overrides);
}

PathOptions path_options(const CompareCase& c) {
  PathOptions o;
  o.step = c.ours.time.step;
  o.duration = o.step * static_cast<double>(c.ours.time.steps);
  o.counted = o.step * static_cast<double>(counted_steps(c));
  return o;
}

void expect_run(const Findings& f, const PathRun& run) {
  EXPECT_NEAR(model_runs::value(f, Quantity::weight), run.wob, rounding * run.wob);
  EXPECT_NEAR(model_runs::value(f, Quantity::torque), run.tob, rounding * run.tob);
  EXPECT_EQ(model_runs::value(f, Quantity::removed_per_revolution), run.lowered);
  EXPECT_EQ(model_runs::value(f, Quantity::side_force), run.side);
  EXPECT_EQ(model_runs::of_parts(f, PartQuantity::area, PartLevel::cutter), run.area);
  EXPECT_EQ(model_runs::of_parts(f, PartQuantity::volume_per_revolution, PartLevel::cutter),
            run.volume);
  EXPECT_EQ(f.cost.steps, run.steps);
}

TEST(DragModels, warren_and_sinor_agree_with_their_plane) {
  const CompareCase c = bit_b();
  const Findings f = model_runs::run(c, "warren-sinor", weight);
  WarrenSinorOptions options;
  options.form = c.options.outline;
  options.column = plane_column;
  const auto& cutters = c.ours.bit.cutters;
  const WarrenSinorLoad at = warren_sinor(cutters, c.advance, *c.rock, options),
                        under = warren_sinor_at_weight(cutters, weight, *c.rock, options);
  EXPECT_EQ(model_runs::value(f, Quantity::weight), at.weight);
  EXPECT_EQ(model_runs::value(f, Quantity::torque), at.torque);
  EXPECT_EQ(model_runs::value(f, Quantity::imbalance), at.imbalance());
  EXPECT_EQ(model_runs::value(f, Quantity::removed_per_revolution), at.volume);
  EXPECT_EQ(model_runs::value(f, Quantity::rate_at_weight), under.rate(c.ours.motion.rotary_speed));
  EXPECT_EQ(model_runs::value(f, Quantity::torque_at_weight), under.torque);
  const std::vector<double> drag = model_runs::of_parts(f, PartQuantity::drag, PartLevel::cutter);
  ASSERT_EQ(drag.size(), at.cutters.size());
  for (std::size_t i = 0; i < drag.size(); ++i) EXPECT_EQ(drag[i], at.cutters[i].force.cutting);
}

/// One law of all cutters, of the first one's virgin groove of the reference depth.
GlowkaLaw glowka_law(const CompareCase& c) {
  const GlowkaSettings& s = c.options.glowka;
  const double drag = c.rock->specific_energy *
                      virgin_area(glowka_face(c.ours.bit.cutters.front()), s.reference_depth);
  GlowkaLaw law;
  law.normal = {c.rock->normal_ratio * drag, s.reference_depth, s.power};
  law.drag = {drag, s.reference_depth, s.power};
  law.flat_stress = {*s.flat_stress, s.reference_depth, 0.0};
  law.flat_friction = s.flat_friction;
  return law;
}

TEST(DragModels, glowka_agrees_with_his_sharp_bit) {
  const CompareCase c = bit_b();
  const Findings f = model_runs::run(c, "glowka", weight);
  const GlowkaBit bit = glowka_bit(c.ours.bit.cutters);
  const std::vector<double> sharp(bit.cutters.size());
  const double speed = c.ours.motion.rotary_speed;
  GlowkaLoads at, under;
  glowka_loads(bit, glowka_law(c), {}, sharp, {c.advance, speed}, at);
  const double advance = glowka_under_weight(bit, glowka_law(c), {}, sharp, weight, speed, under);
  EXPECT_EQ(model_runs::value(f, Quantity::weight), at.weight);
  EXPECT_EQ(model_runs::value(f, Quantity::torque), at.torque);
  EXPECT_EQ(model_runs::value(f, Quantity::side_force), at.force_B.head<2>().norm());
  EXPECT_NEAR(model_runs::value(f, Quantity::rate_at_weight),
              advance * speed / (2 * std::numbers::pi), rounding * speed * advance);
  EXPECT_EQ(model_runs::value(f, Quantity::torque_at_weight), under.torque);
  const std::vector<double> bends =
      model_runs::of_parts(f, PartQuantity::bending_moment, PartLevel::cutter);
  ASSERT_EQ(bends.size(), at.cutters.size());
  for (std::size_t i = 0; i < bends.size(); ++i)
    EXPECT_EQ(bends[i], at.cutters[i].moment_B.head<2>().norm());
}

/// Flats of 2 m: the largest and the hottest are those of the cutters that it names.
TEST(DragModels, glowka_names_his_largest_and_his_hottest_flat) {
  const Findings f = model_runs::run(bit_b(), "glowka", weight);
  const std::vector<double> flats =
                                model_runs::of_parts(f, PartQuantity::wear_flat, PartLevel::cutter),
                            warm = model_runs::of_parts(f, PartQuantity::temperature,
                                                        PartLevel::cutter);
  EXPECT_EQ(model_runs::value(f, Quantity::largest_wear_flat), *std::ranges::max_element(flats));
  EXPECT_EQ(model_runs::value(f, Quantity::hottest_flat), *std::ranges::max_element(warm));
  EXPECT_GT(model_runs::value(f, Quantity::largest_wear_flat), 0.0);
}

TEST(DragModels, behr_agrees_with_the_counted_steps_of_his_planes) {
  const CompareCase c = bit_b();
  const Findings f = model_runs::run(c, "behr", weight);
  BehrOptions options;
  options.planes = c.options.planes;
  options.nodes = c.options.plane_nodes;
  options.radius = spoke_reach(c);
  const double dt = c.ours.time.step;
  const int counted = static_cast<int>(counted_steps(c)),
            before = static_cast<int>(c.ours.time.steps) - counted;
  BehrState state = behr_start(c.ours.bit.cutters, path_of(c)(0.0), options);
  behr_run(state, path_of(c), 0.0, dt, before, *c.rock, options);
  const BehrRun run = behr_run(state, path_of(c), dt * before, dt, counted, *c.rock, options);
  EXPECT_EQ(model_runs::value(f, Quantity::weight), noise_of(run.weight, 1).mean);
  EXPECT_EQ(model_runs::value(f, Quantity::torque), noise_of(run.torque, 1).mean);
  EXPECT_EQ(model_runs::value(f, Quantity::removed_per_revolution), run.removed());
  const std::vector<double> areas = model_runs::of_parts(f, PartQuantity::area, PartLevel::cutter);
  ASSERT_EQ(areas.size(), run.cutters.size());
  for (std::size_t i = 0; i < areas.size(); ++i) EXPECT_EQ(areas[i], run.mean_area(i));
}

TEST(DragModels, langeveld_agrees_with_his_led_bit) {
  const CompareCase c = bit_b();
  const auto cutters = spoke_cutters(c.ours.bit.cutters, "Langeveld");
  double highest = 0.0;
  for (const SpokeCutter& cutter : cutters) highest = std::max(highest, -cutter.centre_B.z());
  LangeveldRock rock =
      fitting_rock(cutters, 0.0, -highest, c.options.spokes, c.options.spoke_nodes, spoke_reach(c));
  expect_run(model_runs::run(c, "langeveld", weight),
             langeveld_path(cutters, *c.rock, rock, path_of(c), path_options(c)));
}

TEST(DragModels, hanson_and_hansen_agree_with_their_led_bit) {
  const CompareCase c = bit_b();
  const auto cutters = spoke_cutters(c.ours.bit.cutters, "Hanson and Hansen");
  HansonHansenRock law;
  law.shared = *c.rock;
  const PathOptions options = path_options(c);
  OutlineSpokes rock =
      fitting_outline_rock(cutters, c.ours.motion.rate_of_penetration * options.duration,
                           {c.options.spokes, c.options.spoke_spacing});
  expect_run(model_runs::run(c, "hanson-hansen", weight),
             hanson_hansen_path(cutters, law, rock, path_of(c), options));
}

/// Areas over R d, and volumes over that of a revolution. Areas seen: 2e-4 for planes and spokes of one depth, whose
/// nodes take a rim in steps; 9e-5 for columns; 6e-4 for rims that are polygons; none for the plane.
TEST(DragModels, name_cutters_that_add_up_to_the_bit) {
  const std::map<std::string, double> tolerances{{"warren-sinor", rounding},
                                                 {"behr", 5e-4},
                                                 {"glowka", 2.5e-4},
                                                 {"langeveld", 5e-4},
                                                 {"hanson-hansen", 1.5e-3}};
  const CompareCase c = bit_b();
  const double whole = c.ours.bit.gage_radius * c.advance;
  for (const auto& [model, tolerance] : tolerances) {
    const Findings f = model_runs::run(c, model, weight);
    const double removed = model_runs::value(f, Quantity::removed_per_revolution);
    EXPECT_NEAR(model_runs::sum_of_parts(f, PartQuantity::area, PartLevel::cutter) / whole, 1.0,
                tolerance)
        << model;
    EXPECT_NEAR(
        model_runs::sum_of_parts(f, PartQuantity::volume_per_revolution, PartLevel::cutter) /
            removed,
        1.0, rounding)
        << model;
  }
}

TEST(DragModels, reject_cones_and_bits_without_cutters_by_their_names) {
  const CompareCase cones = model_runs::compare_case("bit-r", {"rock.edge_length='4 mm'"});
  EXPECT_EQ(model_runs::refusal(cones, "warren-sinor", weight),
            "Warren and Sinor: found a bit with cones, needs a bit with fixed cutters");
  EXPECT_EQ(model_runs::refusal(cones, "glowka", weight),
            "Glowka: found a bit with cones, needs a bit with fixed cutters");
  CompareCase bare = bit_b();
  bare.ours.bit.cutters.clear();
  for (const std::string& model : drag_models) {
    const std::string why = model_runs::refusal(bare, model, weight);
    EXPECT_NE(why.find(": found a bit without cutters, needs"), std::string::npos) << why;
  }
}

/// A law that is not linear in the area is none that they share.
TEST(DragModels, reject_laws_that_they_do_not_share) {
  CompareCase c = bit_b();
  c.rock.reset();
  for (const std::string& model : drag_models) {
    const std::string why = model_runs::refusal(c, model, weight);
    EXPECT_NE(why.find("needs forces.law = \"detournay\""), std::string::npos) << why;
  }
}

TEST(DragModels, report_which_model_finds_no_advance_for_a_weight) {
  const CompareCase c = bit_b();
  EXPECT_EQ(model_runs::refusal(c, "warren-sinor", 1e9).find("Warren and Sinor: "), 0u);
  EXPECT_EQ(model_runs::refusal(c, "glowka", 1e9).find("Glowka: "), 0u);
}

}  // namespace
}  // namespace tdbd::reference::drag_models_test
