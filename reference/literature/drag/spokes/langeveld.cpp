#include "reference/literature/drag/spokes/langeveld.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/drag/spokes/rk4.hpp"

namespace tdbd::reference {
namespace {

BitPlace langeveld_place(const LangeveldState& y) { return {Vec3(y[0], y[1], y[2]), y[3]}; }

CrossingCut felt(const Langeveld& m, std::size_t i, const PlacedCutter& c, int spoke) {
  if (m.system.law == LangeveldLaw::outline)
    return rim_in_rock(m.rock, spoke, c.rim, m.system.counted);
  const double area = m.system.widths[i] * tip_depth(m.rock, spoke, c.radius, c.tip_W.z());
  return {area, area * c.radius, area};
}

void check_system(const Langeveld& m) {
  const LangeveldSystem& s = m.system;
  if (!(s.mass > 0.0 && s.inertia > 0.0 && s.step > 0.0))
    throw InputError(
        "Langeveld: found a mass, inertia or step that is not above 0; needs all three");
  if (s.law == LangeveldLaw::tip) require_widths(s.widths.size(), m.cutters.size());
}

/// Accelerations by the string's equations under a load.
void string_rates(const LangeveldSystem& s, double t, const LangeveldState& y,
                  const LangeveldLoad& load, LangeveldState& rates) {
  for (std::size_t i = 0; i < 4; ++i) rates[i] = y[i + 4];
  const bool locked = s.lateral == LateralMotion::locked;
  rates[4] = locked ? 0.0 : (load.force_W.x() - s.lateral_stiffness * y[0]) / s.mass;
  rates[5] = locked ? 0.0 : (load.force_W.y() - s.lateral_stiffness * y[1]) / s.mass;
  rates[6] = (load.force_W.z() - s.axial_damping * y[6] -
              s.axial_stiffness * (y[2] - s.top_z - s.rate * t)) /
             s.mass;
  rates[7] = (load.torque - s.twist_stiffness * (y[3] - s.top_angle - s.speed * t)) / s.inertia;
}

}  // namespace

void langeveld_load(const Langeveld& m, const LangeveldState& y, LangeveldLoad& load) {
  const BitPlace place = langeveld_place(y);
  const Vec3 v(y[4], y[5], y[6]);
  load.force_W = wall_force(m.rock.wall, m.system.wall, m.gage, place.p_WB, v);
  load.torque = 0.0;
  load.cutter_force_W.resize(m.cutters.size());
  load.cutter_area.resize(m.cutters.size());
  for (std::size_t i = 0; i < m.cutters.size(); ++i) {
    const PlacedCutter c = placed(m.cutters[i], place);
    const Vec3 arm = c.tip_W - place.p_WB, v_W = v + y[7] * Vec3(-arm.y(), arm.x(), 0.0);
    const CrossingCut cut = felt(m, i, c, spoke_ahead(c, v_W, m.rock.bottom.spokes));
    const Vec3 force_W =
        area_force(m.system.rock, cut.area, turned(place, m.cutters[i].normal_B), v_W);
    const double r = cut.area > 0.0 ? cut.moment / cut.area : c.radius;
    load.force_W += force_W;
    load.torque += (c.cosine * r - y[0]) * force_W.y() - (c.sine * r - y[1]) * force_W.x();
    load.cutter_force_W[i] = force_W;
    load.cutter_area[i] = cut.area;
  }
}

Langeveld langeveld(const std::vector<bit::Cutter>& cutters, const LangeveldSystem& system,
                    LangeveldRock rock, const LangeveldState& start) {
  Langeveld m;
  m.system = system;
  m.cutters = spoke_cutters(cutters, "Langeveld");
  check_system(m);
  m.gage = widest_reach(m.cutters);
  m.rock = std::move(rock);
  m.state = start;
  m.tracker = spoke_tracker(m.cutters, langeveld_place(start), m.rock.bottom.spokes);
  return m;
}

void advance(Langeveld& m) {
  const BitPlace from = langeveld_place(m.state);
  langeveld_load(m, m.state, m.load);
  bool is_first = true;
  rk4_step(
      [&](double t, const LangeveldState& y, LangeveldState& rates) {
        if (!is_first) langeveld_load(m, y, m.stage);
        string_rates(m.system, t, y, is_first ? m.load : m.stage, rates);
        is_first = false;
      },
      m.time, m.system.step, m.state);
  m.time += m.system.step;
  const BitPlace to = langeveld_place(m.state);
  track(m.tracker, m.cutters, to);
  for (const SpokeCrossing& x : m.tracker.crossings)
    cut_rock(m.rock, x.spoke, placed(m.cutters[x.cutter], between(from, to, x.share)).rim);
}

}  // namespace tdbd::reference
