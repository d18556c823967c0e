#include <fmt/format.h>
#include <gtest/gtest.h>
#include <netcdf.h>

#include <algorithm>
#include <map>

#include "core/temporary_file.hpp"
#include "simulation/chain/chain_run.hpp"
#include "simulation/result/run.hpp"
#include "verification/simulation/mesh_bit.hpp"

/// What `tdbd run` reports of a string on a chain, beside what `tdbd string` computes of the same string.
namespace tdbd::simulation::chain_output_test {

const std::vector<std::string> deviated{
    "rock.edge_length='6 mm'", "string.axial_damping=0", "string.element_length=25",
    "string.survey={measured_depth=[0, 500, 1100, 2500], inclination=[0, 0, 1, 1], "
    "azimuth=[0, 0, 0.5, 0.5]}",
    "string.friction.static=0.25"};

Case drilling(std::vector<std::string> more) {
  more.insert(more.end(), deviated.begin(), deviated.end());
  return read_case(TDBD_SOURCE_DIR "/cases/string-drill-bit-b.toml", more);
}

/// The string of that case alone, below it a bit of the same mass and inertia.
ChainCase alone(const Case& c) {
  const dynamics::DrillingSystem& s = c.drilling.system;
  const string::Elements& e = s.chained->chain.elements;
  std::string text = fmt::format(
      "[string]\nmodel = \"chain\"\nmass = {}\ntorsional_inertia = {}\n"
      "[[string.sections]]\nlength = 2300\nouter_diameter = 0.127\ninner_diameter = 0.1086\n"
      "contact_diameter = 0.1682\n"
      "[[string.sections]]\nlength = 200\nouter_diameter = 0.1651\ninner_diameter = 0.0714\n"
      "[string.friction]\nmud_density = 1200\n"
      "[motion]\nrotary_speed = {}\nrate_of_penetration = {}\n"
      "weight_at_start = 26e3\ntorque_at_start = 2200\n[time]\nstep = 1e-3\nduration = 0.1\n",
      s.mass - e.mass.back(), s.gyrostat.inertia_B(2, 2) - e.inertia.back(), c.motion.rotary_speed,
      c.motion.rate_of_penetration);
  return read_chain_case(write_temporary(".toml", text), {deviated.begin() + 2, deviated.end()});
}

/// Static torque and drag, and frequencies, against those of `tdbd string`.
TEST(ChainSummary, has_the_static_loads_and_frequencies_of_the_string_alone) {
  constexpr double rounding = 1e-12;
  const Case c = drilling({"time.duration='0.1 s'"});
  const Simulation s = start(c);
  const StringSummary run = *summary_of(c, s, RunStatus::completed).string;
  const ChainPlan plan = alone(c).plan;
  const std::vector<StaticLoad> loads = static_loads(plan);
  ASSERT_EQ(run.statics.size(), 4U);
  ASSERT_EQ(loads.size(), 4U);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const string::SurfaceLoad &a = run.statics[i].load.surface, &b = loads[i].load.surface;
    EXPECT_EQ(run.statics[i].name, loads[i].name);
    EXPECT_NEAR(a.hook_load, b.hook_load, rounding * b.hook_load) << loads[i].name;
    EXPECT_NEAR(a.torque, b.torque, rounding * b.torque) << loads[i].name;
  }
  EXPECT_GT(loads[0].load.surface.hook_load, 1.2 * loads[1].load.surface.hook_load) << "drag";
  const ChainModes modes = chain_modes(plan);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(run.modes.axial[k].frequency, modes.axial[k].frequency, rounding);
    EXPECT_NEAR(run.modes.torsional[k].frequency, modes.torsional[k].frequency, rounding);
  }
  EXPECT_EQ(run.elements, 100);
  EXPECT_NEAR(run.longest_step, plan.longest_step, rounding);
}

/// A variable, one row after another.
std::vector<double> numbers(const std::filesystem::path& file, const char* name) {
  int nc = -1, variable = -1, rank = 0, dims[2] = {};
  EXPECT_EQ(nc_open(file.c_str(), NC_NOWRITE, &nc), NC_NOERR) << file;
  EXPECT_EQ(nc_inq_varid(nc, name, &variable), NC_NOERR) << name;
  nc_inq_varndims(nc, variable, &rank);
  nc_inq_vardimid(nc, variable, dims);
  std::size_t count = 1;
  for (int i = 0; i < rank; ++i) {
    std::size_t length = 0;
    nc_inq_dimlen(nc, dims[i], &length);
    count *= length;
  }
  std::vector<double> x(count);
  EXPECT_EQ(nc_get_var_double(nc, variable, x.data()), NC_NOERR);
  nc_close(nc);
  return x;
}

/// Columns of nodes in every step, profiles in every second one and at the start, and the bit's speed at
/// their end; a node that rests is counted.
TEST(ChainHistory, of_a_run_has_nodes_as_its_profiles_have_them) {
  const Case c = drilling({"time.duration='12 ms'", "output.history_every=1",
                           "output.string_depths=['0 m', '1510 m', '2500 m']",
                           "output.string_profile_every='2 ms'"});
  const std::filesystem::path out = test_folder() / "out";
  run(c, {.folder = out});
  const std::size_t nodes = 101, rows = 12, profiles = 7;
  const std::size_t at_node[] = {0, 60, 100}, element[] = {0, 59, 99};
  const std::map<std::string, std::string> of_node{
      {"node_rate", "velocity"}, {"node_speed", "rotary_speed"}, {"node_side_force", "side_force"}},
      of_element{{"node_tension", "tension"}, {"node_torque", "torque"}};
  const std::vector<double> times = numbers(out / "string.nc", "time");
  ASSERT_EQ(times.size(), profiles);
  EXPECT_EQ(times[0], 0.0);
  const auto compare = [&](const auto& names, const std::size_t* column, std::size_t width) {
    for (const auto& [in_history, in_profile] : names) {
      const std::vector<double> history = numbers(out / "history.nc", in_history.c_str());
      const std::vector<double> profile = numbers(out / "string.nc", in_profile.c_str());
      ASSERT_EQ(history.size(), 3 * rows);
      ASSERT_EQ(profile.size(), width * profiles);
      for (std::size_t k = 1; k < profiles; ++k)
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_EQ(history[3 * (2 * k - 1) + i], profile[width * k + column[i]]) << in_history;
    }
  };
  compare(of_node, at_node, nodes);
  compare(of_element, element, nodes - 1);
  const std::vector<double> angle = numbers(out / "string.nc", "angle");
  const std::vector<double> turned = numbers(out / "history.nc", "rotation_angle");
  const std::vector<double> twist = numbers(out / "history.nc", "string_twist");
  constexpr double rounding = 1e-11;  // rad
  for (std::size_t k = 1; k < profiles; ++k) {
    EXPECT_NEAR(angle[nodes * k + nodes - 1], turned[2 * k - 1], rounding);
    EXPECT_NEAR(angle[nodes * k] - angle[nodes * k + nodes - 1], twist[2 * k - 1], rounding);
  }
}

/// The profile of the start against the static equilibrium that it starts from; the bit's velocity is the
/// rate of its displacement.
TEST(ChainHistory, of_a_run_starts_with_the_equilibrium_and_ends_at_the_bit) {
  constexpr double rounding = 1e-9;
  constexpr double of_rate = 2e-3, of_speed = 0.02;  // m/s, rad/s: of order 2 in the step
  const Case c = drilling({"time.duration='4 ms'", "output.string_profile_every='1 ms'"});
  const std::filesystem::path out = test_folder() / "out";
  run(c, {.folder = out});
  const string::SteadyLoad load =
      string::steady_load(c.drilling.system.chained->chain, c.drilling.start_motion);
  const std::vector<double> tension = numbers(out / "string.nc", "tension");
  const std::vector<double> torque = numbers(out / "string.nc", "torque");
  for (std::size_t e = 0; e < 100; ++e) {
    EXPECT_NEAR(tension[e], load.tension[e], rounding * load.tension[0]);
    EXPECT_NEAR(torque[e], load.torque[e], rounding * load.torque[0]);
  }
  const std::vector<double> u = numbers(out / "string.nc", "displacement"),
                            v = numbers(out / "string.nc", "velocity"),
                            q = numbers(out / "string.nc", "angle"),
                            w = numbers(out / "string.nc", "rotary_speed");
  const auto at_bit = [](std::size_t k) { return 101 * k + 100; };
  for (std::size_t k = 1; k <= 4; ++k) {
    const double rate = (u[at_bit(k)] - u[at_bit(k - 1)]) / c.time.step;
    const double speed = (q[at_bit(k)] - q[at_bit(k - 1)]) / c.time.step;
    EXPECT_NEAR(0.5 * (v[at_bit(k)] + v[at_bit(k - 1)]), rate, of_rate);
    EXPECT_NEAR(0.5 * (w[at_bit(k)] + w[at_bit(k - 1)]), speed, of_speed);
  }
}

/// Rows of several steps have means and extremes of every node.
TEST(ChainHistory, of_a_run_has_means_and_extremes_of_nodes_over_many_steps) {
  constexpr double rounding = 1e-12;
  const std::vector<std::string> settings{"time.duration='9 ms'",
                                          "output.string_depths=['500 m', '2500 m']"};
  const auto column = [&](const char* every, const char* name) {
    std::vector<std::string> all = settings;
    all.push_back(std::string("output.history_every=") + every);
    const std::filesystem::path out = test_folder() / every;
    if (!std::filesystem::exists(out)) run(drilling(all), {.folder = out});
    return numbers(out / "history.nc", name);
  };
  const std::vector<double> steps = column("1", "node_speed"), mean = column("3", "node_speed"),
                            least = column("3", "node_speed_min"),
                            most = column("3", "node_speed_max");
  ASSERT_EQ(mean.size(), 6U);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t i = 0; i < 2; ++i) {
      const auto of = [&](std::size_t k) { return steps[2 * (3 * row + k) + i]; };
      EXPECT_NEAR(mean[2 * row + i], (of(0) + of(1) + of(2)) / 3.0, rounding * of(0));
      EXPECT_EQ(least[2 * row + i], std::min({of(0), of(1), of(2)}));
      EXPECT_EQ(most[2 * row + i], std::max({of(0), of(1), of(2)}));
    }
}

}  // namespace tdbd::simulation::chain_output_test
