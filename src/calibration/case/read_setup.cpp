#include "calibration/case/read_setup.hpp"

#include <fmt/format.h>

#include <regex>

namespace tdbd::calibration {

using namespace calibration_keys;

namespace {

SingleCutter read_cutter(Config table) {
  return {.diameter = table.read(diameter),
          .back_rake = table.read(back_rake),
          .wear_flat = table.read(wear_flat),
          .chamfer = table.read(chamfer)};
}

}  // namespace

std::vector<Tool> read_tools(Config& c) {
  std::vector<Tool> tools;
  Config given_bits = c.table(bits), given_cutters = c.table("cutters");
  static const std::regex plain("[A-Za-z0-9_-]+");
  const auto check_name = [](Config& table, const std::string& name) {
    if (!std::regex_match(name, plain))
      table.problem("", fmt::format("the name '{}'", name), "letters, digits, - and _");
  };
  for (const std::string& name : given_bits.given()) {
    check_name(given_bits, name);
    tools.push_back({name, ToolKind::bit, given_bits.path(name, std::nullopt), {}});
  }
  for (const std::string& name : given_cutters.given()) {
    check_name(given_cutters, name);
    tools.push_back({name, ToolKind::cutter, "", read_cutter(given_cutters.table(name))});
  }
  return tools;
}

TestRock read_test_rock(Config& c) {
  TestRock r;
  Config table = c.table(rock);
  r.around.pore_pressure = table.read(simulation::formation_keys::pore_pressure);
  r.around.overburden = table.read(simulation::formation_keys::overburden);
  r.confinement = table.read(simulation::formation_keys::confinement);
  r.materials[""] = simulation::read_material(table);
  Config others = c.table("rocks");
  for (const std::string& name : others.given())
    r.materials[name] = simulation::read_material_table(others.table(name));
  return r;
}

Noise read_noise(Config c) {
  return {.reading = c.read(reading), .test = c.read(test), .rop = c.read(rop)};
}

CutGrid read_grid(Config& c) {
  Config t = c.table(time);
  return {.edge_length = c.table(rock).read(edge_length),
          .revolutions = t.read(revolutions),
          .steps_per_revolution = t.read(steps_per_revolution)};
}

}  // namespace tdbd::calibration
