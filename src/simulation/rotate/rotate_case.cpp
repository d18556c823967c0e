#include "simulation/rotate/rotate_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/hash.hpp"
#include "simulation/case/history_rows.hpp"
#include "simulation/case/rotate_keys.hpp"
#include "simulation/case/title_key.hpp"
#include "simulation/rotate/rotate_body.hpp"
#include "simulation/rotate/rotate_loads.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::Drift;
using dynamics::VelocityTorque;

/// Relative tolerance, in steps, within which a duration is a whole number of steps.
constexpr double whole_steps = 1e-6;

dynamics::Integrator read_integrator(Config c) {
  using namespace integrator_keys;
  dynamics::Integrator i;
  i.drift = c.read(drift);
  i.drifts_per_step = static_cast<int>(c.read(drifts_per_step));
  i.order = static_cast<int>(c.read(order));
  if (i.order % 2 != 0) c.problem(order, fmt::format("{}", i.order), "2, 4, 6 or 8");
  // Only the symmetric treatment allows compositions of higher order.
  const auto usual = i.order == 2 ? VelocityTorque::predicted : VelocityTorque::symmetric;
  i.velocity_torque = c.read(velocity_torque, std::optional(usual));
  return i;
}

void read_rotate_output(Config c, RotateCase& r) {
  using namespace rotate_output_keys;
  r.history_every = c.read(history_every, usual_history_every(r.time.steps));
  if (c.has(checkpoint_every.name)) r.checkpoint_every = c.read(checkpoint_every);
}

}  // namespace

RotateTime read_rotate_time(Config c) {
  constexpr double most_steps = 1e15;
  RotateTime t;
  t.step = c.read(rotate_time_keys::step);
  t.duration = c.read(rotate_time_keys::duration);
  if (!c.has(rotate_time_keys::step) || !c.has(rotate_time_keys::duration)) return t;
  const double ratio = t.duration / t.step;
  if (ratio < 1.0 - whole_steps)
    c.problem(rotate_time_keys::step, fmt::format("{} s for a run of {} s", t.step, t.duration),
              "at most the duration");
  if (ratio > most_steps)
    c.problem(rotate_time_keys::step, fmt::format("{} s, which makes {:.3g} steps", t.step, ratio),
              fmt::format("at most {} steps", most_steps));
  t.steps = std::lround(std::clamp(ratio, 1.0, most_steps));
  if (std::abs(ratio - static_cast<double>(t.steps)) <= whole_steps) return t;
  t.steps = std::lround(std::ceil(std::clamp(ratio, 1.0, most_steps)));
  t.step = t.duration / static_cast<double>(t.steps);
  return t;
}

std::string drift_name(Drift drift) {
  for (const auto& named : integrator_keys::drift.values)
    if (named.value == drift && !named.name.empty()) return std::string(named.name);
  return "";
}

bool is_rotate_case(const std::string& path) {
  return Config::read_file(path, {}).has(body_keys::table);
}

RotateCase read_rotate_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  RotateCase r;
  r.path = path;
  r.title = c.read(title_keys::title);
  BodyStart start = read_body_start(c);
  r.loads = read_loads(c);
  r.integrator = read_integrator(c.table(integrator_keys::table));
  r.time = read_rotate_time(c.table(rotate_time_keys::table));
  read_rotate_output(c.table(rotate_output_keys::table), r);
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
