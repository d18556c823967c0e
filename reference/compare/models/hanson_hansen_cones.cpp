#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/cones_run.hpp"

/// Hanson and Hansen's roller cone bit under the reference weight.
namespace tdbd::reference {
namespace {

constexpr double longest_cones_step = 0.1e-3;  // s
constexpr double settling = 3.0;               // s: until flat rock has become the bit's own bottom
constexpr double spring_length = 10.0;         // m: its force changes by at most 0.1 % over 10 mm
constexpr double rock_to_drill = 0.5;          // m
constexpr double heavy_inertia = 1e6;          // kg m2: the bit rotates uniformly

ConesSetup setup_of(const Question& q, const RollerBit& bit) {
  const CompareCase& c = q.asked;
  ConesSetup s = cones_setup(c, bit);
  s.system.stiffness = Vec3(0.0, 0.0, q.weight / spring_length).asDiagonal();
  s.system.top_z = spring_length;
  s.system.inertia = heavy_inertia;
  s.system.rate = c.ours.motion.rate_of_penetration;
  s.system.speed = c.ours.motion.rotary_speed;
  s.depth = rock_to_drill;
  s.step = std::min(c.ours.time.step, longest_cones_step);
  return s;
}

ConesCount count_of(const CompareCase& c, double step) {
  const double turn = 2.0 * std::numbers::pi / c.ours.motion.rotary_speed,
               asked = c.ours.time.step * static_cast<double>(c.ours.time.steps),
               counted = c.options.counted_revolutions * turn;
  ConesCount n;
  n.counted = std::lround(counted / step);
  n.before = std::lround(std::max(asked - counted, settling) / step);
  return n;
}

void say_drilled(const HansonHansenCones& m, const ConesRun& run, Findings& f) {
  const ConesSums& s = run.sums;
  const Noise torque = noise_of(s.series.torque, 1);
  say(f, Quantity::rate_at_weight,
      (m.state[2] - run.from[2]) / (static_cast<double>(s.contacts.size()) * m.step));
  say(f, Quantity::torque_at_weight, torque.mean);
  say(f, Quantity::torque_noise, torque.share);
  const auto together = static_cast<std::size_t>(std::lround(5e-3 / m.step));
  say(f, Quantity::torque_noise_5ms, noise_of(s.series.torque, together).share);
}

void note_schedule(const CompareCase& c, const HansonHansenCones& m, const ConesCount& n,
                   Findings& f) {
  f.notes.push_back(
      fmt::format("it starts from flat rock and runs {:.3g} s, of which the last {:g} revolutions "
                  "count; its step is {:g} ms",
                  m.step * static_cast<double>(n.before + n.counted), c.options.counted_revolutions,
                  1e3 * m.step));
  f.notes.push_back(
      fmt::format("its weight is the force of a soft spring on {:g} kg, without damping; "
                  "it turns evenly, lateral motion is locked",
                  m.system.mass));
}

}  // namespace

Findings run_hanson_hansen_cones_model(const Question& q) {
  const CompareCase& c = q.asked;
  const RollerBit bit = roller_bit_of(c.ours.bit, "Hanson and Hansen");
  if (q.weight <= 0.0)
    throw InputError(
        "Hanson and Hansen: found no weight, needs compare.weight_on_bit or a model beside it that "
        "finds one");
  HansonHansenCones m = hanson_hansen_cones(bit, setup_of(q, bit));
  const ConesCount n = count_of(c, m.step);
  const ConesRun run = run_cones(m, n);
  Findings f;
  say_drilled(m, run, f);
  set_cones_run_quantities(c, m, run, q.weight, c.options.counted_revolutions, f);
  f.cost.steps = n.before + n.counted;
  f.cost.simulated = m.step * static_cast<double>(f.cost.steps);
  note_schedule(c, m, n, f);
  set_missing(f, {Quantity::weight, Quantity::torque, Quantity::work_of_a_turn_torque},
              "it finds the rate of a weight, not the weight of a rate");
  return f;
}

}  // namespace tdbd::reference
