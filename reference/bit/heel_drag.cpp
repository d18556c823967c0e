#include "reference/bit/heel_drag.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/types.hpp"

namespace tdbd::reference {
namespace {

using bit::Cutter;

constexpr int steps_of_edge = 128;   ///< on half a rim
constexpr int steps_of_length = 64;  ///< from the edge to the back of the body

/// The tip in the cutter's frame: on the rim, behind the face by the depth of the chamfers.
Vec3 tip_C(const Cutter& c) {
  const double chamfer = c.chamfer / std::tan(c.chamfer_angle);
  const double land = c.land > 0.0 ? c.land / std::tan(c.land_angle) : 0.0;
  return {c.chamfer > 0.0 ? -(chamfer + land) : 0.0, 0.0, -0.5 * c.diameter};
}

/// The point (r, z) of the half-plane at the cutter's azimuth, in space.
Vec3 in_space(const Cutter& c, double r, double z) {
  return {r * std::cos(c.azimuth), r * std::sin(c.azimuth), z};
}

/// A point, moved back to the wear flat, in the half-plane at its azimuth: u along the profile and
/// v along its normal, both from the tip, and the angle by which it trails the tip.
struct ProfilePlace {
  double u, v, trail;
};

ProfilePlace place(const Cutter& c, const Vec3& x_C) {
  Vec3 x_B = c.X_BC * x_C;
  const Vec3 n_B = in_space(c, std::sin(c.profile_angle), std::cos(c.profile_angle));
  x_B -= std::max(0.0, n_B.dot(x_B - in_space(c, c.tip_radius, -c.tip_height)) + c.wear) * n_B;
  const double r = std::hypot(x_B.x(), x_B.y()) - c.tip_radius, z = x_B.z() + c.tip_height;
  const double st = std::sin(c.profile_angle), ct = std::cos(c.profile_angle);
  const double ahead = std::remainder(std::atan2(x_B.y(), x_B.x()) - c.azimuth, full_turn);
  return {ct * r - st * z, st * r + ct * z, -ahead};
}

/// The point of the cutter's rim at the angle a from the tip, at the distance `behind` behind the
/// edge.
Vec3 rim_C(const Cutter& c, double a, double behind) {
  const Vec3 tip = tip_C(c);
  return {tip.x() - behind, tip.z() * std::sin(a), tip.z() * std::cos(a)};
}

double rim_angle(int k) { return pi * (static_cast<double>(k) / steps_of_edge - 0.5); }

/// The cutting edge down to `depth` behind its lowest line along the normal, in ascending u.
std::vector<ProfilePlace> cutting_edge(const Cutter& c, double depth) {
  std::vector<ProfilePlace> edge;
  for (int k = 0; k <= steps_of_edge; ++k) {
    const ProfilePlace p = place(c, rim_C(c, rim_angle(k), 0.0));
    if (p.v >= -c.wear - depth) edge.push_back(p);
  }
  std::ranges::sort(edge, {}, &ProfilePlace::u);
  return edge;
}

/// Height of p above the groove of the edge, along the normal; -infinity outside its width.
double height_over_groove(const std::vector<ProfilePlace>& edge, const ProfilePlace& p,
                          double advance_along_n) {
  const auto after = std::ranges::upper_bound(edge, p.u, {}, &ProfilePlace::u);
  if (after == edge.begin() || after == edge.end()) return -std::numeric_limits<double>::infinity();
  const auto before = after - 1;
  const double w = (p.u - before->u) / (after->u - before->u);
  const double v = std::lerp(before->v, after->v, w);
  const double trail = p.trail - std::lerp(before->trail, after->trail, w);
  return p.v - v + advance_along_n * trail / full_turn;
}

double drag_of(const Cutter& c, double advance_per_rev) {
  const std::vector<ProfilePlace> edge = cutting_edge(c, advance_per_rev);
  const double back = c.length + tip_C(c).x();
  const double advance_along_n = advance_per_rev * std::cos(c.profile_angle);
  double drag = -std::numeric_limits<double>::infinity();
  for (int j = 1; j <= steps_of_length; ++j)
    for (int k = 0; k <= steps_of_edge; ++k) {
      const Vec3 heel_C = rim_C(c, rim_angle(k), back * j / steps_of_length);
      drag = std::max(drag, height_over_groove(edge, place(c, heel_C), advance_along_n));
    }
  return drag;
}

}  // namespace

std::vector<double> heel_drag(const bit::Bit& bit, double advance_per_rev) {
  std::vector<double> drag;
  for (const Cutter& c : bit.cutters) drag.push_back(drag_of(c, advance_per_rev));
  return drag;
}

}  // namespace tdbd::reference
