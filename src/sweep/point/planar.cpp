#include "sweep/point/planar.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "bit/cutter/cutter.hpp"
#include "core/error.hpp"
#include "forces/part/directions.hpp"
#include "simulation/step/loads.hpp"

namespace tdbd::sweep {
namespace {

namespace sim = simulation;

/// What a cutter cuts in the radial plane.
struct CutterCut {
  const bit::Cutter& cutter;
  double area = 0.0, edge = 0.0, arm = 0.0;  ///< m2, m, m
};

/// The contact of a face: its area in the plane of the face gives the cut area normal to its path.
void take_face(const CutterCut& cut, const Vec3& along_W, sim::CutOfPart& c) {
  const double ahead = c.forward_W.dot(along_W);
  c.cut.diameter = cut.cutter.diameter;
  c.face_area = ahead > 0.0 ? cut.area / ahead : 0.0;
}

/// The contact of a chamfer behind the engaged edge.
void take_chamfer(const CutterCut& cut, const Vec3& along_W, sim::CutOfPart& c) {
  const double rake = forces::effective_back_rake(c.forward_W, along_W);
  c.cut.contact_area = cut.edge * sim::chamfer_width(cut.cutter, rake);
}

/// The cut of a face or a chamfer at its place in the hole.
sim::CutOfPart cut_of(const sim::Case& c, int part, const CutterCut& cut,
                      const sim::BitVelocity& motion, const Pose& X_WB) {
  const bit::Part& of = c.bit.parts[static_cast<std::size_t>(part)];
  const Vec3 p_B(cut.arm * std::cos(cut.cutter.azimuth), cut.arm * std::sin(cut.cutter.azimuth),
                 -cut.cutter.tip_height);
  sim::CutOfPart found;
  found.part = part;
  found.cut.kind = of.kind;
  found.cut.point = X_WB * p_B;
  found.cut.normal = X_WB.R * bit::profile_normal_B(cut.cutter);
  found.cut.engaged_edge = cut.edge;
  found.forward_W = X_WB.R * cut.cutter.X_BC.R.col(0);
  const Vec3 along_W = sim::velocity_at(c.bit, X_WB, motion, -1, found.cut.point).normalized();
  if (of.kind == bit::PartKind::face)
    take_face(cut, along_W, found);
  else
    take_chamfer(cut, along_W, found);
  found.cut.strength = forces::strength_at(c.forces.rock, found.cut.point);
  return found;
}

}  // namespace

PlanarLoads planar_loads(const sim::Case& c, const std::vector<int>& indices,
                         const bit::Engagement& e, double advance) {
  constexpr double any_time = 1e-3;  // s: no cut of the planar model depends on the time step
  const double speed = c.motion.rotary_speed;
  const double rate = advance * speed / (2.0 * std::numbers::pi);
  const Pose X_WB;
  const sim::BitVelocity motion{X_WB.p, Vec3(0.0, 0.0, rate), Vec3(0.0, 0.0, speed), {}};
  PlanarLoads sum;
  for (std::size_t p = 0; p < c.bit.parts.size(); ++p) {
    const bit::Part& part = c.bit.parts[p];
    const auto k = std::ranges::find(indices, part.cutter) - indices.begin();
    const bool cuts = part.kind == bit::PartKind::face || part.kind == bit::PartKind::chamfer;
    if (!cuts || k == std::ssize(indices) || !sim::has_law(c.forces, c.bit, p)) continue;
    const double area = e.area[static_cast<std::size_t>(k)];
    if (!(area > 0.0)) continue;
    const CutterCut cut{c.bit.cutters[static_cast<std::size_t>(part.cutter)], area,
                        e.edge[static_cast<std::size_t>(k)],
                        e.volume[static_cast<std::size_t>(k)] / (2.0 * std::numbers::pi * area)};
    const sim::CutOfPart found = cut_of(c, static_cast<int>(p), cut, motion, X_WB);
    const sim::PartLoad load = sim::load_of(c.forces, c.bit, X_WB, motion, any_time, found);
    sum.force_B += load.force_W;
    sum.torque -= load.point_W.cross(load.force_W).z();
  }
  return sum;
}

nlohmann::ordered_json planar_summary(const sim::Case& c, double normal_ratio) {
  const sim::Motion& m = c.motion;
  const std::vector<int> indices = bit::cutting_at_start(c.bit);
  if (indices.empty())
    throw InputError(
        "bit.file: found a bit without cutters that cut from the start, expected one that the "
        "planar model knows");
  if (!(m.rotary_speed > 0.0 && m.rate_of_penetration > 0.0))
    throw InputError(
        "motion: found no advance per revolution, expected a rotary speed and a rate of "
        "penetration");
  const double advance = 2.0 * std::numbers::pi * m.rate_of_penetration / m.rotary_speed;
  const std::vector<bit::Cutter> cutters = bit::cutters_at(c.bit, indices);
  const bit::Engagement e = bit::engagement(cutters, advance, bit::report_column_width);
  const double classical = bit::planar_imbalance(cutters, e.area, normal_ratio);
  nlohmann::ordered_json weight, torque, imbalance = classical;
  if (c.forces.forces == sim::Forces::on) {
    const PlanarLoads loads = planar_loads(c, indices, e, advance);
    weight = -loads.force_B.z();
    torque = loads.torque;
    imbalance = loads.force_B.z() < 0.0
                    ? nlohmann::ordered_json(loads.force_B.head<2>().norm() / -loads.force_B.z())
                    : nlohmann::ordered_json();
  }
  return {{"advance_m", advance},
          {"imbalance", imbalance},
          {"imbalance_of_normal_ratio", classical},
          {"imbalance_of_unit_law", bit::imbalance(cutters, e.area)},
          {"wob_n", weight},
          {"tob_n_m", torque},
          {"mean_redundancy", bit::mean_redundancy(e.cutting)},
          {"cut_area_m2", std::accumulate(e.area.begin(), e.area.end(), 0.0)},
          {"largest_cut_area_m2", std::ranges::max(e.area)},
          {"engaged_cutters", std::ranges::count_if(e.area, [](double a) { return a > 0.0; })}};
}

}  // namespace tdbd::sweep
