#include "benchmarks/drilling.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <numbers>

namespace tdbd::bench {

Drilling after_one_revolution(const std::string& name, double edge_length,
                              std::vector<std::string> settings) {
  const std::string path = fmt::format("{}/cases/{}.toml", TDBD_SOURCE_DIR, name);
  Drilling d;
  settings.push_back(fmt::format("rock.edge_length={}", edge_length));
  d.plan = simulation::read_case(path, settings);
  d.run = simulation::start(d.plan);
  const double per_step = simulation::angle_turned(d.plan.motion, d.plan.time.step);
  drill(d, std::lround(2.0 * std::numbers::pi / std::abs(per_step)));
  return d;
}

Pose pose_after(const Drilling& d, double steps) {
  const double done = static_cast<double>(d.run.state.steps_done);
  return simulation::pose_at(d.plan.motion, d.plan.time.step * (done + steps));
}

void drill(Drilling& d, long steps) {
  for (long i = 0; i < steps; ++i) simulation::step(d.plan, d.run);
}

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace tdbd::bench
