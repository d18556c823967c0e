#include "reference/literature/drag/spokes/spoke_cutter.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

/// The ellipse centre + p cos s + q sin s of conjugate half-diameters.
SpokeRim ellipse_of(double r, double z, const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
  const double width = std::hypot(p.x(), q.x());
  return {r, z, width, (p.x() * p.y() + q.x() * q.y()) / (width * width),
          std::abs(p.x() * q.y() - p.y() * q.x()) / width};
}

double branch(const SpokeRim& e, double at_r, double sign) {
  const double x = at_r - e.r, share = x / e.half_width;
  return e.z + e.slope * x + sign * e.half_height * std::sqrt(std::max(0.0, 1.0 - share * share));
}

}  // namespace

double SpokeRim::lower(double at_r) const { return branch(*this, at_r, 1.0); }
double SpokeRim::upper(double at_r) const { return branch(*this, at_r, -1.0); }

BitPlace between(const BitPlace& a, const BitPlace& b, double share) {
  return {a.p_WB + share * (b.p_WB - a.p_WB), std::lerp(a.angle, b.angle, share)};
}

Vec3 turned(const Vec3& v_B, const BitPlace& place) {
  const double c = std::cos(place.angle), s = std::sin(place.angle);
  return {c * v_B.x() - s * v_B.y(), s * v_B.x() + c * v_B.y(), v_B.z()};
}

std::vector<SpokeCutter> spoke_cutters(const std::vector<bit::Cutter>& cutters,
                                       const std::string& model) {
  if (cutters.empty())
    throw InputError(model + ": found a bit without cutters; needs a table of PDC cutters");
  std::vector<SpokeCutter> rims;
  for (const bit::Cutter& c : cutters) {
    const double a = c.diameter / 2.0;
    if (!(a > 0.0))
      throw InputError(model + ": cutter " + std::to_string(c.id) +
                       " has no size; needs a diameter above 0");
    SpokeCutter rim;
    rim.centre_B = c.X_BC.p;
    rim.tip_B = c.X_BC * Vec3(0.0, 0.0, -a);
    rim.along_B = a * c.X_BC.R.col(1);
    rim.face_B = c.X_BC.R.col(0);
    const double sine = std::sin(c.profile_angle);
    rim.normal_B = {sine * std::cos(c.azimuth), sine * std::sin(c.azimuth),
                    std::cos(c.profile_angle)};
    rim.back_rake = c.back_rake;
    rim.chamfer = c.chamfer;
    rim.chamfer_angle = c.chamfer_angle;
    rims.push_back(rim);
  }
  return rims;
}

PlacedCutter placed(const SpokeCutter& cutter, const BitPlace& place) {
  const double c = std::cos(place.angle), s = std::sin(place.angle);
  const auto in_W = [&](const Vec3& v) {
    return Vec3(c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z());
  };
  PlacedCutter p;
  const Vec3 tip = in_W(cutter.tip_B), centre_W = in_W(cutter.centre_B) + place.p_WB;
  p.tip_W = tip + place.p_WB;
  p.radius = std::hypot(p.tip_W.x(), p.tip_W.y());
  p.cosine = p.radius > 0.0 ? p.tip_W.x() / p.radius : 1.0;
  p.sine = p.radius > 0.0 ? p.tip_W.y() / p.radius : 0.0;
  const auto foot = [&](const Vec3& v) {
    return Eigen::Vector2d(p.cosine * v.x() + p.sine * v.y(), v.z());
  };
  const Eigen::Vector2d centre = foot(centre_W), down = foot(p.tip_W) - centre;
  p.rim = ellipse_of(centre.x(), centre.y(), down, foot(in_W(cutter.along_B)));
  return p;
}

double widest_reach(const std::vector<SpokeCutter>& cutters) {
  double reach = 0.0;
  for (const SpokeCutter& c : cutters) {
    const SpokeRim rim = placed(c, {}).rim;
    reach = std::max(reach, rim.r + rim.half_width);
  }
  return reach;
}

}  // namespace tdbd::reference
