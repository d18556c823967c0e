#include "reference/literature/roller/craters/crater_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

/// Distance of the map's edge from the lowest point of the outermost tooth, m.
constexpr double map_margin = 15e-3;

std::size_t teeth_of(const RollerBit& bit) {
  std::size_t n = 0;
  for (const RollerCone& cone : bit.cones)
    for (const RollerRow& row : cone.rows) n += row.angles.size();
  return n;
}

/// Radius and depth, m, of a row's lowest tooth with the bit at depth 0, and radius of the tooth's
/// sphere.
struct RowBottom {
  double radius = 0.0, depth = 0.0, sphere = 0.0;
};

std::vector<RowBottom> row_bottoms(const RollerBit& bit, double sphere) {
  std::vector<RowBottom> rows;
  for (const RollerCone& c : bit.cones)
    for (const RollerRow& r : c.rows) {
      const double cosine = std::cos(c.journal_angle), sine = std::sin(c.journal_angle);
      rows.push_back({std::hypot(r.along * cosine + r.radius * sine, c.offset),
                      c.elevation - r.along * sine + r.radius * cosine, sphere});
    }
  std::ranges::sort(rows, {}, &RowBottom::radius);
  return rows;
}

double groove_depth(const std::vector<RowBottom>& rows, double radius) {
  double depth = rows.front().depth - rows.front().sphere;
  for (const RowBottom& r : rows) depth = std::min(depth, r.depth - r.sphere);
  for (const RowBottom& r : rows) {
    const double square = r.sphere * r.sphere - (radius - r.radius) * (radius - r.radius);
    if (square > 0.0) depth = std::max(depth, r.depth - r.sphere + std::sqrt(square));
  }
  return depth;
}

void groove(ZMap& bottom, const std::vector<RowBottom>& rows) {
  for (int j = 0; j < bottom.cells; ++j)
    for (int i = 0; i < bottom.cells; ++i)
      bottom.height[at(j) * at(bottom.cells) + at(i)] =
          groove_depth(rows, std::hypot(bottom.centre(i), bottom.centre(j)));
}

void need(bool holds, const CraterDrillingOptions& options, const std::string& what, double found) {
  if (!holds)
    throw InputError(
        fmt::format("{}: {}: found {}, expected a positive number", options.model, what, found));
}

struct Moments {
  double mean = 0.0, variance = 0.0;
};

template <typename Value>
Moments moments_of(const std::vector<Value>& values, std::size_t first) {
  Moments m;
  const double n = static_cast<double>(values.size() - first);
  for (std::size_t i = first; i < values.size(); ++i) m.mean += values[i] / n;
  for (std::size_t i = first; i < values.size(); ++i)
    m.variance += (values[i] - m.mean) * (values[i] - m.mean) / n;
  return m;
}

std::size_t settled(const RollerSchedule& s) {
  const double steps = full_turn * s.settle / (s.bit_speed * s.step);
  return static_cast<std::size_t>(std::min(std::lround(steps), std::max(steps_of(s) - 1, 0L)));
}

}  // namespace

void check_crater_drilling(const RollerBit& bit, const ToothLaw& law,
                           const RollerSchedule& schedule, const CraterDrillingOptions& options) {
  bool rows = !bit.cones.empty();
  for (const RollerCone& cone : bit.cones) rows = rows && !cone.rows.empty();
  if (!rows || teeth_of(bit) == 0)
    throw InputError(
        fmt::format("{}: found {} cones with {} teeth, expected a roller bit: cones with "
                    "rows of teeth",
                    options.model, bit.cones.size(), teeth_of(bit)));
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    need(bit.cones[k].inertia > 0.0, options, fmt::format("inertia of cone {} (kg m2)", k + 1),
         bit.cones[k].inertia);
  need(schedule.bit_speed > 0.0, options, "bit speed (rad/s)", schedule.bit_speed);
  need(schedule.weight > 0.0, options, "weight on bit (N)", schedule.weight);
  need(schedule.step > 0.0, options, "step (s)", schedule.step);
  need(schedule.revolutions > schedule.settle, options, "revolutions after those to settle",
       schedule.revolutions - schedule.settle);
  need(options.cell > 0.0, options, "cell of the bottom (m)", options.cell);
  if (options.axial == AxialMotion::mass)
    need(options.mass > 0.0, options, "mass (kg)", options.mass);
  check_tooth_law(law, options.model);
}

CraterDrillingOptions with_tooth_radius(const RollerBit& bit, CraterDrillingOptions options) {
  double& radius = options.print.sphere_radius;
  if (radius > 0.0) return options;
  radius = bit.cones[0].rows[0].tooth_radius;
  for (const RollerCone& cone : bit.cones)
    for (const RollerRow& row : cone.rows)
      if (row.tooth_radius != radius)
        throw InputError(
            fmt::format("{}: found teeth of {:g} and {:g} mm radius, expected one kind, that "
                        "of its law, or a sphere radius for all",
                        options.model, 1e3 * radius, 1e3 * row.tooth_radius));
  need(radius > 0.0, options, "radius of the teeth (m)", radius);
  return options;
}

long steps_of(const RollerSchedule& s) {
  return std::lround(full_turn * s.revolutions / (s.bit_speed * s.step));
}

RollerRun empty_run(const RollerBit& bit, const RollerSchedule& schedule,
                    const CraterDrillingOptions& options) {
  RollerRun run;
  const std::size_t teeth = teeth_of(bit), steps = static_cast<std::size_t>(steps_of(schedule));
  for (std::vector<double>* values : {&run.tooth_force, &run.tooth_largest, &run.tooth_contacts})
    values->assign(teeth, 0.0);
  run.tooth_volume.assign(teeth, 0.0);
  run.cone_ratio.assign(bit.cones.size(), 0.0);
  RollerSeries& s = run.series;
  for (std::vector<double>* values :
       {&s.time, &s.depth, &s.weight, &s.torque, &s.side_x, &s.side_y})
    values->reserve(steps);
  s.contacts.reserve(steps);
  s.evaluations.reserve(steps);
  s.cone_speeds.reserve(steps * bit.cones.size());
  s.forces_in_contact.reserve(steps * teeth);
  const std::vector<RowBottom> rows = row_bottoms(bit, options.print.sphere_radius);
  const double half = rows.back().radius + map_margin;
  const int cells = static_cast<int>(std::ceil(2.0 * half / options.cell));
  run.bottom = flat_z_map(0.5 * cells * options.cell, 0.0, cells);
  if (options.start == BottomStart::grooves) groove(run.bottom, rows);
  return run;
}

void add_step(RollerRun& run, const StepPlace& place, const RollerLoads& loads,
              const std::vector<double>& forces, const std::vector<double>& cone_speeds,
              const RollerSchedule& schedule) {
  RollerSeries& s = run.series;
  const bool measured = s.time.size() >= settled(schedule);
  int contacts = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (forces[i] <= 0.0) continue;
    ++contacts;
    if (!measured) continue;
    run.tooth_force[i] += forces[i];
    run.tooth_largest[i] = std::max(run.tooth_largest[i], forces[i]);
    run.tooth_contacts[i] += 1.0;
    s.forces_in_contact.push_back(forces[i]);
  }
  s.time.push_back(place.time);
  s.depth.push_back(place.depth);
  s.evaluations.push_back(place.evaluations);
  s.weight.push_back(-loads.force.z());
  s.torque.push_back(loads.torque);
  s.side_x.push_back(loads.force.x());
  s.side_y.push_back(loads.force.y());
  s.contacts.push_back(contacts);
  s.cone_speeds.insert(s.cone_speeds.end(), cone_speeds.begin(), cone_speeds.end());
}

void take_means(RollerRun& run, const RollerSchedule& schedule) {
  const RollerSeries& s = run.series;
  const std::size_t first = settled(schedule), last = s.time.size() - 1;
  const double measured = static_cast<double>(last + 1 - first);
  run.rate = (s.depth[last] - s.depth[first]) / (s.time[last] - s.time[first]);
  const Moments weight = moments_of(s.weight, first), torque = moments_of(s.torque, first),
                contacts = moments_of(s.contacts, first);
  run.weight = weight.mean;
  run.weight_deviation = std::sqrt(weight.variance);
  run.torque = torque.mean;
  run.torque_deviation = std::sqrt(torque.variance);
  run.contacts = contacts.mean;
  run.contacts_variance = contacts.variance;
  for (double& force : run.tooth_force) force /= measured;
  for (double& steps : run.tooth_contacts) steps /= measured;
  const std::size_t cones = run.cone_ratio.size();
  for (std::size_t i = first; i <= last; ++i)
    for (std::size_t k = 0; k < cones; ++k)
      run.cone_ratio[k] += s.cone_speeds[i * cones + k] / schedule.bit_speed / measured;
}

}  // namespace tdbd::reference
