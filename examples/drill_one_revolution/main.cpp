// Drills one revolution of a case with the program's library and prints the volume of rock removed.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "simulation/case/case.hpp"
#include "simulation/result/run.hpp"
#include "simulation/step/simulation.hpp"

using namespace tdbd::simulation;

int main(int argc, char** argv) {
  try {
    if (argc < 2) {
      std::puts("usage: drill_one_revolution CASE.toml [KEY=VALUE ...]");
      return 2;
    }
    // Later settings override earlier ones, so the run ends after one revolution.
    std::vector<std::string> settings(argv + 2, argv + argc);
    settings.push_back("time.revolutions=1");
    const Case c = read_case(argv[1], settings);
    auto simulation = start(c);
    while (simulation.state.steps_done < c.time.steps) step(c, simulation);
    const RunSummary s = summary_of(c, simulation, RunStatus::completed);
    std::printf("steps %ld\nrevolutions %.17g\nremoved_volume_m3 %.17g\n", s.steps, s.revolutions,
                s.removed_volume);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "drill_one_revolution: %s\n", e.what());
    return 1;
  }
}
