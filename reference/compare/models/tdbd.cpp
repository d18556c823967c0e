#include <cmath>
#include <numbers>

#include "reference/compare/models/answers.hpp"
#include "reference/compare/models/free_run.hpp"
#include "reference/compare/models/tdbd_sums.hpp"
#include "reference/literature/surface/spokes.hpp"

namespace tdbd::reference {
namespace {

using simulation::Simulation;

constexpr double full_circle = 2.0 * std::numbers::pi;

/// State of the run at a time: rotation and removed volume so far.
struct Reading {
  double turned = 0.0;          ///< rad
  double z = 0.0;               ///< m, in the rock
  std::vector<double> cones;    ///< rad
  std::vector<double> removed;  ///< m3, per piece
  double removed_in_all = 0.0;  ///< m3
};

Reading reading_of(const TdbdSums& sums, const Simulation& s) {
  return {s.state.place.turned, simulation::over_rock(s.state.place).p.z(),
          simulation::angles_of(s.state.cones), removed_by_piece(sums, s),
          s.state.ledger.removed.value()};
}

/// The bottom on a circle: spokes with one node each, at its radius.
BottomCircle bottom_of(const CompareCase& c, const Simulation& s) {
  const Spokes nodes = spokes_of(mesh::compact(s.state.rock.surface), 2.0 * c.options.circle,
                                 c.options.circle_samples, 1);
  return {c.options.circle, nodes.depth};
}

void set_lateral_quantities(const TdbdSums& sums, Findings& f) {
  const double steps = static_cast<double>(sums.series.weight.size());
  const Eigen::Vector2d lateral_B = sums.lateral_B / steps;
  say(f, Quantity::imbalance, lateral_B.norm() / *saying(f, Quantity::weight).value);
  say(f, Quantity::imbalance_direction, direction_of(lateral_B));
  say(f, Quantity::side_force, sums.side / steps);
}

void set_cutter_quantities(const CompareCase& c, const TdbdSums& sums, Findings& f) {
  const double cutters = static_cast<double>(c.ours.bit.cutters.size());
  const double steps = static_cast<double>(sums.series.weight.size());
  say(f, Quantity::share_moved_backwards, static_cast<double>(sums.backwards) / cutters / steps);
  set_missing(f, of_cones, no_cones);
}

void say_cones(const CompareCase& c, const TdbdSums& sums, const Reading& from, const Reading& to,
               Findings& f) {
  double sum = 0.0;
  for (std::size_t k = 0; k < to.cones.size(); ++k) {
    const double ratio = -(to.cones[k] - from.cones[k]) / (to.turned - from.turned);
    f.parts.push_back({c.ours.bit.cones[k].name, 0.0, PartQuantity::cone_speed_ratio, ratio});
    sum += ratio;
  }
  say(f, Quantity::cone_speed_ratio, sum / static_cast<double>(to.cones.size()));
  const Noise contacts = noise_of(sums.teeth, 1);
  say(f, Quantity::teeth_in_contact, contacts.mean);
  say(f, Quantity::teeth_in_contact_variance, std::pow(contacts.share * contacts.mean, 2));
  set_missing(f, Quantity::share_moved_backwards, no_cutters);
}

void say_what_it_cannot(Findings& f) {
  set_missing(f, of_weight,
              "it drills at a given rate here; motion.kind = \"drilling\" finds a weight's rate");
  set_missing(f, flats, "its cutters do not wear while they drill");
}

}  // namespace

Findings run_tdbd_model(const Question& q) {
  const CompareCase& c = q.asked;
  Findings f;
  Simulation s = simulation::start(c.ours);
  TdbdSums sums = start_sums(c.ours);
  const long total = c.ours.time.steps - c.ours.time.first, counted = counted_steps(c);
  Reading from;
  for (long step = 0; step < total; ++step) {
    if (step == total - counted) from = reading_of(sums, s);
    simulation::step(c.ours, s);
    if (step >= total - counted) add_step(c.ours, s, sums);
  }
  const Reading to = reading_of(sums, s);
  const double turns = (to.turned - from.turned) / full_circle;
  std::vector<double> volumes = to.removed;
  for (std::size_t i = 0; i < volumes.size(); ++i)
    volumes[i] = (volumes[i] - from.removed[i]) / turns;
  const FreeMotion motion{to.z - from.z, to.turned - from.turned, sums.squares,
                          static_cast<double>(counted) * c.ours.time.step, counted};
  set_load_quantities(f, sums.series, is_free(c) ? found_advance(motion) : c.advance);
  if (is_free(c)) set_free_motion_quantities(c, motion, f);
  set_lateral_quantities(sums, f);
  say(f, Quantity::removed_per_revolution, (to.removed_in_all - from.removed_in_all) / turns);
  say(f, Quantity::resolution_at_gage, c.ours.rock.edge_length);
  set_piece_quantities(c.ours, sums, volumes, f);
  if (c.ours.bit.cones.empty())
    set_cutter_quantities(c, sums, f);
  else
    say_cones(c, sums, from, to, f);
  set_missing(f, Quantity::torque_noise_by_crossing, no_spokes);
  say_what_it_cannot(f);
  f.bottom = bottom_of(c, s);
  f.cost = {0.0, static_cast<double>(total) * c.ours.time.step, total};
  return f;
}

}  // namespace tdbd::reference
