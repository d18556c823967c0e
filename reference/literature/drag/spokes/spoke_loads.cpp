#include "reference/literature/drag/spokes/spoke_loads.hpp"

#include <algorithm>

namespace tdbd::reference {
namespace {

void add(NeededLoad& sum, const SpokeLoad& load, double share) {
  sum.wob -= share * load.force_B.z();
  sum.tob -= share * load.torque;
}

/// Counts a cutter's load for this time, s.
void count_for(SpokeLoads& s, std::size_t cutter, double time) {
  const double share = time / s.step;
  s.force_B[cutter] += share * s.last[cutter].force_B;
  add(s.spread, s.last[cutter], share);
}

/// Counts a cutter's load up to a time of the step, or to the end of its duration.
void count_until(SpokeLoads& s, std::size_t cutter, double when) {
  SpokeLoad& last = s.last[cutter];
  const double counted = std::clamp(when - s.since[cutter], 0.0, last.time);
  count_for(s, cutter, counted);
  last.time -= counted;
  s.since[cutter] = when;
}

}  // namespace

SpokeLoads spoke_loads(std::size_t cutters, double step) {
  SpokeLoads loads;
  loads.step = step;
  loads.last.resize(cutters);
  loads.since.resize(cutters);
  loads.force_B.resize(cutters);
  return loads;
}

void begin_step(SpokeLoads& loads) {
  std::ranges::fill(loads.since, 0.0);
  std::ranges::fill(loads.force_B, Vec3::Zero());
  loads.spread = loads.by_step = {};
}

void cross(SpokeLoads& loads, std::size_t cutter, double when, const SpokeLoad& load) {
  count_until(loads, cutter, when);
  count_for(loads, cutter, loads.last[cutter].time);
  loads.last[cutter] = load;
  add(loads.by_step, load, load.time / loads.step);
}

void end_step(SpokeLoads& loads) {
  for (std::size_t i = 0; i < loads.last.size(); ++i) count_until(loads, i, loads.step);
}

NeededLoad last_loads(const SpokeLoads& loads) {
  NeededLoad held;
  for (const SpokeLoad& load : loads.last) add(held, load, 1.0);
  return held;
}

double lateral_size(const SpokeLoads& loads) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& force : loads.force_B) sum += force;
  return sum.head<2>().norm();
}

}  // namespace tdbd::reference
