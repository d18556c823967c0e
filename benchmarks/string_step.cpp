// A step of a drill string with friction: the run of cases/string-build-and-hold.toml after it has
// started to rotate, as a function of the number of elements.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "simulation/chain/chain_run.hpp"

namespace tdbd::bench {
namespace {

void chain(benchmark::State& state) {
  const simulation::ChainCase c = simulation::read_chain_case(
      TDBD_SOURCE_DIR "/cases/string-build-and-hold.toml",
      {fmt::format("string.element_length={} m", 2500.0 / static_cast<double>(state.range(0))),
       "time.step=0.5 ms", "string.start=steady"});
  simulation::ChainSimulation s = simulation::start_chain(c);
  simulation::advance_chain(c, s, 1000);
  for (auto _ : state)
    string::step_bit_on_chain(c.plan.chain, c.plan.bit, c.time.step,
                              {c.plan.rotary_speed * c.time.step, 0.0, 0.0, 0.0}, s.state, s.work);
}

BENCHMARK(chain)->Unit(benchmark::kMicrosecond)->Arg(100)->Arg(250)->Arg(500);

}  // namespace
}  // namespace tdbd::bench
