// Steps of a workload, for a program that counts their instructions:
//   valgrind --tool=callgrind --instr-atstart=no build/count/benchmarks/instructions standard-1.0
// Only the steps after the warm-up are counted. benchmarks/count.py runs this and prints a table.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "benchmarks/command.hpp"
#include "benchmarks/workloads.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else  // all instructions are counted, including those of the start
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_STOP_INSTRUMENTATION
#endif

namespace tdbd::bench {
namespace {

struct ProgramOptions {
  std::string workload;
  long steps = 20;
  long warm = -1;  ///< negative: one revolution
  int threads = 1;
  std::vector<std::string> settings;
};

/// Drills the counted steps. A separate function that is not inlined, because count.py finds it by
/// its name.
[[gnu::noinline]] void counted_steps(Drilling& d, long steps) { drill(d, steps); }

void count(Drilling d, const ProgramOptions& wish) {
  CALLGRIND_START_INSTRUMENTATION;
  counted_steps(d, wish.steps);
  CALLGRIND_STOP_INSTRUMENTATION;
  fmt::print("workload {}\nsteps {}\n", wish.workload, wish.steps);
}

std::string names() {
  std::string all;
  for (const Workload& w : workloads()) all += " " + w.name;
  return all + " " + metre_workload().name;
}

void run(const ProgramOptions& wish) {
  const ThreadLimit threads(wish.threads);
  for (const Workload& w : workloads())
    if (w.name == wish.workload) return count(start_workload(w, wish.settings, wish.warm), wish);
  if (metre_workload().name == wish.workload)
    return count(start_workload(metre_workload(), wish.settings, wish.warm), wish);
  throw InputError(fmt::format("workload: found {}, expected one of{}", wish.workload, names()));
}

}  // namespace
}  // namespace tdbd::bench

int main(int argc, char** argv) {
  tdbd::bench::ProgramOptions wish;
  CLI::App app{"Some steps of a workload, for valgrind --tool=callgrind --instr-atstart=no."};
  app.add_option("WORKLOAD", wish.workload, "what is drilled")->required();
  app.add_option("--steps", wish.steps, "steps that are counted")->check(CLI::PositiveNumber);
  app.add_option("--warm", wish.warm, "steps before them; a revolution if not given");
  app.add_option("--threads", wish.threads, "threads")->check(CLI::PositiveNumber);
  app.add_option("--set", wish.settings, "KEY=VALUE of the case");
  return tdbd::bench::parse_and_run(app, argc, argv, [&] { tdbd::bench::run(wish); });
}
