#include "reference/literature/drag/spokes/hanson_hansen_cones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/roller_case.hpp"
#include "reference/compare/models/tooth_parts.hpp"

/// Hanson and Hansen's roller cone bit under the reference weight.
namespace tdbd::reference {
namespace {

constexpr double turn_of_cones_bit = 2.0 * std::numbers::pi;
constexpr double longest_cones_step = 0.1e-3;  // s
constexpr double settling = 3.0;               // s: until flat rock has become the bit's own bottom
constexpr double spring_length = 10.0;         // m: its force keeps within 0.1 % over 10 mm
constexpr double rock_to_drill = 0.5;          // m
constexpr double heavy_inertia = 1e6;          // kg m2: the bit turns evenly

/// What is counted, at the last revolutions.
struct ConesCount {
  long before = 0, counted = 0;  ///< steps
  double turns = 0.0;            ///< counted, of the bit
};

/// Sums over the steps that count.
struct ConesSums {
  LoadSeries series;
  Eigen::Vector2d lateral_B = Eigen::Vector2d::Zero();  ///< N
  double side = 0.0;                                    ///< N
  std::vector<double> contacts;                         ///< of each step
  ToothNumbers teeth;                                   ///< sums over the steps
};

ConesSetup setup_of(const Question& q, const RollerBit& bit) {
  const CompareCase& c = q.asked;
  ConesSetup s;
  const double stiffness = q.weight / spring_length;
  s.system.stiffness = Vec3(0.0, 0.0, stiffness).asDiagonal();
  s.system.top_z = spring_length;
  s.system.inertia = heavy_inertia;
  s.system.rate = c.ours.motion.rate_of_penetration;
  s.system.speed = c.ours.motion.rotary_speed;
  s.rock.pressure = tooth_pressure(c, "Hanson and Hansen");
  s.rock.friction = tooth_friction(c, "Hanson and Hansen");
  s.layout = {c.options.spokes, c.options.spoke_spacing};
  s.depth = rock_to_drill;
  s.step = std::min(c.ours.time.step, longest_cones_step);
  s.cone_ratio = outer_rolling_ratio(bit);
  return s;
}

ConesCount count_of(const CompareCase& c, double step) {
  const double turn = turn_of_cones_bit / c.ours.motion.rotary_speed,
               asked = c.ours.time.step * static_cast<double>(c.ours.time.steps),
               counted = c.options.counted_revolutions * turn;
  ConesCount n;
  n.counted = std::lround(counted / step);
  n.before = std::lround(std::max(asked - counted, settling) / step);
  n.turns = c.options.counted_revolutions;
  return n;
}

void add_step_of(const HansonHansenCones& m, double angle, ConesSums& sums) {
  sums.series.weight.push_back(-m.load.force_W.z());
  sums.series.torque.push_back(-m.load.torque);
  const Eigen::Vector2d lateral_W = m.load.force_W.head<2>();
  sums.lateral_B += Eigen::Rotation2Dd(-angle) * lateral_W;
  sums.side += lateral_W.norm();
  sums.contacts.push_back(teeth_in_contact(m));
  for (std::size_t i = 0; i < m.teeth.size(); ++i) {
    const double force = -m.tooth_force_W[i].z();
    sums.teeth.force[i] += force;
    sums.teeth.largest[i] = std::max(sums.teeth.largest[i], force);
    if (!std::isnan(m.met[i])) sums.teeth.contacts[i] += 1.0;
  }
}

ConesSums counted_run(HansonHansenCones& m, long steps) {
  ConesSums sums;
  sums.series.step = m.step;
  for (std::vector<double>* values : {&sums.teeth.force, &sums.teeth.largest, &sums.teeth.contacts})
    values->resize(m.teeth.size());
  for (long i = 0; i < steps; ++i) {
    const double angle = m.state[6];
    advance(m);
    add_step_of(m, angle, sums);
  }
  return sums;
}

/// The model at the first step that counts, and what it did until the last.
struct ConesRun {
  HansonHansenState from;
  std::vector<double> removed;  ///< m3, by each tooth from there on
  ConesSums sums;
};

ConesRun run_cones(HansonHansenCones& m, const ConesCount& n) {
  for (long i = 0; i < n.before; ++i) advance(m);
  ConesRun run{m.state, m.tooth_removed, {}};
  run.sums = counted_run(m, n.counted);
  for (std::size_t i = 0; i < run.removed.size(); ++i)
    run.removed[i] = m.tooth_removed[i] - run.removed[i];
  return run;
}

void say_drilled(const Question& q, const HansonHansenCones& m, const ConesRun& run, double turns,
                 Findings& f) {
  const ConesSums& s = run.sums;
  const double steps = static_cast<double>(s.contacts.size());
  const Noise torque = noise_of(s.series.torque, 1), contacts = noise_of(s.contacts, 1);
  say(f, Quantity::rate_at_weight, (m.state[2] - run.from[2]) / (steps * m.step));
  say(f, Quantity::torque_at_weight, torque.mean);
  say(f, Quantity::torque_noise, torque.share);
  const auto together = static_cast<std::size_t>(std::lround(5e-3 / m.step));
  say(f, Quantity::torque_noise_5ms, noise_of(s.series.torque, together).share);
  say(f, Quantity::teeth_in_contact, contacts.mean);
  say(f, Quantity::teeth_in_contact_variance, std::pow(contacts.share * contacts.mean, 2));
  say(f, Quantity::imbalance, s.lateral_B.norm() / steps / q.weight);
  say(f, Quantity::imbalance_direction, direction_of(s.lateral_B));
  say(f, Quantity::side_force, s.side / steps);
  double removed = 0.0;
  for (const double volume : run.removed) removed += volume;
  say(f, Quantity::removed_per_revolution, removed / turns);
  f.series = s.series;
}

void say_free_cones(const CompareCase& c, const HansonHansenCones& m, const ConesRun& run,
                    Findings& f) {
  double sum = 0.0;
  for (std::size_t k = 0; k < m.bit.cones.size(); ++k) {
    const std::size_t i = bit_unknowns + 2 * k;
    const double ratio = (run.from[i] - m.state[i]) / (m.state[6] - run.from[6]);
    f.parts.push_back({c.ours.bit.cones[k].name, 0.0, PartQuantity::cone_speed_ratio, ratio});
    sum += ratio;
  }
  say(f, Quantity::cone_speed_ratio, sum / static_cast<double>(m.bit.cones.size()));
}

BottomCircle cones_bottom(const CompareCase& c, const HansonHansenCones& m) {
  BottomCircle circle{c.options.circle, {}};
  for (int k = 0; k < m.bottom.spokes(); ++k)
    circle.depth.push_back(surface_depth(m.bottom, k, circle.radius));
  return circle;
}

void note_schedule(const HansonHansenCones& m, const ConesCount& n, Findings& f) {
  f.notes.push_back(
      fmt::format("it starts from flat rock and runs {:.3g} s, of which the last {:g} revolutions "
                  "count; its step is {:g} ms",
                  m.step * static_cast<double>(n.before + n.counted), n.turns, 1e3 * m.step));
  f.notes.push_back(
      fmt::format("its weight is the force of a soft spring on {:g} kg, without damping; "
                  "it turns evenly, lateral motion is locked",
                  m.system.mass));
}

}  // namespace

Findings answer_of_hanson_hansen_cones(const Question& q) {
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
  say_drilled(q, m, run, n.turns, f);
  say_free_cones(c, m, run, f);
  const ToothNumbers& teeth = run.sums.teeth;
  const double steps = static_cast<double>(run.sums.contacts.size());
  say_tooth_numbers(c, m.bit,
                    {over(teeth.force, steps), teeth.largest, over(teeth.contacts, steps),
                     over(run.removed, n.turns)},
                    f);
  say(f, Quantity::resolution_at_gage,
      turn_of_cones_bit * c.ours.bit.gage_radius / c.options.spokes);
  f.bottom = cones_bottom(c, m);
  f.cost.steps = n.before + n.counted;
  f.cost.simulated = m.step * static_cast<double>(f.cost.steps);
  note_schedule(m, n, f);
  cannot_say(f, {Quantity::weight, Quantity::torque, Quantity::work_of_a_turn_torque},
             "it finds the rate of a weight, not the weight of a rate");
  cannot_say(f, Quantity::torque_noise_by_crossing,
             "its teeth press between spokes too: none waits for a crossing");
  cannot_say(f, Quantity::share_moved_backwards, no_cutters);
  cannot_say(f, flats, no_wear);
  return f;
}

}  // namespace tdbd::reference
