#include "reference/literature/drag/behr.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/literature/drag/behr_crossings.hpp"
#include "reference/literature/drag/drag_input.hpp"

namespace tdbd::reference {
namespace {

const std::string behr_name = "Behr et al.";

void require_behr(const std::vector<bit::Cutter>& cutters, const BehrOptions& options) {
  require_cutters(behr_name, cutters);
  require_positive(behr_name, "planes", options.planes);
  require_positive(behr_name, "nodes on a plane", options.nodes);
  require_positive(behr_name, "radius to which planes reach (m)", options.radius);
  require_one_each(behr_name, "normal ratios", options.normal_ratio.size(), cutters.size());
  require_one_each(behr_name, "areas of flats", options.flat_area.size(), cutters.size());
}

/// The deepest outline of all at each node; where there is none, the shallowest of those depths; 0
/// if all pass between the nodes.
std::vector<double> profile(const std::vector<CutterRim>& rims, const Spokes& rock) {
  std::vector<RimEllipse> outlines;
  for (const CutterRim& rim : rims)
    outlines.push_back(rim_ellipse(rim, rim.motion_B.cross(Vec3::UnitZ())));
  std::vector<double> depth(at(rock.nodes), no_depth);
  double shallowest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < rock.nodes; ++k) {
    double& z = depth[at(k)];
    for (const RimEllipse& e : outlines) z = std::max(z, depth_at(e, rock.node_radius(k)));
    if (z != no_depth) shallowest = std::min(shallowest, z);
  }
  const double level = std::isfinite(shallowest) ? shallowest : 0.0;
  std::replace(depth.begin(), depth.end(), no_depth, level);
  return depth;
}

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
  load.cutters[c.cutter].force_W += F_W;
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

void cut_on(BehrState& state, const BehrWay& way, double dt, const DragRock& rock,
            const BehrOptions& options, BehrLoad& load) {
  find_crossings(state, way);
  for (const BehrCrossing& crossing : state.crossings) {
    BehrCutter& own = load.cutters[crossing.cutter];
    double volume = 0.0;
    const BehrCut cut = cut_at(state, way, crossing, volume);
    own.area += cut.area;
    own.volume += volume;
    if (cut.is_backward) own.rubbed_volume += volume;
    ++own.crossings;
    own.backward_crossings += crossing.is_backward;
    state.last[crossing.cutter] = cut;
    if (options.force_time == ForceTime::held) continue;
    const SpokePlane& plane = state.planes[at(crossing.plane)];
    Contact c{crossing.cutter, cut, Vec3::Zero(), Vec3::Zero(), way.at(crossing.when), 0.0};
    c.v_W = tip_velocity(way, c.place, state.rims[crossing.cutter]);
    c.point_W = cut.arm * Vec3(plane.cosine, plane.sine, 0.0);
    c.share = time_share(state, c, plane, dt);
    add_force(state, c, force_of(c, rock, options), load);
  }
}

void add_held(const BehrState& state, const BehrWay& way, const DragRock& rock,
              const BehrOptions& options, BehrLoad& load) {
  for (std::size_t i = 0; i < state.rims.size(); ++i) {
    const Vec3 v_W = tip_velocity(way, way.to, state.rims[i]);
    Vec3 tip_W = way.to.p_WB + turned(way.to, state.rims[i].tip_B);
    tip_W.z() = 0.0;
    const Contact c{i, state.last[i], v_W, state.last[i].arm * tip_W.normalized(), way.to, 1.0};
    add_force(state, c, force_of(c, rock, options), load);
  }
}

void clear(BehrLoad& load, std::size_t cutters) {
  load.weight = load.torque = load.volume = 0.0;
  load.lateral_W.setZero();
  load.cutters.assign(cutters, {});
}

}  // namespace

BehrState behr_start(const std::vector<bit::Cutter>& cutters, const BitPlace& place,
                     const BehrOptions& options) {
  require_behr(cutters, options);
  BehrState s;
  for (const bit::Cutter& c : cutters) s.rims.push_back(cutter_rim(c, 0.0));
  s.bottom = flat_spokes(options.radius, 0.0, options.planes, options.nodes);
  const std::vector<double> depth = profile(s.rims, s.bottom);
  for (int k = 0; k < options.planes; ++k) {
    s.planes.push_back(spoke_plane(k, options.planes));
    for (int j = 0; j < options.nodes; ++j)
      s.bottom.depth[at(k * options.nodes + j)] = place.p_WB.z() + depth[at(j)];
  }
  s.place = place;
  for (const CutterRim& rim : s.rims) {
    const Vec3 tip_W = place.p_WB + turned(place, rim.tip_B);
    s.azimuth.push_back(std::atan2(tip_W.y(), tip_W.x()));
  }
  s.last.resize(cutters.size());
  return s;
}

void behr_step(BehrState& state, const BitPlace& to, double dt, const DragRock& rock,
               const BehrOptions& options, BehrLoad& load) {
  clear(load, state.rims.size());
  constexpr double widest_turn = std::numbers::pi / 180;
  const BehrWay step{state.place, to, dt};
  const double turn = std::abs(to.angle - state.place.angle);
  const int parts = std::max(1, static_cast<int>(std::ceil(turn / widest_turn)));
  for (int k = 0; k < parts; ++k) {
    const double from = static_cast<double>(k) / parts, end = static_cast<double>(k + 1) / parts;
    cut_on(state, {step.at(from), k + 1 < parts ? step.at(end) : to, dt / parts}, dt, rock, options,
           load);
  }
  state.place = to;
  if (options.force_time == ForceTime::held) add_held(state, step, rock, options, load);
  for (const BehrCutter& c : load.cutters) load.volume += c.volume;
}

}  // namespace tdbd::reference
