#include "benchmarks/drilling.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <numbers>
#include <utility>

namespace tdbd::bench {
namespace {

double seconds_of(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

simulation::Case read_plan(const std::string& name, double edge_length,
                           std::vector<std::string> settings) {
  settings.push_back(fmt::format("rock.edge_length={}", edge_length));
  return simulation::read_case(fmt::format("{}/cases/{}.toml", TDBD_SOURCE_DIR, name), settings);
}

Drilling start_drilling(const std::string& name, double edge_length,
                        std::vector<std::string> settings) {
  Drilling d;
  d.plan = read_plan(name, edge_length, std::move(settings));
  d.run = simulation::start(d.plan);
  return d;
}

Drilling after_one_revolution(const std::string& name, double edge_length,
                              std::vector<std::string> settings) {
  Drilling d = start_drilling(name, edge_length, std::move(settings));
  drill(d, steps_of_a_revolution(d.plan));
  return d;
}

long steps_of_a_revolution(const simulation::Case& plan) {
  const double per_step = simulation::angle_turned(plan.motion, plan.time.step);
  return std::lround(2.0 * std::numbers::pi / std::abs(per_step));
}

Pose pose_after(const Drilling& d, double steps) {
  const double done = static_cast<double>(d.run.state.steps_done);
  return simulation::pose_at(d.plan.motion, d.plan.time.step * (done + steps));
}

void drill(Drilling& d, long steps) {
  for (long i = 0; i < steps; ++i) simulation::step(d.plan, d.run);
}

double cpu_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }
double wall_seconds() { return seconds_of(CLOCK_MONOTONIC); }

}  // namespace tdbd::bench
