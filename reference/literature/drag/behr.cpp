#include "reference/literature/drag/behr.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/literature/drag/behr_crossings.hpp"

namespace tdbd::reference {
namespace {

/// Of a straight way, rad: a tip's way is then its chord, to 1e-5 of its radius.
constexpr double widest_turn = std::numbers::pi / 180;

/// What a cutter's share of the load needs to know.
struct Contact {
  std::size_t cutter;
  const BehrCut& cut;
  Vec3 v_W, point_W;  ///< m/s; m, where the force acts
  BitPlace place;
  double share;  ///< of the step for which the force counts
};

CutterForce force_of(const Contact& c, const DragRock& rock, const BehrOptions& options) {
  if (c.cut.area == 0.0) return {};
  if (c.cut.is_backward) return flat_force(rock, c.cut.area);
  const double ratio =
      options.normal_ratio.empty() ? rock.normal_ratio : options.normal_ratio[c.cutter];
  const CutterForce sharp = sharp_force(rock, ratio, c.cut.effective);
  if (options.flat_area.empty()) return sharp;
  const CutterForce flat = flat_force(rock, options.flat_area[c.cutter]);
  return {sharp.cutting + flat.cutting, sharp.normal + flat.normal};
}

void add_force(const BehrState& state, const Contact& c, const CutterForce& size, BehrLoad& load) {
  const double v = c.v_W.norm();
  Vec3 F_W = -size.normal * turned(c.place, state.rims[c.cutter].normal_B);
  if (v > 0.0) F_W -= size.cutting / v * c.v_W;
  F_W *= c.share;
  BehrCutter& own = load.cutters[c.cutter];
  own.force_W += F_W;
  own.force.cutting += c.share * size.cutting;
  own.force.normal += c.share * size.normal;
  load.weight -= F_W.z();
  load.lateral_W += F_W.head<2>();
  load.torque -= (c.point_W - c.place.p_WB).cross(F_W).z();
}

/// The part of the step that a crossing stands for: the way to the next plane.
double time_share(const BehrState& state, const Contact& c, const SpokePlane& plane, double dt) {
  const double about = std::abs(plane.cosine * c.v_W.y() - plane.sine * c.v_W.x());
  const Vec3 tip_W = c.place.p_WB + turned(c.place, state.rims[c.cutter].tip_B);
  const double way = tip_W.head<2>().norm() * 2 * std::numbers::pi / state.bottom.spokes;
  return about > 0.0 ? way / (about * dt) : 0.0;
}

/// One step while it is made.
struct StepInHand {
  BehrState& state;
  double dt;  ///< s, of the whole step
  const DragRock& rock;
  const BehrOptions& options;
  BehrLoad& load;
};

void add_crossing_force(const StepInHand& s, const BehrWay& way, const BehrCrossing& crossing,
                        const BehrCut& cut) {
  const SpokePlane& plane = s.state.planes[at(crossing.plane)];
  Contact c{crossing.cutter, cut, Vec3::Zero(), Vec3::Zero(), way.at(crossing.when), 0.0};
  c.v_W = tip_velocity(way, c.place, s.state.rims[crossing.cutter]);
  c.point_W = cut.arm * Vec3(plane.cosine, plane.sine, 0.0);
  c.share = time_share(s.state, c, plane, s.dt);
  add_force(s.state, c, force_of(c, s.rock, s.options), s.load);
}

void cut_on(const StepInHand& s, const BehrWay& way) {
  find_crossings(s.state, way);
  for (const BehrCrossing& crossing : s.state.crossings) {
    BehrCutter& own = s.load.cutters[crossing.cutter];
    double volume = 0.0;
    const BehrCut cut = cut_at(s.state, way, crossing, volume);
    own.area += cut.area;
    own.volume += volume;
    if (cut.is_backward) own.rubbed_volume += volume;
    ++own.crossings;
    own.backward_crossings += crossing.is_backward;
    s.state.last[crossing.cutter] = cut;
    if (s.options.force_time == ForceTime::crossing) add_crossing_force(s, way, crossing, cut);
  }
}

/// Cuts on the straight way, in parts of at most a degree. Returns the last part.
BehrWay cut_straight(const StepInHand& s, const BehrWay& way) {
  const double turn = std::abs(way.to.angle - way.from.angle);
  const int parts = std::max(1, static_cast<int>(std::ceil(turn / widest_turn)));
  BehrWay part{way.from, way.from, way.dt / parts};
  for (int k = 1; k <= parts; ++k) {
    part.from = part.to;
    part.to = k < parts ? way.at(static_cast<double>(k) / parts) : way.to;
    cut_on(s, part);
  }
  return part;
}

/// Whether straight ways over the middle stay near a path that bends evenly.
bool is_straight(const BehrWay& way, const BitPlace& middle, double nearness) {
  const Vec3 chord = 0.5 * (way.from.p_WB + way.to.p_WB);
  return std::abs(way.to.angle - way.from.angle) <= widest_turn &&
         (middle.p_WB - chord).norm() <= 4.0 * nearness;
}

/// Cuts along the path from a time on, halving ways until they are straight. Returns the last part.
BehrWay cut_along(const StepInHand& s, const BitPath& path, double from, const BehrWay& way) {
  const double half = 0.5 * way.dt;
  const BitPlace middle = path(from + half);
  const BehrWay first{way.from, middle, half}, second{middle, way.to, half};
  constexpr double shortest = 1e-6;  // of a step: a path that jumps ends there
  if (is_straight(way, middle, s.options.nearness) || half < shortest * s.dt) {
    cut_straight(s, first);
    return cut_straight(s, second);
  }
  cut_along(s, path, from, first);
  return cut_along(s, path, from + half, second);
}

void add_held(const StepInHand& s, const BehrWay& way) {
  for (std::size_t i = 0; i < s.state.rims.size(); ++i) {
    const CutterRim& rim = s.state.rims[i];
    Vec3 tip_W = way.to.p_WB + turned(way.to, rim.tip_B);
    tip_W.z() = 0.0;
    const Vec3 point_W = s.state.last[i].arm * tip_W.normalized();
    const Contact c{i, s.state.last[i], tip_velocity(way, way.to, rim), point_W, way.to, 1.0};
    add_force(s.state, c, force_of(c, s.rock, s.options), s.load);
  }
}

void begin(BehrLoad& load, std::size_t cutters) {
  load.weight = load.torque = load.volume = 0.0;
  load.lateral_W.setZero();
  load.cutters.assign(cutters, {});
}

void finish(const StepInHand& s, const BehrWay& last) {
  s.state.place = last.to;
  if (s.options.force_time == ForceTime::held) add_held(s, last);
  for (const BehrCutter& c : s.load.cutters) s.load.volume += c.volume;
}

}  // namespace

void behr_step(BehrState& state, const BitPlace& to, double dt, const DragRock& rock,
               const BehrOptions& options, BehrLoad& load) {
  begin(load, state.rims.size());
  const StepInHand s{state, dt, rock, options, load};
  finish(s, cut_straight(s, {state.place, to, dt}));
}

void behr_step(BehrState& state, const BitPath& path, double from, double dt, const DragRock& rock,
               const BehrOptions& options, BehrLoad& load) {
  begin(load, state.rims.size());
  const StepInHand s{state, dt, rock, options, load};
  finish(s, cut_along(s, path, from, {state.place, path(from + dt), dt}));
}

}  // namespace tdbd::reference
