#include "reference/literature/drag/planes/behr.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/literature/drag/planes/behr_crossings.hpp"

namespace tdbd::reference {
namespace {

/// Largest rotation of a straight segment, rad; the path of a tip is then its chord, to 1e-5 of its
/// radius.
constexpr double widest_turn = std::numbers::pi / 180;

/// The data of the current step.
struct BehrStepContext {
  BehrState& state;
  double dt;  ///< s, of the whole step
  const DragRock& rock;
  const BehrOptions& options;
  BehrLoad& load;
};

CutterForce force_of(const BehrStepContext& s, std::size_t cutter, const BehrCut& cut) {
  if (cut.area == 0.0) return {};
  if (cut.is_backward) return flat_force(s.rock, cut.area);
  const BehrOptions& o = s.options;
  const double ratio = o.normal_ratio.empty() ? s.rock.normal_ratio : o.normal_ratio[cutter];
  const CutterForce sharp = sharp_force(s.rock, ratio, cut.effective);
  if (o.flat_area.empty()) return sharp;
  const CutterForce flat = flat_force(s.rock, o.flat_area[cutter]);
  return {sharp.cutting + flat.cutting, sharp.normal + flat.normal};
}

/// Sets the force of a cut, and the time for which it counts: until the tip is at the next plane.
void load_cut(const BehrStepContext& s, const BehrSegment& way, const BehrCrossing& crossing,
              BehrCut& cut) {
  const CutterRim& rim = s.state.rims[crossing.cutter];
  const SpokePlane& plane = s.state.planes[at(crossing.plane)];
  const BitPlace place = way.at(crossing.when);
  const Vec3 v_W = tip_velocity(way, place, rim), tip_W = place.p_WB + turned(place, rim.tip_B);
  const Vec3 point_W = cut.arm * Vec3(plane.cosine, plane.sine, 0.0);
  cut.force = force_of(s, crossing.cutter, cut);
  Vec3 F_W = -cut.force.normal * turned(place, rim.normal_B);
  if (v_W.norm() > 0.0) F_W -= cut.force.cutting / v_W.norm() * v_W;
  cut.force_B = turned({Vec3::Zero(), -place.angle}, F_W);
  cut.torque = -(point_W - place.p_WB).cross(F_W).z();
  const double about = std::abs(plane.cosine * v_W.y() - plane.sine * v_W.x());
  const double arc = tip_W.head<2>().norm() * 2 * std::numbers::pi / s.state.bottom.spokes;
  cut.left = about > 0.0 ? arc / about : 0.0;
}

/// Adds the force of a cutter's cut for this time, s.
void add_for(const BehrStepContext& s, const BitPlace& place, std::size_t cutter,
             const BehrCut& cut, double time) {
  if (!(time > 0.0) || cut.area == 0.0) return;
  const double share = time / s.dt;
  const Vec3 F_W = share * turned(place, cut.force_B);
  BehrCutter& own = s.load.cutters[cutter];
  own.force_W += F_W;
  own.force.cutting += share * cut.force.cutting;
  own.force.normal += share * cut.force.normal;
  s.load.weight -= F_W.z();
  s.load.lateral_W += F_W.head<2>();
  s.load.torque += share * cut.torque;
}

/// Counts a cutter's force up to a time of the segment.
void count_until(const BehrStepContext& s, const BehrSegment& way, std::size_t cutter,
                 double time) {
  const double span = time - s.state.since[cutter];
  BehrCut& cut = s.state.last[cutter];
  s.state.since[cutter] = time;
  add_for(s, way.to, cutter, cut, std::min(span, cut.left));
  cut.left = std::max(0.0, cut.left - span);
}

/// Replaces the cutter's last cut by a new one. A cutter that reversed its direction crosses its
/// plane again too early. What is left then counts at once, so that no impulse is lost.
void take(const BehrStepContext& s, const BehrSegment& way, const BehrCrossing& crossing,
          BehrCut cut) {
  BehrCut& last = s.state.last[crossing.cutter];
  count_until(s, way, crossing.cutter, crossing.when * way.dt);
  if (s.options.force_time == ForceTime::spread)
    add_for(s, way.to, crossing.cutter, last, last.left);
  load_cut(s, way, crossing, cut);
  if (s.options.force_time == ForceTime::crossing) {
    add_for(s, way.at(crossing.when), crossing.cutter, cut, cut.left);
    cut.left = 0.0;
  }
  if (s.options.force_time == ForceTime::held) cut.left = std::numeric_limits<double>::infinity();
  last = cut;
}

void cut_on(const BehrStepContext& s, const BehrSegment& way) {
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
    take(s, way, crossing, cut);
  }
  for (std::size_t i = 0; i < s.state.since.size(); ++i) {
    count_until(s, way, i, way.dt);
    s.state.since[i] = 0.0;
  }
}

/// Cuts on the straight segment, in parts of at most a degree.
void cut_straight(const BehrStepContext& s, const BehrSegment& way) {
  const double turn = std::abs(way.to.angle - way.from.angle);
  const int parts = std::max(1, static_cast<int>(std::ceil(turn / widest_turn)));
  BehrSegment part{way.from, way.from, way.dt / parts};
  for (int k = 1; k <= parts; ++k) {
    part.from = part.to;
    part.to = k < parts ? way.at(static_cast<double>(k) / parts) : way.to;
    cut_on(s, part);
  }
}

/// Whether straight segments through the middle are close to a path of uniform curvature.
bool is_straight(const BehrSegment& way, const BitPlace& middle, double nearness) {
  const Vec3 chord = 0.5 * (way.from.p_WB + way.to.p_WB);
  return std::abs(way.to.angle - way.from.angle) <= widest_turn &&
         (middle.p_WB - chord).norm() <= 4.0 * nearness;
}

/// Cuts along the path from a time on, halving segments until they are straight.
void cut_along(const BehrStepContext& s, const BitPath& path, double from, const BehrSegment& way) {
  const double half = 0.5 * way.dt;
  const BitPlace middle = path(from + half);
  const BehrSegment first{way.from, middle, half}, second{middle, way.to, half};
  constexpr double shortest = 1e-6;  // of a step; limits the recursion on a jump
  if (is_straight(way, middle, s.options.nearness) || half < shortest * s.dt) {
    cut_straight(s, first);
    cut_straight(s, second);
  } else {
    cut_along(s, path, from, first);
    cut_along(s, path, from + half, second);
  }
}

void begin(BehrLoad& load, std::size_t cutters) {
  load.weight = load.torque = load.volume = 0.0;
  load.lateral_W.setZero();
  load.cutters.assign(cutters, {});
}

void finish(const BehrStepContext& s, const BitPlace& place) {
  s.state.place = place;
  for (const BehrCutter& c : s.load.cutters) s.load.volume += c.volume;
}

}  // namespace

void behr_step(BehrState& state, const BitPlace& to, double dt, const DragRock& rock,
               const BehrOptions& options, BehrLoad& load) {
  begin(load, state.rims.size());
  const BehrStepContext s{state, dt, rock, options, load};
  cut_straight(s, {state.place, to, dt});
  finish(s, to);
}

void behr_step(BehrState& state, const BitPath& path, double from, double dt, const DragRock& rock,
               const BehrOptions& options, BehrLoad& load) {
  begin(load, state.rims.size());
  const BehrStepContext s{state, dt, rock, options, load};
  const BitPlace to = path(from + dt);
  cut_along(s, path, from, {state.place, to, dt});
  finish(s, to);
}

}  // namespace tdbd::reference
