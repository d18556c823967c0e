#include "reference/literature/drag/spokes/spoke_cutter.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

/// The ellipse centre + p cos s + q sin s of conjugate half-diameters.
RimEllipse ellipse_of(double r, double z, const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
  const double width = std::hypot(p.x(), q.x());
  return {r, z, width, std::abs(p.x() * q.y() - p.y() * q.x()) / width,
          (p.x() * p.y() + q.x() * q.y()) / (width * width)};
}

}  // namespace

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
  PlacedCutter p;
  const Vec3 tip = turned(place, cutter.tip_B),
             centre_W = turned(place, cutter.centre_B) + place.p_WB;
  p.tip_W = tip + place.p_WB;
  p.radius = std::hypot(p.tip_W.x(), p.tip_W.y());
  p.cosine = p.radius > 0.0 ? p.tip_W.x() / p.radius : 1.0;
  p.sine = p.radius > 0.0 ? p.tip_W.y() / p.radius : 0.0;
  const auto foot = [&](const Vec3& v) {
    return Eigen::Vector2d(p.cosine * v.x() + p.sine * v.y(), v.z());
  };
  const Eigen::Vector2d centre = foot(centre_W), down = foot(p.tip_W) - centre;
  p.rim = ellipse_of(centre.x(), centre.y(), down, foot(turned(place, cutter.along_B)));
  return p;
}

double widest_reach(const std::vector<SpokeCutter>& cutters) {
  double reach = 0.0;
  for (const SpokeCutter& c : cutters) {
    const RimEllipse rim = placed(c, {}).rim;
    reach = std::max(reach, rim.reach());
  }
  return reach;
}

}  // namespace tdbd::reference
