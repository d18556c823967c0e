#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "simulation/case/case_kind.hpp"
#include "simulation/result/estimate.hpp"
#include "simulation/rotate/rotate_simulation.hpp"
#include "simulation/start/reach.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::app {
namespace {

/// "42 s", "7.2 min", "3.1 h".
std::string time_text(double seconds) {
  constexpr double minute = 60.0, hour = 3600.0;
  if (seconds < 2.0 * minute) return fmt::format("{:.2g} s", seconds);
  if (seconds < 2.0 * hour) return fmt::format("{:.2g} min", seconds / minute);
  return fmt::format("{:.2g} h", seconds / hour);
}

/// "38 MB", "1.4 GB".
std::string bytes_text(double bytes) {
  constexpr double mega = 1e6, giga = 1e9;
  return bytes < giga ? fmt::format("{:.2g} MB", bytes / mega)
                      : fmt::format("{:.2g} GB", bytes / giga);
}

void print_estimate(const simulation::RunEstimate& e) {
  say("about {:.2g} triangles at the end, {} of memory, {} on disk", e.triangles,
      bytes_text(e.memory_bytes), bytes_text(e.disk_bytes));
  if (e.steps_tried > 0)
    say(", {} here ({} steps were tried)", time_text(e.seconds), e.steps_tried);
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

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "check", "Read everything, report every mistake and where it is, and what a run would take");
  auto file = std::make_shared<std::string>();
  auto overrides = std::make_shared<std::vector<std::string>>();
  command->add_option("case", *file, "the case file (TOML)")->required()->type_name(a_toml_file);
  add_set(*command, *overrides, "override a key");
  command->footer("Example: tdbd check cases/bit-b-steady.toml");
  command->callback([file, overrides, &exit_code] {
    exit_code = guarded([&] {
      simulation::require_kind(*file, *overrides,
                               {simulation::CaseKind::drilling, simulation::CaseKind::rotation});
      simulation::is_rotate_case(*file) ? check_rotate(*file, *overrides)
                                        : check_run(*file, *overrides);
      return 0;
    });
  });
}

}  // namespace tdbd::app
