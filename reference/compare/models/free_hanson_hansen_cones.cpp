#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/cones_run.hpp"
#include "reference/compare/models/free_run.hpp"
#include "reference/compare/models/free_string.hpp"

/// Hanson and Hansen's roller cone bit on the case's string.
namespace tdbd::reference {
namespace {

constexpr double spare_rock = 0.3;  // m, in addition to what the initial rate would drill
constexpr double longest_free_step =
    0.025e-3;  // s: at 0.1 ms light cones chatter due to the friction of their teeth, which adds a
               // fifth to the torque

/// Number of steps of the model per step of the case.
long steps_in_one(const CompareCase& c) {
  return std::max(1L, std::lround(std::ceil(c.ours.time.step / longest_free_step - 1e-9)));
}

/// The bit starts above flat rock that its lowest tooth touches, with the motion of the case.
HansonHansenCones model_on_string(const CompareCase& c, const RollerBit& bit, const FreeString& s) {
  ConesSetup setup = cones_setup(c, bit);
  setup.system = hanson_hansen_system(c, s);
  setup.lateral_locked = false;
  setup.step = c.ours.time.step / static_cast<double>(steps_in_one(c));
  setup.depth =
      s.start_rate * c.ours.time.step * static_cast<double>(c.ours.time.steps) + spare_rock;
  HansonHansenCones m = hanson_hansen_cones(bit, setup);
  m.system.top_z = s.top_z - s.z;  // the model's bit starts at z = 0
  m.system.top_angle = s.top_angle;
  m.state[5] = s.start_rate;
  return m;
}

ConesCount count_on_string(const CompareCase& c) {
  ConesCount n;
  n.counted = counted_steps(c) * steps_in_one(c);
  n.before = (c.ours.time.steps - c.ours.time.first) * steps_in_one(c) - n.counted;
  return n;
}

FreeMotion motion_of(const HansonHansenCones& m, const ConesRun& run) {
  const HansonHansenState &a = run.from, &b = m.state;
  const auto steps = static_cast<long>(run.sums.contacts.size());
  return {(b[2] - b[8]) - (a[2] - a[8]), b[6] - a[6], run.sums.squares,
          m.step * static_cast<double>(steps), steps};
}

}  // namespace

Findings run_free_hanson_hansen_cones_model(const Question& q) {
  const CompareCase& c = q.asked;
  constexpr StringTerms terms = StringTerms::springs_and_dampers;
  const RollerBit bit = roller_bit_of(c.ours.bit, "Hanson and Hansen");
  const FreeString s = free_string(c, terms, "Hanson and Hansen", StartRock::own);
  HansonHansenCones m = model_on_string(c, bit, s);
  const ConesCount n = count_on_string(c);
  const ConesRun run = run_cones(m, n);
  const FreeMotion motion = motion_of(m, run);
  Findings f;
  set_load_quantities(f, run.sums.series, found_advance(motion));
  set_free_motion_quantities(c, motion, f);
  set_cones_run_quantities(c, m, run, *saying(f, Quantity::weight).value,
                           motion.turned / (2.0 * std::numbers::pi), f);
  f.cost.steps = n.before + n.counted;
  f.cost.simulated = m.step * static_cast<double>(f.cost.steps);
  f.notes.push_back(left_out(c, terms));
  f.notes.push_back(
      fmt::format("it starts from flat rock; only the string holds its bit sideways, since it has "
                  "no wall for cones; its step is {:g} ms",
                  1e3 * m.step));
  return f;
}

}  // namespace tdbd::reference
