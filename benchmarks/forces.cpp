// Run time of a force law for one part.
#include <benchmark/benchmark.h>

#include "forces/law.hpp"

namespace tdbd {
namespace {

forces::PartCut cut_of(bit::PartKind kind) {
  forces::PartCut c;
  c.kind = kind;
  c.cut_area = 10e-6;
  c.contact_area = 4e-6;
  c.engaged_edge = 10e-3;
  c.depth = 1e-3;
  c.back_rake = 0.35;
  c.diameter = 16e-3;
  c.velocity = Vec3(1.0, 0.0, 0.01);
  c.normal = Vec3(0.0, 0.0, 1.0);
  c.strength = {.unconfined = 60e6, .confined = 100e6, .friction_angle = 0.5, .pressure = 20e6};
  return c;
}

/// Evaluates a law for a kind of part that it supports, with default coefficients or 0.5.
void force_of(benchmark::State& state, forces::Law law) {
  for (const forces::LawField& f : forces::law_fields(law)) *f.value = f.fallback.value_or(0.5);
  const bool face = forces::law_problem(law, bit::PartKind::face, 16e-3).empty();
  const bool tooth = forces::law_problem(law, bit::PartKind::tooth, 0.0).empty();
  const forces::PartCut cut = cut_of(face    ? bit::PartKind::face
                                     : tooth ? bit::PartKind::tooth
                                             : bit::PartKind::gage_pad);
  for (auto _ : state) {
    forces::PartCut loaded = cut;
    benchmark::DoNotOptimize(loaded);
    benchmark::DoNotOptimize(forces::force(law, loaded));
  }
}

}  // namespace
}  // namespace tdbd

int main(int argc, char** argv) {
  for (const std::string_view name : tdbd::forces::law_names())
    benchmark::RegisterBenchmark(std::string(name).c_str(), tdbd::force_of,
                                 tdbd::forces::law_named(name));
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
