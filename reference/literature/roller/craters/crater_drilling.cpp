#include "reference/literature/roller/craters/crater_drilling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/literature/roller/craters/crater_run.hpp"
#include "reference/literature/roller/teeth/round_end.hpp"

namespace tdbd::reference {
namespace {

/// The state, and the buffers of a step.
struct Drilling {
  const RollerBit& bit;
  const ToothLaw& law;
  const RollerSchedule& schedule;
  const CraterDrillingOptions& options;
  double turn = 0.0;              ///< rad, of the bit
  double z = 0.0, descent = 0.0;  ///< m, m/s, of the bit
  bool touched = false;
  std::vector<ConeTurn> cones;
  std::vector<double> cone_speeds, averaged;  ///< rad/s, N m
  std::vector<Course> cone_courses;
  std::vector<ConeTorque> torques;
  std::vector<ToothState> teeth_W;  ///< with the bit at depth 0
  std::vector<double> gaps;         ///< m, depth of the bit at which each tooth makes contact
  std::vector<double> forces;       ///< N
  std::vector<ToothPrint> prints;
  RoundEnd end;                    ///< without points: only the tips of teeth make contact
  std::vector<double> point_gaps;  ///< m, [tooth * points + point]
  std::vector<char> by_points;     ///< whether those of a tooth have been computed
};

Drilling started(const RollerBit& bit, const ToothLaw& law, const RollerSchedule& schedule,
                 const CraterDrillingOptions& options, std::size_t teeth) {
  const std::size_t cones = bit.cones.size();
  const double speed = -options.first_ratio * schedule.bit_speed;
  Drilling d{bit, law, schedule, options, 0.0, 0.0, 0.0, false, {}, {},
             {},  {},  {},       {},      {},  {},  {},  {},    {}, {}};
  d.cones.assign(cones, started_cone(0.0, speed, 0.0, 1.0, schedule.step, ConeStart::half_step));
  d.cone_speeds.assign(cones, speed);
  d.averaged.assign(cones, 0.0);
  d.cone_courses.assign(cones, {});
  d.torques.assign(cones, {});
  d.teeth_W.resize(teeth);
  d.gaps.assign(teeth, 0.0);
  d.forces.assign(teeth, 0.0);
  d.prints.assign(teeth, {});
  if (options.contact == ToothContact::round_end)
    d.end = round_end(options.print.sphere_radius, options.end_spacing, options.end_height);
  d.point_gaps.assign(teeth * d.end.points.size(), 0.0);
  d.by_points.assign(teeth, 0);
  return d;
}

/// The torque of the last forces, averaged if the model requires it.
double torque_on(Drilling& d, std::size_t k) {
  const CraterDrillingOptions& o = d.options;
  const double step = d.schedule.step;
  const double torque =
      torque_of_step(d.torques[k], d.cone_speeds[k], d.bit.cones[k].inertia, step, o.sliding);
  if (o.torque_average <= 0.0) return torque;
  d.averaged[k] += (torque - d.averaged[k]) * -std::expm1(-step / o.torque_average);
  return d.averaged[k];
}

void turn_cones(Drilling& d) {
  const double step = d.schedule.step;
  const bool given = d.turn < 2.0 * std::numbers::pi * d.options.prescribed_ratio_revolutions;
  for (std::size_t k = 0; k < d.cones.size(); ++k) {
    const double torque = given ? 0.0 : torque_on(d, k), inertia = d.bit.cones[k].inertia;
    if (d.options.way == ConeUpdate::increments) {
      advance_cone(d.cones[k], ConeReading::increments, torque, inertia, step);
      d.cone_speeds[k] = d.cones[k].increment / step;
    } else {
      d.cone_speeds[k] += step * torque / inertia;
      d.cones[k].angle += step * d.cone_speeds[k];
    }
    d.cone_courses[k] = {d.cones[k].angle, d.cone_speeds[k], 0.0};
  }
}

/// A round end is tested against ridges only if its tip is at most this far above the bottom at the
/// bit's previous depth, m.
constexpr double near_bottom = 5e-3;

/// Computes the places of the teeth, and the depth of the bit at which each contacts the bottom.
void place(Drilling& d, const ZMap& bottom) {
  const RollerMotion motion{{d.turn, d.schedule.bit_speed, 0.0}, {}};
  place_teeth(d.bit, motion, d.cone_courses, d.teeth_W);
  for (std::size_t i = 0; i < d.gaps.size(); ++i) {
    const Vec3& p = d.teeth_W[i].place;
    d.gaps[i] = level_at(bottom, p.x(), p.y()) - p.z();
    if (d.end.points.empty()) continue;
    d.by_points[i] = d.gaps[i] < d.z + near_bottom;
    if (d.by_points[i])
      d.gaps[i] = touch_round_end(d.end, p, bottom, &d.point_gaps[i * d.end.points.size()]);
  }
}

double force_of(const Drilling& d, std::size_t i, double z) {
  const double depth = z - d.gaps[i], share = print_share(d.options.print, d.prints[i], depth);
  if (share == 0.0) return 0.0;
  const std::size_t points = d.end.points.size();
  if (points == 0 || !d.by_points[i]) return share * tooth_force(d.law, depth);
  return share * round_end_force(d.end, d.law, &d.point_gaps[i * points], z);
}

double weight_at(const Drilling& d, double z) {
  double sum = 0.0;
  for (std::size_t i = 0; i < d.gaps.size(); ++i) sum += force_of(d, i, z);
  return sum;
}

/// Returns the number of evaluations of the weight.
int lower_bit(Drilling& d) {
  const double weight = d.schedule.weight, step = d.schedule.step;
  if (!d.touched) d.z = *std::min_element(d.gaps.begin(), d.gaps.end());
  d.touched = true;
  const auto carried = [&](double z) { return weight_at(d, z); };
  if (d.options.axial == AxialMotion::balance) {
    const WeightBalance found =
        weight_balance(carried, d.z, weight, d.options.balance, d.options.model);
    d.z = found.z;
    return found.evaluations;
  }
  // Implicit damping, which is stable for any step.
  d.descent = (d.descent + step * (weight - carried(d.z)) / d.options.mass) /
              (1.0 + step * d.options.axial_damping / d.options.mass);
  d.z += step * d.descent;
  return 1;
}

void leave_prints(Drilling& d, RollerRun& run) {
  const double known = deepest_known(d.law);
  for (std::size_t i = 0; i < d.gaps.size(); ++i) {
    const double depth = d.z - d.gaps[i];
    d.forces[i] = force_of(d, i, d.z);
    if (depth <= 0.0 && d.prints[i].deepest == 0.0) continue;
    const Vec3 tip_W = d.teeth_W[i].place + Vec3(0.0, 0.0, d.z);
    run.tooth_volume[i] +=
        follow_print(d.prints[i], d.law, d.options.print, tip_W, depth, run.bottom, run.volumes);
    run.deepest_print = std::max(run.deepest_print, depth);
    if (depth > known) ++run.beyond_law;
  }
}

}  // namespace

RollerRun crater_drilling(const RollerBit& bit, const ToothLaw& law, const RollerSchedule& schedule,
                          const CraterDrillingOptions& given) {
  check_crater_drilling(bit, law, schedule, given);
  const CraterDrillingOptions options = with_tooth_radius(bit, given);
  const long steps = steps_of(schedule);
  RollerRun run = empty_run(bit, schedule, options);
  Drilling d = started(bit, law, schedule, options, run.tooth_force.size());
  for (long i = 0; i < steps; ++i) {
    d.turn = static_cast<double>(i + 1) * schedule.step * schedule.bit_speed;
    turn_cones(d);
    place(d, run.bottom);
    const int evaluations = lower_bit(d);
    leave_prints(d, run);
    const RollerLoads loads =
        teeth_loads(bit, d.turn, d.teeth_W, d.forces, d.cone_speeds, options.sliding, d.torques);
    add_step(run, {static_cast<double>(i + 1) * schedule.step, d.z, evaluations}, loads, d.forces,
             d.cone_speeds, schedule);
  }
  take_means(run, schedule);
  return run;
}

}  // namespace tdbd::reference
