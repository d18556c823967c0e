#include "simulation/rotate/rotate_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/hash.hpp"
#include "simulation/rotate/rotate_body.hpp"
#include "simulation/rotate/rotate_loads.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::Drift;
using dynamics::VelocityTorque;

/// A history of the default length has at most about so many rows.
constexpr long history_rows = 10'000;

/// A duration counts as whole steps to this; scale: one step.
constexpr double whole_steps = 1e-6;

const std::vector<std::pair<std::string, Drift>>& drift_names() {
  static const std::vector<std::pair<std::string, Drift>> names{
      {"split", Drift::split},
      {"three-axis", Drift::three_axis},
      {"lie-midpoint", Drift::lie_midpoint},
      {"lie-mean", Drift::lie_mean}};
  return names;
}

dynamics::Integrator read_integrator(Config c) {
  dynamics::Integrator i;
  i.drift = c.choice<Drift>("drift", drift_names(), Drift::split);
  i.drifts_per_step = static_cast<int>(c.integer("drifts_per_step", 1, 1, 1000));
  i.order = static_cast<int>(c.integer("order", 2, 2, 8));
  if (i.order % 2 != 0) c.problem("order", fmt::format("{}", i.order), "2, 4, 6 or 8");
  // Only the symmetric treatment composes to a higher order.
  i.velocity_torque = c.choice<VelocityTorque>(
      "velocity_torque",
      {{"predicted", VelocityTorque::predicted}, {"symmetric", VelocityTorque::symmetric}},
      i.order == 2 ? VelocityTorque::predicted : VelocityTorque::symmetric);
  return i;
}

/// Steps of the length asked for, or of the next shorter one that fits the duration.
RotateTime read_time(Config c) {
  constexpr double most_steps = 1e15;
  RotateTime t;
  t.step = c.quantity("step", "s", std::nullopt, Range::positive());
  t.duration = c.quantity("duration", "s", std::nullopt, Range::positive());
  if (!c.has("step") || !c.has("duration")) return t;
  const double ratio = t.duration / t.step;
  if (ratio < 1.0 - whole_steps)
    c.problem("step", fmt::format("{} s for a run of {} s", t.step, t.duration),
              "at most the duration");
  if (ratio > most_steps)
    c.problem("step", fmt::format("{} s, which makes {:.3g} steps", t.step, ratio),
              fmt::format("at most {} steps", most_steps));
  t.steps = std::lround(std::clamp(ratio, 1.0, most_steps));
  if (std::abs(ratio - static_cast<double>(t.steps)) <= whole_steps) return t;
  t.steps = std::lround(std::ceil(std::clamp(ratio, 1.0, most_steps)));
  t.step = t.duration / static_cast<double>(t.steps);
  return t;
}

long read_history_every(Config c, long steps) {
  const long fallback = std::max(1L, (steps + history_rows - 1) / history_rows);
  return c.integer("history_every", fallback, 1, 1'000'000'000'000);
}

}  // namespace

std::string drift_name(Drift drift) {
  for (const auto& [name, named] : drift_names())
    if (named == drift) return name;
  return "";
}

bool is_rotate_case(const std::string& path) { return Config::read_file(path, {}).has("body"); }

RotateCase read_rotate_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  RotateCase r;
  r.path = path;
  r.title = c.text("title", "");
  BodyStart start = read_body_start(c);
  r.loads = read_loads(c);
  r.integrator = read_integrator(c.table("integrator"));
  r.time = read_time(c.table("time"));
  r.history_every = read_history_every(c.table("output"), r.time.steps);
  c.finish();
  r.body = std::move(start.body);
  r.start = std::move(start.state);
  r.files = c.files();
  r.resolved = c.resolved();
  r.hash = fnv1a_hex(c.fingerprint());
  r.quantities = c.quantities();
  return r;
}

}  // namespace tdbd::simulation
