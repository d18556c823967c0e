#include "reference/literature/drag/spokes/hanson_hansen_pdc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/drag/spokes/rim_polygon.hpp"
#include "reference/literature/drag/spokes/rk4.hpp"

namespace tdbd::reference {
namespace {

/// A load on one cutter.
struct RimLoad {
  Vec3 force_W = Vec3::Zero();
  double torque = 0.0, area = 0.0;
};

RimLoad rim_load(const HansonHansenPdc& m, const SpokeCutter& cutter, const BitPlace& place,
                 const Vec3& v, double turn_rate) {
  const PlacedCutter c = placed(cutter, place);
  const Vec3 arm = c.tip_W - place.p_WB, v_W = v + turn_rate * Vec3(-arm.y(), arm.x(), 0.0);
  const int spoke = spoke_ahead(c, v_W, m.bottom.spokes());
  const CrossingCut cut = rim_in_face(rim_polygon(c.rim), m.bottom.rock[at(spoke)]);
  if (cut.area <= 0.0) return {};
  const Vec3 force_W = hanson_hansen_force(m.rock, cutter, cut, turned(place, cutter.normal_B),
                                           turned(place, cutter.face_B), v_W);
  const double r = cut.moment / cut.area, x = c.cosine * r - place.p_WB.x(),
               y = c.sine * r - place.p_WB.y();
  return {force_W, x * force_W.y() - y * force_W.x(), cut.area};
}

void check_setup(const HansonHansenSetup& s) {
  if (!(s.system.mass > 0.0 && s.system.inertia > 0.0 && s.step > 0.0))
    throw InputError(
        "Hanson and Hansen: found a mass, inertia or step that is not above 0; needs all three");
}

/// Cuts the spokes that the step's motion crossed.
void cut_crossings(HansonHansenPdc& m, const BitPlace& from, const BitPlace& to) {
  track(m.tracker, m.cutters, to);
  for (const SpokeCrossing& x : m.tracker.crossings) {
    const RimEllipse rim = placed(m.cutters[x.cutter], between(from, to, x.share)).rim;
    cut_outline(m.bottom, x.spoke, rim);
    double& wall = m.wall.radius[at(x.spoke)];
    wall = std::max(wall, rim.reach());
  }
}

/// Prescribed uniform drilling for some revolutions.
void lead(HansonHansenPdc& m, const HansonHansenSetup& setup) {
  const DrillStringAndRock& s = setup.system;
  m.state[5] = s.rate;
  m.state[7] = s.speed;
  if (setup.led <= 0.0) return;
  PathOptions options;
  options.duration = setup.led * 2.0 * std::numbers::pi / s.speed;
  options.step = setup.step;
  const double advance = s.rate * 2.0 * std::numbers::pi / s.speed;
  hanson_hansen_path(m.cutters, m.rock, m.bottom, steady_path(s.speed, advance), options);
  m.state[2] = s.rate * options.duration;
  m.state[6] = s.speed * options.duration;
}

/// Sets the top of the string so that springs and dampers initially carry the given loads.
void load_string(HansonHansenPdc& m, const HansonHansenSetup& setup) {
  DrillStringAndRock& s = m.system;
  const double kz = s.stiffness(2, 2), kr = s.turn_stiffness;
  s.top_z = m.state[2];
  s.top_angle = m.state[6];
  if (setup.weight != 0.0) s.top_z += (setup.weight + s.damping(2, 2) * s.rate) / kz;
  if (setup.torque != 0.0) s.top_angle += (setup.torque + s.turn_damping * s.speed) / kr;
}

}  // namespace

HansonHansenLoad pdc_load(const HansonHansenPdc& m, const HansonHansenState& y,
                          std::vector<Vec3>* force_W, std::vector<double>* area) {
  const BitPlace place = place_in_rock(y);
  const Vec3 v(y[3], y[4], y[5] - y[9]);
  HansonHansenLoad load;
  load.force_W = wall_force(m.wall, m.spring, m.gage, place.p_WB, v);
  for (std::size_t i = 0; i < m.cutters.size(); ++i) {
    const RimLoad rim = rim_load(m, m.cutters[i], place, v, y[7]);
    load.force_W += rim.force_W;
    load.torque += rim.torque;
    if (force_W) (*force_W)[i] = rim.force_W;
    if (area) (*area)[i] = rim.area;
  }
  return load;
}

HansonHansenPdc hanson_hansen_pdc(const std::vector<bit::Cutter>& cutters,
                                  const HansonHansenSetup& setup) {
  check_setup(setup);
  HansonHansenPdc m;
  m.system = setup.system;
  m.rock = setup.rock;
  m.spring = setup.spring;
  m.lateral_locked = setup.lateral_locked;
  m.step = setup.step;
  m.cutters = spoke_cutters(cutters, "Hanson and Hansen");
  m.gage = widest_reach(m.cutters);
  m.bottom = fitting_outline_rock(m.cutters, setup.depth, setup.layout);
  m.wall = round_wall(setup.layout.spokes, m.gage);
  lead(m, setup);
  load_string(m, setup);
  m.tracker = spoke_tracker(m.cutters, place_in_rock(m.state), setup.layout.spokes);
  m.cutter_force_W.resize(m.cutters.size());
  m.cutter_area.resize(m.cutters.size());
  return m;
}

void advance(HansonHansenPdc& m) {
  const BitPlace from = place_in_rock(m.state);
  m.load = pdc_load(m, m.state, &m.cutter_force_W, &m.cutter_area);
  bool is_first = true;
  rk4_step(
      [&](double t, const HansonHansenState& y, HansonHansenState& rates) {
        rates = {};
        string_and_rock_rates(m.system, t, y, is_first ? m.load : pdc_load(m, y), rates);
        if (m.lateral_locked) rates[3] = rates[4] = 0.0;
        is_first = false;
      },
      m.time, m.step, m.state);
  m.time += m.step;
  cut_crossings(m, from, place_in_rock(m.state));
}

}  // namespace tdbd::reference
