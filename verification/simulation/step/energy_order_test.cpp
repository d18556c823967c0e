#include "simulation/step/energy_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "simulation/result/run.hpp"
#include "verification/core/temporary_folder.hpp"

namespace tdbd::simulation::energy_order_test {

using Json = nlohmann::json;

/// Of an observed order, three levels, forces of a cut whose vertices come into reach one by one.
/// Drilling.accounts_for_its_energy_to_second_order holds the same tolerance over six levels. Teeth
/// come into contact and lose it: over eight windows, on edges of 4 and 2 mm, 2.04 to 2.20.
constexpr double order_tolerance = 0.1, order_tolerance_of_teeth = 0.3;

Case drilling(std::vector<std::string> settings, const std::string& name = "drill-bit-b") {
  settings.insert(settings.end(), {"rock.edge_length='4 mm'", "time.duration='0.1 s'"});
  return read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml", settings);
}

Simulation after(const Case& c, long steps) {
  Simulation s = start(c);
  while (s.state.steps_done < steps) step(c, s);
  return s;
}

double residual_of(const Case& c, const Simulation& s) {
  return dynamics::residual(
      dynamics::stored_energy(c.drilling.system, s.work.drive.at, s.state.drive->state),
      s.state.drive->ledger);
}

TEST(EnergyOrder, is_two_where_rock_is_cut) {
  for (const auto& [name, tolerance] :
       {std::pair{"drill-bit-b", order_tolerance}, {"drill-bit-r", order_tolerance_of_teeth}}) {
    const Case c = drilling({}, name);
    const EnergyOrder found = observe_energy_order(c, after(c, 50));
    ASSERT_TRUE(found.residual.order) << found.residual.reason;
    EXPECT_NEAR(*found.residual.order, 2.0, tolerance) << name;
    EXPECT_EQ(found.from, 0.05);
    EXPECT_EQ(found.window, 0.024);
  }
}

/// The level of the step itself is what the run goes through.
TEST(EnergyOrder, first_level_is_the_run_itself) {
  const Case c = drilling({});
  Simulation s = after(c, 50);
  const EnergyOrder found = observe_energy_order(c, s);
  const double before = residual_of(c, s);
  double squares = 0.0;
  for (long i = 0; i < c.output.energy_order_window; ++i) {
    step(c, s);
    squares += std::pow(residual_of(c, s) - before, 2);
  }
  const double size = std::sqrt(squares / static_cast<double>(c.output.energy_order_window));
  const double stored = dynamics::total(
      dynamics::stored_energy(c.drilling.system, s.work.drive.at, s.state.drive->state));
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(found.residual.residuals[0], size, rounding * stored);  // J
}

TEST(EnergyOrder, is_not_reported_for_a_bit_without_contact) {
  const Case c = drilling(
      {"rock.shape=flat", "motion.start=['0 mm', '0 mm', '-20 mm']", "motion.weight_on_bit=0"});
  const EnergyOrder found = observe_energy_order(c, after(c, 2));
  EXPECT_FALSE(found.residual.order);
  EXPECT_EQ(found.residual.reason, "the bit loses contact with the rock in the window");
}

TEST(EnergyOrder, begins_with_the_means_at_a_maintenance_and_fits_the_run) {
  const auto at = [](std::vector<std::string> settings) {
    settings.emplace_back("output.energy_order=always");
    return plan_energy_order(drilling(std::move(settings))).at;
  };
  EXPECT_EQ(at({}), 50);
  EXPECT_EQ(at({"output.means_from='23 ms'"}), 25);
  EXPECT_EQ(at({"output.means_from='1 s'"}), 75);
  EXPECT_EQ(at({"maintenance.every=0", "output.means_from='1 s'"}), 76);
  EXPECT_EQ(at({"output.energy_order_window=200"}), -1);
  EXPECT_EQ(plan_energy_order(drilling({})).reason,
            "168 steps, of a run of 100, are more than a tenth: it needs 1680 steps, or "
            "output.energy_order = \"always\"");
  EXPECT_EQ(plan_energy_order(drilling({"output.energy_order=off"})).reason,
            "output.energy_order is off");
  Case c = drilling({});
  c.time.steps = 1680;
  EXPECT_EQ(plan_energy_order(c).reason, "");
  c.time.steps = 1679;
  EXPECT_NE(plan_energy_order(c).reason, "");
}

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The folder of a run with this setting of output.energy_order.
std::filesystem::path run_with(const std::string& name, const char* setting, int threads) {
  RunOptions options;
  options.folder = temporary_folder() + name;
  options.threads = threads;
  run(drilling({std::string("output.energy_order=") + setting}), options);
  return options.folder;
}

TEST(EnergyOrder, changes_no_bit_of_the_run_on_any_number_of_threads) {
  const auto with = run_with("with", "always", 1), without = run_with("without", "off", 1);
  const auto threads = run_with("threads", "always", 2);
  for (const char* file : {"history.csv", "history.nc", "frames/rock_final.vtp"})
    EXPECT_TRUE(read(with / file) == read(without / file)) << file;
  EXPECT_EQ(read(with / "summary.json"), read(threads / "summary.json"));
  Json a = Json::parse(read(with / "summary.json")),
       b = Json::parse(read(without / "summary.json"));
  EXPECT_NEAR(a["energy_residual_order"].get<double>(), 2.0, 3.8e-3);
  EXPECT_TRUE(b["energy_residual_order"].is_null());
  EXPECT_EQ(b["energy_residual_order_of"]["reason"], "output.energy_order is off");
  for (Json* j : {&a, &b})
    for (const char* key : {"energy_residual_order", "energy_residual_order_of", "case_hash"})
      j->erase(key);
  EXPECT_EQ(a, b);
}

}  // namespace tdbd::simulation::energy_order_test
