// Time to make a bit from a bit file: text, layout, meshes, and the gaps between cones or cutters.

#include <benchmark/benchmark.h>

#include <string>

#include "bit/files/bit_file.hpp"

namespace tdbd::bench {
namespace {

bit::Bit read(const std::string& name) {
  return bit::read_bit(TDBD_SOURCE_DIR "/cases/bits/" + name + ".toml", bit::DirectionRule::hybrid,
                       bit::InsideRule::down)
      .bit;
}

void build(benchmark::State& state, const std::string& name) {
  bit::Bit bit;
  for (auto _ : state) {
    bit = read(name);
    benchmark::DoNotOptimize(bit.parts.data());
  }
  state.counters["parts"] = static_cast<double>(bit.parts.size());
  state.counters["cutters"] = static_cast<double>(bit.cutters.size());
}

/// Median of five repetitions.
void repeat(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMillisecond)->Repetitions(5)->ReportAggregatesOnly();
}

BENCHMARK_CAPTURE(build, bit_r, "bit-r")->Apply(repeat);
BENCHMARK_CAPTURE(build, generated, "generated")->Apply(repeat);

}  // namespace
}  // namespace tdbd::bench
