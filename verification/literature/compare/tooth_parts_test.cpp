#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "reference/compare/comparison_files.hpp"
#include "simulation/step/simulation.hpp"
#include "verification/literature/compare/model_runs.hpp"

/// Forces of single teeth add up to those of their rows, rows to cones, and cones to the bit.
namespace tdbd::reference::tooth_parts_test {
namespace {

constexpr double weight = 28e3;     // N
constexpr double rounding = 3e-14;  // of sums in another order, of the bit's; seen: 1.2e-14

/// Only the teeth of the comparison's bit touch rock. Its steps are those of every model.
CompareCase bit_r() {
  return model_runs::compare_case(
      "bit-r", {"rock.edge_length='4 mm'", "time.step='0.1 ms'", "time.revolutions=0.3",
                "compare.counted_revolutions=0.15", "compare.spokes.spokes=24",
                "compare.spokes.spacing='4 mm'"});
}

constexpr std::array models_of_teeth{"tdbd", "ma-zhou-deng", "huang-cawthorne-1",
                                     "huang-cawthorne-2", "hanson-hansen"};

const Findings& findings_about(const std::string& model) {
  static std::map<std::string, Findings> known;
  if (!known.contains(model)) known[model] = model_runs::run(bit_r(), model, weight);
  return known[model];
}

/// The name of the row of a tooth, of the cone of a row.
std::string whole_of(const std::string& part) { return part.substr(0, part.rfind('/')); }

std::map<std::string, double> numbers_of(const Findings& f, PartQuantity q, PartLevel level) {
  std::map<std::string, double> numbers;
  for (const PartFinding& p : f.parts)
    if (p.quantity == q && level_of(p) == level) numbers[p.part] = p.value;
  return numbers;
}

void expect_sums(const Findings& f, PartQuantity q, PartLevel parts, PartLevel wholes) {
  std::map<std::string, double> sums;
  for (const auto& [part, value] : numbers_of(f, q, parts)) sums[whole_of(part)] += value;
  const std::map<std::string, double> found = numbers_of(f, q, wholes);
  const double all = model_runs::sum_of_parts(f, q, wholes);
  ASSERT_EQ(sums.size(), found.size());
  for (const auto& [whole, value] : found)
    EXPECT_NEAR(sums.at(whole), value, rounding * all) << whole << ' ' << text_of(q).name;
}

TEST(ToothParts, teeth_add_up_to_rows_and_rows_to_cones) {
  for (const char* model : models_of_teeth) {
    SCOPED_TRACE(model);
    const Findings& f = findings_about(model);
    EXPECT_EQ(numbers_of(f, PartQuantity::weight, PartLevel::tooth).size(), 120u);
    for (const PartQuantity q :
         {PartQuantity::weight, PartQuantity::force_into_rock, PartQuantity::volume_per_revolution,
          PartQuantity::teeth_in_contact}) {
      expect_sums(f, q, PartLevel::tooth, PartLevel::row);
      expect_sums(f, q, PartLevel::row, PartLevel::cone);
    }
  }
}

/// The bit's own numbers are found without its parts: of the loads of its steps, of its contacts, of the rock.
TEST(ToothParts, cones_add_up_to_the_bit) {
  for (const char* model : models_of_teeth) {
    SCOPED_TRACE(model);
    const Findings& f = findings_about(model);
    const auto of_cones = [&](PartQuantity q) {
      return model_runs::sum_of_parts(f, q, PartLevel::cone);
    };
    const double carried = noise_of(f.series.weight, 1).mean;
    EXPECT_NEAR(of_cones(PartQuantity::weight) / carried, 1.0, rounding);
    const double contacts = model_runs::value(f, Quantity::teeth_in_contact);
    EXPECT_NEAR(of_cones(PartQuantity::teeth_in_contact) / contacts, 1.0, rounding);
    const double removed = model_runs::value(f, Quantity::removed_per_revolution);
    EXPECT_NEAR(of_cones(PartQuantity::volume_per_revolution) / removed, 1.0, rounding);
  }
}

/// The shells of the shipped bit R crush rock too: they are shares of their cones and of no row.
TEST(ToothParts, cones_with_shells_that_crush_add_up_to_the_bit) {
  const CompareCase c = model_runs::compare_case(
      "bit-r-skewed", {"rock.edge_length='4 mm'", "time.step='2 ms'", "time.revolutions=2",
                       "motion.rate_of_penetration='100 m/h'", "forces.bit_body={law='none'}",
                       "forces.gage_pad={law='none'}"});
  const Findings f = model_runs::run(c, "tdbd", 0.0);
  const double carried = model_runs::value(f, Quantity::weight),
               cones = model_runs::sum_of_parts(f, PartQuantity::weight, PartLevel::cone),
               rows = model_runs::sum_of_parts(f, PartQuantity::weight, PartLevel::row);
  EXPECT_NEAR(cones / carried, 1.0, rounding);
  EXPECT_LT(rows, 0.999 * cones);
  expect_sums(f, PartQuantity::weight, PartLevel::tooth, PartLevel::row);
}

/// No mean force of the steps in contact is above the largest; a tooth that carries nothing has no largest force.
TEST(ToothParts, largest_forces_are_above_those_in_contact) {
  for (const char* model : models_of_teeth) {
    const Findings& f = findings_about(model);
    const auto largest = numbers_of(f, PartQuantity::largest_weight, PartLevel::tooth),
               contacts = numbers_of(f, PartQuantity::teeth_in_contact, PartLevel::tooth);
    for (const auto& [tooth, mean] : numbers_of(f, PartQuantity::weight, PartLevel::tooth)) {
      EXPECT_GE(largest.at(tooth) * contacts.at(tooth), mean * (1.0 - rounding))
          << model << ' ' << tooth;
      EXPECT_EQ(largest.at(tooth) == 0.0, mean == 0.0) << model << ' ' << tooth;
    }
  }
}

/// The run again, step by step, with an eye on one tooth: that which carries most in a step.
TEST(ToothParts, numbers_of_a_tooth_are_those_of_its_part_in_the_run) {
  const CompareCase c = bit_r();
  const Findings& f = findings_about("tdbd");
  const auto largest = numbers_of(f, PartQuantity::largest_weight, PartLevel::tooth);
  const std::string tooth =
      std::ranges::max_element(largest, {}, [](const auto& t) { return t.second; })->first;
  const auto& parts = c.ours.bit.parts;
  const auto part =
      static_cast<std::size_t>(std::ranges::find(parts, tooth, &bit::Part::name) - parts.begin());
  simulation::Simulation s = simulation::start(c.ours);
  double most = 0.0, sum = 0.0;
  for (long i = 0; i < c.ours.time.steps; ++i) {
    simulation::step(c.ours, s);
    if (i < c.ours.time.steps - counted_steps(c)) continue;
    const double force = -s.work.loads.parts[part].force_W.z();
    most = std::max(most, force);
    sum += force;
  }
  EXPECT_EQ(largest.at(tooth), most);
  EXPECT_EQ(numbers_of(f, PartQuantity::weight, PartLevel::tooth).at(tooth),
            sum / static_cast<double>(counted_steps(c)));
}

/// comparison.json groups the findings of a part; the terminal's table names the parts that carry most.
TEST(ToothParts, are_in_the_files_and_on_the_terminal) {
  const CompareCase c = bit_r();
  const Comparison all = compare(c, chosen_models(c, {"tdbd"}), Refusal::stops, {});
  const nlohmann::json model = nlohmann::json::parse(comparison_json(c, all))["models"][0];
  const Findings& f = all.answers.front().findings;
  for (const PartFinding& p : f.parts) {
    EXPECT_EQ(model["parts"][p.part][std::string(text_of(p.quantity).name)], p.value) << p.part;
    EXPECT_EQ(model["parts"][p.part]["radius_m"], p.radius) << p.part;
  }
  const auto largest = numbers_of(f, PartQuantity::largest_weight, PartLevel::tooth);
  const auto most = *std::ranges::max_element(largest, {}, [](const auto& t) { return t.second; });
  const std::string table = comparison_table(all);
  EXPECT_NE(table.find("carries most"), std::string::npos);
  EXPECT_NE(table.find(fmt::format("{:>24}{:>8.3f}\n", most.first, 1e-3 * most.second)),
            std::string::npos)
      << table;
}

}  // namespace
}  // namespace tdbd::reference::tooth_parts_test
