// Run times of a step of the rotating bit, and of other programs for the same body in the same run.

#include <benchmark/benchmark.h>

#include "benchmarks/rotation/method.hpp"

namespace tdbd::bench {
namespace {

constexpr double step_size = 0.01;  // s
constexpr double tolerance = 1e-9;  // of methods with step size control
constexpr long batch = 100;         // steps between two readings of the clock

/// One iteration is one step.
void step(benchmark::State& state, const RotationCase& c, const Method& method) {
  const auto integration = method.start(c, method.control == Control::step ? step_size : tolerance);
  integration->take(batch);
  const long before = integration->torque_evaluations(), steps_before = integration->steps();
  while (state.KeepRunningBatch(batch)) integration->take(batch);
  const auto evaluations = static_cast<double>(integration->torque_evaluations() - before);
  state.counters["torques"] =
      evaluations / static_cast<double>(integration->steps() - steps_before);
}

void register_steps(const RotationCase& c) {
  for (const Contender& contender : all_contenders())
    for (const Method& method : contender.methods) {
      const std::string name = c.name + "/" + contender.name + "/" + method.name;
      benchmark::RegisterBenchmark(name.c_str(), step, c, method)->Unit(benchmark::kNanosecond);
    }
}

void say_who_is_absent() {
  for (const Contender& contender : all_contenders())
    if (!contender.absent.empty())
      benchmark::AddCustomContext(contender.name, "ABSENT: " + contender.absent);
}

}  // namespace
}  // namespace tdbd::bench

int main(int argc, char** argv) {
  using namespace tdbd::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const RotationCase& c : {slow_top(), free_gyrostat(), heavy_gyrostat()}) register_steps(c);
  say_who_is_absent();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
