// Run time of a step of the bit on its string, without cutting rock.

#include <benchmark/benchmark.h>

#include "verification/dynamics/drilling/coupled_bit.hpp"

namespace tdbd::bench {
namespace {

/// Steps of 0.1 ms with a wrench at the predicted momenta, as in drilling.
void step(benchmark::State& state, const dynamics::DrillingSystem& system,
          const dynamics::DrillingState& from) {
  constexpr double h = 1e-4;
  dynamics::DrillingRun d = dynamics::go_on(system, dynamics::start_drilling(system, from));
  dynamics::Wrench wrench;
  for (auto _ : state) {
    dynamics::open_step(system, h, d, d.work);
    wrench.force_W = -1e-3 * dynamics::predicted(system, h, d, d.work).momentum_W;
    dynamics::close_step(system, h, wrench, d, d.work);
  }
}

/// Springs and dampers in all six directions, no cones, wall or moving rock.
dynamics::DrillingSystem bit_on_string() {
  dynamics::DrillingSystem s = dynamics::plain_bit();
  s.string.stiffness = (7e5 * Mat3::Identity()).eval();
  s.string.damping = (1e4 * Mat3::Identity()).eval();
  s.string.turn_stiffness = (1e3 * Mat3::Identity()).eval();
  s.string.turn_damping = (1e2 * Mat3::Identity()).eval();
  s.top.speed = dynamics::constant(12.0);
  return dynamics::make_drilling_system(s);
}

void on_string(benchmark::State& state) {
  const dynamics::DrillingSystem s = bit_on_string();
  step(state, s, dynamics::at_rest(s));
}
BENCHMARK(on_string);

/// Two cones, bearings, a wall in contact, moving rock.
void everything(benchmark::State& state) {
  using dynamics::AxialMode, dynamics::DamperEnd;
  const dynamics::DrillingSystem s = dynamics::coupled_bit(AxialMode::rate, DamperEnd::top);
  step(state, s, dynamics::coupled_start(s));
}
BENCHMARK(everything);

}  // namespace
}  // namespace tdbd::bench

BENCHMARK_MAIN();
