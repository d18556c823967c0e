#include "reference/literature/drag/spokes/hanson_hansen_cones.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/drag/spokes/rk4.hpp"
#include "reference/literature/surface/planar_boolean.hpp"

namespace tdbd::reference {
namespace {

PlacedTooth tooth_at(const SphereTooth& tooth, const HansonHansenState& y) {
  const std::size_t k = bit_unknowns + 2 * tooth.cone;
  return placed_tooth(tooth, place_in_rock(y), y[k], Vec3(y[3], y[4], y[5] - y[9]), y[7], y[k + 1]);
}

/// The rock's depth at a place, interpolated linearly in the angle between two spokes.
double rock_depth(const HansonHansenCones& m, const Vec3& x_W) {
  const int n = m.bottom.spokes();
  const double around = std::atan2(x_W.y(), x_W.x()) / (2.0 * std::numbers::pi) * n,
               before = std::floor(around), r = std::hypot(x_W.x(), x_W.y());
  const double a = surface_depth(m.bottom, spoke_number(before, n), r),
               b = surface_depth(m.bottom, spoke_number(before + 1.0, n), r);
  return std::lerp(a, b, around - before);
}

/// Whether a tooth may touch rock: it is below its cone.
bool is_below(const SphereTooth& tooth, const HansonHansenState& y) {
  return downwards(tooth, y[bit_unknowns + 2 * tooth.cone]) > 0.3;
}

/// Penetration of the sphere into the rock at first contact, which is assumed to be horizontal.
double tooth_depth(const HansonHansenCones& m, std::size_t i, const PlacedTooth& t) {
  const double level = std::isnan(m.met[i]) ? rock_depth(m, t.centre_W) : m.met[i];
  return std::max(0.0, t.centre_W.z() + m.teeth[i].size - level);
}

/// Cuts the sphere's discs out of all spokes that it reaches. Returns the volume, m3.
double cut_sphere(HansonHansenCones& m, const PlacedTooth& t, double size) {
  double removed = 0.0;
  for (int k = 0; k < m.bottom.spokes(); ++k) {
    const SpokePlane& plane = m.planes[at(k)];
    const RimEllipse disc = sphere_section(t.centre_W, size, plane);
    if (disc.half_width < 1e-6 || disc.x0 < -disc.half_width) continue;
    const CrossingCut cut = cut_outline(m.bottom, k, disc);
    removed += cut.moment * 2.0 * std::numbers::pi / m.bottom.spokes();
  }
  return removed;
}

void let_go(HansonHansenCones& m, std::size_t i) {
  m.met[i] = NAN;
  m.deepest[i] = 0.0;
  m.cut_at_W[i].setConstant(INFINITY);
}

/// Updates, after a step, which teeth are in contact, their largest penetrations, and the craters.
void update_contacts(HansonHansenCones& m) {
  for (std::size_t i = 0; i < m.teeth.size(); ++i) {
    if (!is_below(m.teeth[i], m.state)) {
      let_go(m, i);
      continue;
    }
    const PlacedTooth t = tooth_at(m.teeth[i], m.state);
    const double depth = tooth_depth(m, i, t);
    if (depth <= 0.0) {
      let_go(m, i);
      continue;
    }
    if (std::isnan(m.met[i])) m.met[i] = rock_depth(m, t.centre_W);
    m.deepest[i] = std::max(m.deepest[i], depth);
    if ((t.centre_W - m.cut_at_W[i]).norm() < m.cut_after) continue;
    const double cut = cut_sphere(m, t, m.teeth[i].size);
    m.tooth_removed[i] += cut;
    m.removed += cut;
    m.cut_at_W[i] = t.centre_W;
  }
}

/// Largest radius and depth that teeth reach as their cones turn.
struct ToothReach {
  double radius = 0.0, z = -INFINITY;
};

ToothReach tooth_reach(const std::vector<SphereTooth>& teeth) {
  constexpr int angles = 720;
  ToothReach reach;
  for (const SphereTooth& tooth : teeth)
    for (int i = 0; i < angles; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / angles - tooth.angle;
      const PlacedTooth t = placed_tooth(tooth, {}, turn, Vec3::Zero(), 0.0, 0.0);
      reach.radius = std::max(reach.radius, std::hypot(t.tip_W.x(), t.tip_W.y()) + tooth.size);
      reach.z = std::max(reach.z, t.centre_W.z() + tooth.size);
    }
  return reach;
}

}  // namespace

double surface_depth(const OutlineSpokes& rock, int spoke, double r) {
  const Outline& border = rock.rock[at(spoke)].border;
  double z = -INFINITY;
  for (std::size_t i = 0, n = border.size(); i < n; ++i) {
    const Vec2 &a = border[i], &b = border[i + 1 < n ? i + 1 : 0];
    if ((a.x() > r) == (b.x() > r) || (a.y() == rock.frame.floor && b.y() == rock.frame.floor))
      continue;
    z = std::max(z, std::lerp(a.y(), b.y(), (r - a.x()) / (b.x() - a.x())));
  }
  return z;
}

HansonHansenLoad cones_load(const HansonHansenCones& m, const HansonHansenState& y,
                            std::vector<Vec3>* force_W) {
  HansonHansenLoad load;
  for (std::size_t i = 0; i < m.teeth.size(); ++i) {
    if (force_W) (*force_W)[i].setZero();
    if (!is_below(m.teeth[i], y)) continue;
    const PlacedTooth t = tooth_at(m.teeth[i], y);
    const Vec3 F_W = tooth_force(m.rock, m.teeth[i].size, tooth_depth(m, i, t), m.deepest[i], t);
    const Vec3 arm_W = t.tip_W - place_in_rock(y).p_WB;
    load.force_W += F_W;
    load.torque += arm_W.x() * F_W.y() - arm_W.y() * F_W.x();
    load.cones[m.teeth[i].cone] += t.journal_W.dot(t.arm_W.cross(F_W));
    if (force_W) (*force_W)[i] = F_W;
  }
  return load;
}

HansonHansenCones hanson_hansen_cones(const RollerBit& bit, const ConesSetup& setup) {
  HansonHansenCones m;
  m.system = setup.system;
  m.rock = setup.rock;
  m.bit = bit;
  m.lateral_locked = setup.lateral_locked;
  m.step = setup.step;
  m.teeth = sphere_teeth(bit);
  const ToothReach reach = tooth_reach(m.teeth);
  m.bottom = flat_outline_spokes({reach.radius + 0.02, reach.z + setup.depth + 0.03}, reach.z,
                                 setup.layout.spokes, setup.layout.spacing);
  m.start_depth = reach.z;
  m.planes = round_wall(setup.layout.spokes, 0.0).planes;
  m.state[5] = setup.system.rate;
  m.state[7] = setup.system.speed;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    m.state[bit_unknowns + 2 * k + 1] = -setup.cone_ratio * setup.system.speed;
  m.met.assign(m.teeth.size(), NAN);
  m.deepest.assign(m.teeth.size(), 0.0);
  m.cut_at_W.assign(m.teeth.size(), Vec3::Constant(INFINITY));
  m.tooth_removed.assign(m.teeth.size(), 0.0);
  m.tooth_force_W.resize(m.teeth.size());
  return m;
}

void advance(HansonHansenCones& m) {
  m.load = cones_load(m, m.state, &m.tooth_force_W);
  bool is_first = true;
  rk4_step(
      [&](double t, const HansonHansenState& y, HansonHansenState& rates) {
        rates = {};
        const HansonHansenLoad load = is_first ? m.load : cones_load(m, y);
        string_and_rock_rates(m.system, t, y, load, rates);
        if (m.lateral_locked) rates[3] = rates[4] = 0.0;
        for (std::size_t k = 0; k < m.bit.cones.size(); ++k) {
          rates[bit_unknowns + 2 * k] = y[bit_unknowns + 2 * k + 1];
          rates[bit_unknowns + 2 * k + 1] = load.cones[k] / m.bit.cones[k].inertia;
        }
        is_first = false;
      },
      m.time, m.step, m.state);
  m.time += m.step;
  update_contacts(m);
}

int teeth_in_contact(const HansonHansenCones& m) {
  return static_cast<int>(
      std::ranges::count_if(m.met, [](double level) { return !std::isnan(level); }));
}

double neglected_acceleration(const RollerCone& cone, double bit_acceleration) {
  return bit_acceleration * journal_axes(cone).s.z();
}

}  // namespace tdbd::reference
