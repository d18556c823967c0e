#include "rock/section/face_strips.hpp"

#include <algorithm>
#include <limits>

namespace tdbd::rock {
namespace {

constexpr double ratio = 1.5;  ///< of the smallest speeds in a strip

double least_speed(const FaceColumn& c, const ForwardSpeed& v) {
  const double width = c.y1 - c.y0;
  return std::min({v({c.y0, c.lower}), v({c.y0, c.upper}),
                   v({c.y1, c.lower + c.lower_slope * width}),
                   v({c.y1, c.upper + c.upper_slope * width})});
}

}  // namespace

ForwardSpeed forward_speed(const Pose& X_BF, const rotation::Twist& twist) {
  const Vec3 n_B = X_BF.R.col(0), turning_F = X_BF.R.transpose() * n_B.cross(twist.angular_B);
  return {n_B.dot(rotation::velocity_B(twist, X_BF.p)), turning_F.tail<2>()};
}

double time_of_turn(const rotation::Twist& twist, double turn) {
  const double turning = twist.angular_B.norm();
  return turning > 0.0 ? turn / turning : std::numeric_limits<double>::infinity();
}

void face_strips(const FaceColumns& face, const ForwardSpeed& v, const SpeedRange& range,
                 double lead, double longest_time, std::vector<FaceStrip>& strips) {
  strips.clear();
  if (lead == 0.0) return strips.push_back({0, face.columns.size(), 0.0});
  const double slowest = std::max(range.slowest, lead / longest_time);
  if (std::max(range.fastest, slowest) <= ratio * slowest)
    return strips.push_back({0, face.columns.size(), lead / slowest});
  double least = 0.0, greatest = 0.0;
  for (std::size_t i = 0; i < face.columns.size(); ++i) {
    const double speed = std::max(least_speed(face.columns[i], v), lead / longest_time);
    const bool begins =
        strips.empty() || std::max(greatest, speed) > ratio * std::min(least, speed);
    least = begins ? speed : std::min(least, speed);
    greatest = begins ? speed : std::max(greatest, speed);
    const std::size_t first = begins ? i : strips.back().first;
    if (begins) strips.emplace_back();
    strips.back() = {first, i + 1, lead / least};
  }
}

}  // namespace tdbd::rock
