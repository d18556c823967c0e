#include "bit/cone/cone_frame.hpp"

#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

Pose turn(double angle, const Vec3& axis) {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), Vec3::Zero()};
}

Pose shift(const Vec3& by) { return {Mat3::Identity(), by}; }

}  // namespace

Pose cone_pose(const ConeLayout& c, double phi) {
  return turn(c.azimuth, Vec3::UnitZ()) * shift({0.0, c.offset, -c.foot_height}) *
         turn(c.skew, Vec3::UnitZ()) * turn(c.journal_angle - right_angle, Vec3::UnitY()) *
         shift({0.0, 0.0, c.apex}) * turn(phi, Vec3::UnitZ());
}

Pose cone_pose(const Cone& cone, double phi) { return cone.X_BK * turn(phi, Vec3::UnitZ()); }

}  // namespace tdbd::bit
