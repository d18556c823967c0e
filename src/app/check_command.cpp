#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/chain/chain_simulation.hpp"
#include "simulation/result/run.hpp"
#include "simulation/rotate/rotate_simulation.hpp"
#include "simulation/start/reach.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::app {
namespace {

/// Two significant digits without an exponent: "0.42", "4.2", "42", "420".
std::string rounded(double x) {
  if (x < 10.0) return fmt::format("{:.2g}", x);
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1.0);
  return fmt::format("{:.0f}", std::round(x / unit) * unit);
}

/// "42 s", "7.2 min", "3.1 h".
std::string time_text(double seconds) {
  constexpr double minute = 60.0, hour = 3600.0;
  if (seconds < 2.0 * minute) return rounded(seconds) + " s";
  if (seconds < 2.0 * hour) return rounded(seconds / minute) + " min";
  return rounded(seconds / hour) + " h";
}

/// "38 MB", "1.4 GB".
std::string bytes_text(double bytes) {
  constexpr double mega = 1e6, giga = 1e9;
  return bytes < giga ? rounded(bytes / mega) + " MB" : rounded(bytes / giga) + " GB";
}

void print_estimate(const simulation::RunEstimate& e) {
  say("about {} triangles at the end, {} of memory, {} on disk", rounded(e.triangles),
      bytes_text(e.memory_bytes), bytes_text(e.disk_bytes));
  if (e.steps_tried > 0)
    say(", {} on this machine (from {} trial steps)", time_text(e.seconds), e.steps_tried);
  say("\n");
}

void check_run(const std::string& file, const std::vector<std::string>& overrides) {
  const simulation::Case c = simulation::read_case(file, overrides);
  simulation::Simulation s = simulation::start(c);
  print_warnings(c.warnings);
  print_warnings(simulation::reach_warnings(c, s.state.rock.surface));
  say("{}: valid; {} parts, {} triangles of rock, {} steps of {} s\n", file, c.bit.parts.size(),
      s.state.start_triangles, c.time.steps, c.time.step);
  print_estimate(simulation::estimate(c, s));
}

void check_rotate(const std::string& file, const std::vector<std::string>& overrides) {
  const simulation::RotateCase c = simulation::read_rotate_case(file, overrides);
  const simulation::RotateSimulation s = simulation::start(c);
  say("{}: valid; {} cones, {} steps of {} s, energy {:.6g} J\n", file, c.body.cones.size(),
      c.time.steps, c.time.step, s.invariants.energy);
}

void check_string(const std::string& file, const std::vector<std::string>& overrides) {
  const simulation::ChainCase c = simulation::read_chain_case(file, overrides);
  simulation::start_chain(c);
  print_warnings(c.warnings);
  say("{}: valid; {} elements of {:.4g} m, {} steps of {} s\n", file, c.plan.chain.count(),
      c.plan.chain.elements.length, c.time.steps, c.time.step);
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "check", "Check a case, report all mistakes and their places, and estimate what a run takes");
  auto file = std::make_shared<std::string>();
  auto overrides = std::make_shared<std::vector<std::string>>();
  command->add_option("case", *file, "the case file (TOML)")->required()->type_name(a_toml_file);
  add_set(*command, *overrides, "override a key");
  command->footer("Example: tdbd check cases/bit-b-steady.toml");
  command->callback([file, overrides, &exit_code] {
    exit_code = guarded([&] {
      using simulation::CaseKind;
      simulation::require_kind(*file, *overrides,
                               {CaseKind::drilling, CaseKind::rotation, CaseKind::string});
      if (simulation::kind_of(*file, *overrides) == CaseKind::string)
        check_string(*file, *overrides);
      else if (simulation::is_rotate_case(*file))
        check_rotate(*file, *overrides);
      else
        check_run(*file, *overrides);
      return 0;
    });
  });
}

}  // namespace tdbd::app
