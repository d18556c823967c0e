#include "reference/compare/models/cones_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/compare/models/blanks.hpp"

namespace tdbd::reference {
namespace {

constexpr double turn_of_cones_bit = 2.0 * std::numbers::pi;

void check_place(const HansonHansenCones& m) {
  constexpr double aside = 0.02;  // m, distance of the spokes' ends from the teeth
  const BitPlace place = place_in_rock(m.state);
  const double off = place.p_WB.head<2>().norm(), z = place.p_WB.z();
  if (off < aside && m.start_depth + z < m.bottom.frame.floor) return;
  throw InputError(fmt::format(
      "Hanson and Hansen: found a bit {:.3g} m beside the hole's axis and {:.3g} m deep "
      "at {:.4g} s, where its rock ends; needs a stiffer string or a shorter run",
      off, z, m.time));
}

void add_step_of(const HansonHansenCones& m, const HansonHansenState& before, ConesSums& sums) {
  sums.series.weight.push_back(-m.load.force_W.z());
  sums.series.torque.push_back(-m.load.torque);
  const Eigen::Vector2d lateral_W = m.load.force_W.head<2>();
  sums.lateral_B += Eigen::Rotation2Dd(-before[6]) * lateral_W;
  sums.side += lateral_W.norm();
  sums.squares += before[0] * before[0] + before[1] * before[1];
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
    const HansonHansenState before = m.state;
    advance(m);
    check_place(m);
    add_step_of(m, before, sums);
  }
  return sums;
}

void say_cone_speeds(const CompareCase& c, const HansonHansenCones& m, const ConesRun& run,
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

}  // namespace

ConesSetup cones_setup(const CompareCase& c, const RollerBit& bit) {
  ConesSetup s;
  s.rock.pressure = tooth_pressure(c, "Hanson and Hansen");
  s.rock.friction = tooth_friction(c, "Hanson and Hansen");
  s.layout = {c.options.spokes, c.options.spoke_spacing};
  s.cone_ratio = outer_rolling_ratio(bit);
  return s;
}

ConesRun run_cones(HansonHansenCones& m, const ConesCount& n) {
  for (long i = 0; i < n.before; ++i) {
    advance(m);
    check_place(m);
  }
  ConesRun run{m.state, m.tooth_removed, {}};
  run.sums = counted_run(m, n.counted);
  for (std::size_t i = 0; i < run.removed.size(); ++i)
    run.removed[i] = m.tooth_removed[i] - run.removed[i];
  return run;
}

void set_cones_run_quantities(const CompareCase& c, const HansonHansenCones& m, const ConesRun& run,
                              double weight, double turns, Findings& f) {
  const ConesSums& s = run.sums;
  const double steps = static_cast<double>(s.contacts.size());
  const Noise contacts = noise_of(s.contacts, 1);
  say(f, Quantity::teeth_in_contact, contacts.mean);
  say(f, Quantity::teeth_in_contact_variance, std::pow(contacts.share * contacts.mean, 2));
  say(f, Quantity::imbalance, s.lateral_B.norm() / steps / weight);
  say(f, Quantity::imbalance_direction, direction_of(s.lateral_B));
  say(f, Quantity::side_force, s.side / steps);
  double removed = 0.0;
  for (const double volume : run.removed) removed += volume;
  say(f, Quantity::removed_per_revolution, removed / turns);
  say_cone_speeds(c, m, run, f);
  const ToothNumbers& teeth = s.teeth;
  set_tooth_quantities(c, m.bit,
                       {over(teeth.force, steps), teeth.largest, over(teeth.contacts, steps),
                        over(run.removed, turns)},
                       f);
  say(f, Quantity::resolution_at_gage,
      turn_of_cones_bit * c.ours.bit.gage_radius / c.options.spokes);
  f.bottom = cones_bottom(c, m);
  f.series = s.series;
  set_missing(f, Quantity::torque_noise_by_crossing,
              "its teeth press between spokes too: none waits for a crossing");
  set_missing(f, Quantity::share_moved_backwards, no_cutters);
  set_missing(f, flats, no_wear);
}

}  // namespace tdbd::reference
