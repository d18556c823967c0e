#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/arguments.hpp"
#include "app/case_kind.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "simulation/rotate/rotate_simulation.hpp"
#include "simulation/start/reach.hpp"
#include "simulation/step/simulation.hpp"

namespace tdbd::app {
namespace {

void check_run(const std::string& file, const std::vector<std::string>& overrides) {
  require_kind(file, overrides, CaseKind::drilling);
  const simulation::Case c = simulation::read_case(file, overrides);
  const simulation::Simulation s = simulation::start(c);
  print_warnings(c.warnings);
  print_warnings(simulation::reach_warnings(c, s.state.rock.surface));
  say("{}: valid; {} parts, {} triangles of rock, {} steps of {} s\n", file, c.bit.parts.size(),
      s.state.start_triangles, c.time.steps, c.time.step);
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
      "check", "Read everything, run nothing, report every mistake and where it is");
  auto file = std::make_shared<std::string>();
  auto overrides = std::make_shared<std::vector<std::string>>();
  command->add_option("case", *file, "the case file (TOML)")->required();
  add_set(*command, *overrides, "override a key");
  command->footer("Example: tdbd check cases/bit-b-steady.toml");
  command->callback([file, overrides, &exit_code] {
    exit_code = guarded([&] {
      simulation::is_rotate_case(*file) ? check_rotate(*file, *overrides)
                                        : check_run(*file, *overrides);
      return 0;
    });
  });
}

}  // namespace tdbd::app
