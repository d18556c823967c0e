#include "reference/compare/models/free_run.hpp"

#include <fmt/format.h>

#include <numbers>

#include "bit/cutter/cutter.hpp"
#include "core/error.hpp"
#include "reference/compare/models/led_bit.hpp"
#include "reference/literature/drag/spokes/spoke_cutter.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::reference {
namespace {

constexpr double free_circle = 2.0 * std::numbers::pi;

/// Sums over the counted steps.
struct FreeSums {
  LoadSeries series;
  Eigen::Vector2d lateral_B = Eigen::Vector2d::Zero();  ///< N
  double side = 0.0;                                    ///< N
  std::vector<Vec3> force_B;                            ///< N, on each cutter
  std::vector<double> area;                             ///< m2, of each
  long backwards = 0;                                   ///< number of cutters that move backwards
};

void add_tips(const CompareCase& c, const FreeInstant& at, FreeSums& sums) {
  for (const bit::Cutter& cutter : c.ours.bit.cutters) {
    const Vec3 arm_W = turned(at.place, bit::tip_B(cutter));
    const Vec3 v_W = at.v_W + at.turn_rate * Vec3(-arm_W.y(), arm_W.x(), 0.0);
    if (v_W.dot(turned(at.place, cutter.X_BC.R.col(0))) < 0.0) ++sums.backwards;
  }
}

void add_free_loads(const FreeModel& m, const FreeInstant& at, FreeSums& sums) {
  const BitPlace back{Vec3::Zero(), -at.place.angle};
  Vec3 whole_B = Vec3::Zero();
  for (std::size_t i = 0; i < sums.force_B.size(); ++i) {
    const Vec3 force_B = turned(back, (*m.force_W)[i]);
    whole_B += force_B;
    sums.force_B[i] += force_B;
    sums.area[i] += (*m.area)[i];
  }
  sums.series.weight.push_back(-whole_B.z());
  sums.series.torque.push_back(-*m.torque);
  sums.lateral_B += whole_B.head<2>();
  sums.side += whole_B.head<2>().norm();
}

void check_finite(const FreeModel& m, const FreeInstant& at, double time) {
  constexpr double far = 10.0;  // m
  if (!(at.place.p_WB.norm() < far))
    throw InputError(fmt::format(
        "{}: found a motion that diverges at {:.4g} s, needs a shorter time.step or another string",
        m.title, time));
}

void say_free_cutters(const CompareCase& c, const FreeSums& sums, Findings& f) {
  const double steps = static_cast<double>(sums.series.weight.size());
  for (std::size_t i = 0; i < sums.area.size(); ++i) {
    const bit::Cutter& cutter = c.ours.bit.cutters[i];
    const CutterNumbers numbers = forces_of(cutter, sums.force_B[i] / steps);
    const auto tell = [&](PartQuantity q, double value) {
      f.parts.push_back({simulation::cutter_name(cutter), cutter.tip_radius, q, value});
    };
    tell(PartQuantity::area, sums.area[i] / steps);
    tell(PartQuantity::force_into_rock, numbers.normal);
    tell(PartQuantity::drag, numbers.drag);
  }
}

void say_free_sums(const CompareCase& c, const FreeSums& sums, const FreeMotion& motion,
                   Findings& f) {
  const double steps = static_cast<double>(motion.steps);
  const double tips = steps * static_cast<double>(sums.area.size());
  set_load_quantities(f, sums.series, found_advance(motion));
  set_lateral_quantities(sums.lateral_B / steps, sums.side / steps, f);
  say(f, Quantity::share_moved_backwards, static_cast<double>(sums.backwards) / tips);
  set_free_motion_quantities(c, motion, f);
  say_free_cutters(c, sums, f);
}

}  // namespace

double found_advance(const FreeMotion& m) { return m.sunk / m.turned * free_circle; }

void set_free_motion_quantities(const CompareCase& c, const FreeMotion& m, Findings& f) {
  const double rate = m.sunk / m.duration;
  say(f, Quantity::rate_of_penetration, rate);
  say(f, Quantity::whirl_radius, std::sqrt(m.squares / static_cast<double>(m.steps)));
  if (!c.options.weight_on_bit)
    return set_missing(f, of_weight, "the top goes down at a given rate: the weight is the result");
  say(f, Quantity::rate_at_weight, rate);
  say(f, Quantity::torque_at_weight, *saying(f, Quantity::torque).value);
}

void run_free_model(const CompareCase& c, const FreeModel& model, Findings& f) {
  const long total = c.ours.time.steps - c.ours.time.first, counted = counted_steps(c);
  const std::size_t cutters = c.ours.bit.cutters.size();
  const double h = c.ours.time.step;
  FreeSums sums{{h, {}, {}},
                Eigen::Vector2d::Zero(),
                0.0,
                std::vector<Vec3>(cutters, Vec3::Zero()),
                std::vector<double>(cutters)};
  FreeMotion motion;
  FreeInstant start;
  double hole = 0.0;
  for (long step = 0; step < total; ++step) {
    const FreeInstant at = model.now();
    check_finite(model, at, h * static_cast<double>(step));
    if (step == total - counted) start = at, hole = model.hole();
    model.advance();
    if (step < total - counted) continue;
    add_free_loads(model, at, sums);
    add_tips(c, at, sums);
    motion.squares += at.place.p_WB.head<2>().squaredNorm();
    ++motion.steps;
  }
  const FreeInstant end = model.now();
  motion.sunk = end.place.p_WB.z() - start.place.p_WB.z();
  motion.turned = end.place.angle - start.place.angle;
  motion.duration = h * static_cast<double>(counted);
  say_free_sums(c, sums, motion, f);
  say(f, Quantity::removed_per_revolution, (model.hole() - hole) / motion.turned * free_circle);
  f.cost = {0.0, h * static_cast<double>(total), total};
}

}  // namespace tdbd::reference
