#include "reference/literature/drag/planes/behr_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::reference {
namespace {

/// Adds the planes between two azimuths of a tip, in the order in which it crosses them.
void add_crossings(BehrState& state, std::size_t cutter, const Vec3& from_W, const Vec3& to_W,
                   double to_azimuth) {
  const int planes = state.bottom.spokes;
  const double spacing = 2 * std::numbers::pi / planes;
  const auto sector = [&](double azimuth) {
    return static_cast<int>(std::floor(azimuth / spacing));
  };
  const int first = sector(state.azimuth[cutter]), last = sector(to_azimuth);
  const bool is_backward = last < first;
  for (int k = first; k != last; k += is_backward ? -1 : 1) {
    const int plane = ((is_backward ? k : k + 1) % planes + planes) % planes;
    const SpokePlane& p = state.planes[at(plane)];
    const double before = p.beside(from_W), after = p.beside(to_W);
    const double when = before == after ? 0.0 : std::clamp(before / (before - after), 0.0, 1.0);
    state.crossings.push_back({when, cutter, plane, is_backward});
  }
}

/// The outline of a rim in a plane of the hole.
RimEllipse outline_in(const SpokePlane& plane, const BitPlace& place, const CutterRim& rim) {
  const double cosine = std::cos(place.angle), sine = std::sin(place.angle);
  const Vec3 radial_B(plane.cosine * cosine + plane.sine * sine,
                      plane.sine * cosine - plane.cosine * sine, 0.0);
  RimEllipse e = rim_ellipse(rim, radial_B);
  const double aside = plane.cosine * place.p_WB.x() + plane.sine * place.p_WB.y();
  e.x0 += aside;
  e.z0 += place.p_WB.z();
  e.flat += e.normal_x * aside + e.normal_z * place.p_WB.z();
  return e;
}

/// Area and its moment about the axis.
struct Removed {
  double area = 0.0, moment = 0.0;  ///< m2, m3
};

Removed lower_nodes(Spokes& bottom, int plane, const RimEllipse& e) {
  const double spacing = bottom.node_spacing();
  const int first = std::max(0, static_cast<int>(std::ceil((e.x0 - e.half_width) / spacing - 0.5)));
  const int end = std::min(bottom.nodes, static_cast<int>(std::floor(e.reach() / spacing + 0.5)));
  double* depth = bottom.depth.data() + plane * bottom.nodes;
  Removed sum;
  for (int k = first; k < end; ++k) {
    const double r = bottom.node_radius(k), z = depth_at(e, r);
    if (!(z > depth[k])) continue;
    sum.area += (z - depth[k]) * spacing;
    sum.moment += (z - depth[k]) * spacing * r;
    depth[k] = z;
  }
  return sum;
}

}  // namespace

Vec3 tip_velocity(const BehrSegment& way, const BitPlace& place, const CutterRim& rim) {
  const Vec3 arm = turned(place, rim.tip_B), moved = way.to.p_WB - way.from.p_WB;
  const double turn = way.to.angle - way.from.angle;
  return Vec3(moved.x() - turn * arm.y(), moved.y() + turn * arm.x(), 0.0) / way.dt;
}

void find_crossings(BehrState& state, const BehrSegment& way) {
  state.crossings.clear();
  for (std::size_t i = 0; i < state.rims.size(); ++i) {
    const Vec3 from = way.from.p_WB + turned(way.from, state.rims[i].tip_B);
    const Vec3 to = way.to.p_WB + turned(way.to, state.rims[i].tip_B);
    const double across = from.x() * to.y() - from.y() * to.x(),
                 along = from.x() * to.x() + from.y() * to.y();
    const double azimuth = state.azimuth[i] + std::atan2(across, along);
    add_crossings(state, i, from, to, azimuth);
    state.azimuth[i] = azimuth;
  }
  std::stable_sort(state.crossings.begin(), state.crossings.end(),
                   [](const auto& a, const auto& b) { return a.when < b.when; });
}

BehrCut cut_at(BehrState& state, const BehrSegment& way, const BehrCrossing& crossing,
               double& volume) {
  const CutterRim& rim = state.rims[crossing.cutter];
  const SpokePlane& plane = state.planes[at(crossing.plane)];
  const BitPlace place = way.at(crossing.when);
  const Removed removed = lower_nodes(state.bottom, crossing.plane, outline_in(plane, place, rim));
  volume += removed.moment * 2 * std::numbers::pi / state.bottom.spokes;
  BehrCut cut;
  cut.area = removed.area;
  const Vec3 v_W = tip_velocity(way, place, rim);
  const double about = std::abs(plane.cosine * v_W.y() - plane.sine * v_W.x());
  cut.effective = v_W.norm() > 0.0 ? removed.area * about / v_W.norm() : 0.0;
  cut.arm = removed.area > 0.0 ? removed.moment / removed.area : 0.0;
  cut.is_backward = !(v_W.dot(turned(place, rim.face_B)) > 0.0);
  return cut;
}

}  // namespace tdbd::reference
