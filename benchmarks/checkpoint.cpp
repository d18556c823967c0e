// A checkpoint of a rock of some 350 000 triangles: time to write it, time to read it, size.
//   build/bench/benchmarks/checkpoint

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/command.hpp"
#include "benchmarks/workloads.hpp"
#include "simulation/result/recorder.hpp"

namespace tdbd::bench {
namespace {

namespace fs = std::filesystem;

struct ProgramOptions {
  double edge_length_mm = 0.6;
  int repeats = 9;
};

double median(std::vector<double> x) {
  std::ranges::sort(x);
  return x[x.size() / 2];
}

/// Writes to the current directory, so that the user chooses the disk.
void measure(const ProgramOptions& wish) {
  const Workload w{"standard", "standard-workload", 1e-3 * wish.edge_length_mm, {}, ""};
  Drilling d = start_workload(w, {}, 20);
  const fs::path file = fmt::format("checkpoint-{}.bin", getpid());
  std::vector<double> writing, reading;
  for (int i = 0; i < wish.repeats; ++i) {
    const double begin = wall_seconds();
    simulation::write_checkpoint(file, d.plan, d.run, {});
    writing.push_back(wall_seconds() - begin);
    const double read = wall_seconds();
    simulation::read_checkpoint(file, d.plan);
    reading.push_back(wall_seconds() - read);
  }
  fmt::print("{} triangles: written in {:.3f} s, read in {:.3f} s (medians of {}), {:.1f} MB\n",
             d.run.state.rock.surface.triangle_count(), median(writing), median(reading),
             wish.repeats, 1e-6 * static_cast<double>(fs::file_size(file)));
  fs::remove(file);
}

}  // namespace
}  // namespace tdbd::bench

int main(int argc, char** argv) {
  CLI::App app("Times the checkpoint of a large rock.");
  tdbd::bench::ProgramOptions wish;
  app.add_option("--edge", wish.edge_length_mm, "mm")->capture_default_str();
  app.add_option("--repeats", wish.repeats)->capture_default_str();
  return tdbd::bench::parse_and_run(app, argc, argv, [&] { tdbd::bench::measure(wish); });
}
