#include "reference/literature/drag/spokes/spoke_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/drag/spokes/spoke_crossings.hpp"
#include "reference/literature/drag/spokes/spoke_loads.hpp"

namespace tdbd::reference {
namespace {

struct PathTally {
  std::vector<double> moment;  ///< m3, of each cutter, sum over counted crossings
  std::vector<long> crossings;
  double turn = 0.0;  ///< rad, in the counted steps
  long backwards = 0;
};

Vec3 back_turned(const Vec3& v_W, const BitPlace& place) {
  return turned({Vec3::Zero(), -place.angle}, v_W);
}

/// Centroid of a crossing's area, m from the hole's axis.
double middle(const CrossingCut& cut, const PlacedCutter& c) {
  return cut.area > 0.0 ? cut.moment / cut.area : c.radius;
}

/// A load in the bit's frame for this time (s), which acts at this radius, on the spoke of the tip.
SpokeLoad load_of(double r, const PlacedCutter& c, const BitPlace& place, const Vec3& force_W,
                  double time) {
  const double x = c.cosine * r - place.p_WB.x(), y = c.sine * r - place.p_WB.y();
  return {back_turned(force_W, place), x * force_W.y() - y * force_W.x(), time};
}

PathRun empty_run(std::size_t cutters, long steps) {
  PathRun run;
  run.area.assign(cutters, 0.0);
  run.volume.assign(cutters, 0.0);
  run.force_B.assign(cutters, Vec3::Zero());
  run.steps = steps;
  for (auto* series : {&run.wob_spread, &run.tob_spread, &run.wob_held, &run.tob_held,
                       &run.wob_by_step, &run.tob_by_step})
    series->assign(static_cast<std::size_t>(steps), 0.0);
  return run;
}

/// Converts sums to means.
void average(PathRun& run, const PathTally& tally, long counted, int spokes) {
  const double turns = tally.turn / (2.0 * std::numbers::pi), sector = 1.0 / spokes;
  for (std::size_t i = 0; i < run.area.size(); ++i) {
    run.area[i] /= static_cast<double>(std::max(1L, tally.crossings[i]));
    run.volume[i] = 2.0 * std::numbers::pi * tally.moment[i] * sector / turns;
    run.force_B[i] /= static_cast<double>(counted);
    run.lateral_B += run.force_B[i];
  }
  run.wob = -run.lateral_B.z();
  run.lateral_B.z() = 0.0;
  run.tob /= static_cast<double>(counted);
  run.side /= static_cast<double>(counted);
  run.lowered /= turns;
  run.backwards =
      static_cast<double>(tally.backwards) / static_cast<double>(std::max(1L, run.crossings));
}

PathTally empty_tally(std::size_t cutters) {
  return {std::vector<double>(cutters), std::vector<long>(cutters)};
}

/// A bit on its path: the ends of the current step, and the results so far.
struct PathFollower {
  const PathModel& model;
  const std::vector<SpokeCutter>& cutters;
  PathRun run;
  SpokeTracker tracker;
  SpokeLoads loads;
  PathTally tally;
  BitPlace from = {}, to = {};
  bool counts = false;
};

/// Velocity of a point of the bit.
Vec3 velocity_W(const PathFollower& f, const Vec3& arm_W) {
  const double turn = f.to.angle - f.from.angle;
  return (f.to.p_WB - f.from.p_WB + turn * Vec3(-arm_W.y(), arm_W.x(), 0.0)) / f.loads.step;
}

void count(PathFollower& f, const SpokeCrossing& x, const CrossingCut& cut, double radius) {
  f.run.area[x.cutter] += cut.area;
  f.tally.moment[x.cutter] += cut.moment;
  ++f.tally.crossings[x.cutter];
  ++f.run.crossings;
  if (!x.forward) ++f.tally.backwards;
  f.run.lowered += cut.lowered * radius * 2.0 * std::numbers::pi / f.model.spokes;
}

/// The passage of a tip through a spoke.
struct Passage {
  double across =
      0.0;  ///< fraction of its speed about the hole's axis, and so of the area in the spoke that
            ///< is normal to its motion
  double time = 0.0;  ///< s, to the next spoke
};

Passage passage(const PlacedCutter& c, const Vec3& v_W, int spokes) {
  const double about = std::abs(c.cosine * v_W.y() - c.sine * v_W.x());
  if (about == 0.0) return {};
  const double way = c.radius * 2.0 * std::numbers::pi / spokes;
  return {about / std::hypot(v_W.x(), v_W.y()), way / about};
}

/// Handles the crossing of a spoke by a cutter.
void pass(PathFollower& f, const SpokeCrossing& x) {
  const BitPlace place = between(f.from, f.to, x.share);
  const SpokeCutter& cutter = f.cutters[x.cutter];
  const PlacedCutter c = placed(cutter, place);
  const CrossingCut cut = f.model.cut(x.cutter, x.spoke, c);
  const Vec3 v_W = velocity_W(f, c.tip_W - place.p_WB);
  const Passage way = passage(c, v_W, f.model.spokes);
  const Vec3 force_W = way.across * f.model.force(x.cutter, cut, turned(place, cutter.normal_B),
                                                  turned(place, cutter.face_B), v_W);
  const double r = f.model.acts == ForceAt::tip ? c.radius : middle(cut, c);
  cross(f.loads, x.cutter, x.share * f.loads.step, load_of(r, c, place, force_W, way.time));
  if (f.counts) count(f, x, cut, middle(cut, c));
}

void write(const NeededLoad& load, std::size_t step, std::vector<double>& wob,
           std::vector<double>& tob) {
  wob[step] = load.wob;
  tob[step] = load.tob;
}

/// Stores the results of a step.
void tell(PathFollower& f, std::size_t step) {
  end_step(f.loads);
  write(f.loads.spread, step, f.run.wob_spread, f.run.tob_spread);
  write(f.loads.by_step, step, f.run.wob_by_step, f.run.tob_by_step);
  write(last_loads(f.loads), step, f.run.wob_held, f.run.tob_held);
  if (!f.counts) return;
  for (std::size_t i = 0; i < f.cutters.size(); ++i) f.run.force_B[i] += f.loads.force_B[i];
  f.run.tob += f.loads.spread.tob;
  f.run.side += lateral_size(f.loads);
  f.tally.turn += std::abs(f.to.angle - f.from.angle);
}

long first_counted(const BitPath& path, const PathOptions& options, long steps) {
  const double end = static_cast<double>(steps) * options.step;
  const double turn = std::abs(path(end).angle - path(0.0).angle);
  const double counted =
      options.counted > 0.0 ? options.counted : end * 2.0 * std::numbers::pi / turn;
  return std::max(0L, steps - std::lround(counted / options.step));
}

}  // namespace

void check_drilling(const RequestedDrilling& asked, const std::string& model) {
  const auto want = [&](bool given, const char* what) {
    if (!given) throw InputError(model + ": needs " + what);
  };
  want(asked.rotary_speed > 0.0, "a rotary speed above 0 rad/s");
  want(asked.advance >= 0.0, "an advance per revolution of 0 m or more");
  want(asked.revolutions > 0.0 && asked.step > 0.0, "revolutions and a step above 0");
  want(asked.spokes >= 3, "three spokes or more");
}

Vec3 area_force(const DragRock& rock, double area, const Vec3& normal_W, const Vec3& v_W) {
  const double drag = rock.specific_energy * area, speed = std::hypot(v_W.x(), v_W.y());
  const Vec3 along = speed > 0.0 ? Vec3(v_W.x() / speed, v_W.y() / speed, 0.0) : Vec3::Zero();
  return -drag * along - rock.normal_ratio * drag * normal_W;
}

PathRun follow(const BitPath& path, const std::vector<SpokeCutter>& cutters, const PathModel& model,
               const PathOptions& options) {
  const long steps = std::lround(options.duration / options.step);
  if (steps < 1) throw InputError("Spokes: the duration of a path is below one step");
  const long first = first_counted(path, options, steps);
  PathFollower f{model,
                 cutters,
                 empty_run(cutters.size(), steps),
                 spoke_tracker(cutters, path(0.0), model.spokes),
                 spoke_loads(cutters.size(), options.step),
                 empty_tally(cutters.size())};
  f.from = path(0.0);
  for (long step = 0; step < steps; ++step) {
    f.to = path(static_cast<double>(step + 1) * options.step);
    f.counts = step >= first;
    track(f.tracker, cutters, f.to);
    begin_step(f.loads);
    for (const SpokeCrossing& x : f.tracker.crossings) pass(f, x);
    tell(f, at(static_cast<int>(step)));
    f.from = f.to;
  }
  average(f.run, f.tally, steps - first, model.spokes);
  return f.run;
}

}  // namespace tdbd::reference
