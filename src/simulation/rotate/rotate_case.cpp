#include "simulation/rotate/rotate_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/hash.hpp"
#include "simulation/case/rotate_settings.hpp"
#include "simulation/case/run_settings.hpp"
#include "simulation/rotate/rotate_body.hpp"

namespace tdbd::simulation {
namespace {

using dynamics::Drift;

/// Relative tolerance, in steps, within which a duration is a whole number of steps.
constexpr double whole_steps = 1e-6;

dynamics::Integrator read_integrator(Config& whole) {
  const dynamics::Integrator i = read_table<IntegratorSettings>(whole).integrator;
  if (i.order % 2 != 0)
    whole.table(IntegratorSettings::table)
        .problem("order", fmt::format("{}", i.order), "2, 4, 6 or 8");
  return i;
}

void doubt_step(Config& whole, RotateCase& r) {
  constexpr double largest_turn = largest_turn_in_step;
  r.place_of_step = whole.table(RotateTimeSettings::table).place("step");
  const double speed = dynamics::angular_velocity(r.body, r.start).norm();
  if (!(speed * r.time.step > largest_turn)) return;
  const std::string key = "step", table(RotateTimeSettings::table.name);
  r.warnings.push_back(
      {r.place_of_step, table + "." + key,
       fmt::format("the body turns by {:.3g} rad in a step of {:.3g} s at the start; for "
                   "meaningful results use at most {} rad: {:.2g} s",
                   speed * r.time.step, r.time.step, largest_turn, largest_turn / speed)});
}

}  // namespace

RotateTime read_rotate_time(Config& whole) {
  constexpr double most_steps = 1e15;
  const auto settings = read_table<RotateTimeSettings>(whole);
  Config c = whole.table(RotateTimeSettings::table);
  RotateTime t{settings.step, settings.duration};
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

std::string drift_name(Drift drift) {
  for (const auto& named : IntegratorSettings::drifts)
    if (named.value == drift && !named.name.empty()) return std::string(named.name);
  return "";
}

bool is_rotate_case(const std::string& path) {
  return Config::read_file(path, {}).has(BodySettings::table);
}

RotateCase read_rotate_case(const std::string& path, const std::vector<std::string>& overrides) {
  Config c = Config::read_file(path, overrides);
  RotateCase r;
  r.path = path;
  TitleSettings title;
  read_fields(c, title);
  r.title = title.title;
  BodyStart start = read_body_start(c);
  r.loads = read_loads(c);
  r.loads.cones = std::move(start.cone_loads);
  r.integrator = read_integrator(c);
  r.time = read_rotate_time(c);
  const auto output =
      read_table(c, RotateOutput{.history_every = usual_history_every(r.time.steps)});
  r.history_every = output.history_every;
  r.checkpoint_every = output.checkpoint_every;
  c.finish();
  r.body = std::move(start.body);
  r.start = std::move(start.state);
  r.files = c.files();
  r.resolved = c.resolved();
  r.hash = fnv1a_hex(c.fingerprint());
  r.quantities = c.quantities();
  doubt_step(c, r);
  return r;
}

}  // namespace tdbd::simulation
