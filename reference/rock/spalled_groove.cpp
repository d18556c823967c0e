#include "reference/rock/spalled_groove.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tdbd::reference {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

/// Height of the profile at y; infinite outside it.
double height_at(const GrooveProfile& profile, double y) {
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const Eigen::Vector2d &a = profile[i], &b = profile[i + 1];
    if (a.x() <= y && y <= b.x())
      return a.y() + (y - a.x()) / std::max(b.x() - a.x(), 1e-30) * (b.y() - a.y());
  }
  return nowhere;
}

}  // namespace

SpalledRock::SpalledRock(double half_width, int columns) : width_(2.0 * half_width / columns) {
  for (int i = 0; i < columns; ++i) y_.push_back(-half_width + (i + 0.5) * width_);
  bottom_.assign(y_.size(), 0.0);
}

GrooveAreas SpalledRock::pass(const GrooveProfile& profile, double middle, double depth,
                              const GrooveBreakout& breakout) {
  const std::vector<double> before = bottom_;
  std::vector<double> face(y_.size());  // depth of the face's edge
  double top[2] = {0.0, 0.0};           // height of the edge's ends: left, right
  for (std::size_t i = 0; i < y_.size(); ++i) {
    const double height = height_at(profile, y_[i] - middle);
    face[i] = depth - height;
    if (face[i] > before[i]) {
      double& side = top[y_[i] > middle ? 1 : 0];
      side = std::max(side, height);
    }
  }
  const double raised = (1.0 - breakout.ahead_share) * std::max(top[0], top[1]);
  GrooveAreas areas;
  for (std::size_t i = 0; i < y_.size(); ++i) {
    const double chipped =
        breakout.ahead_share > 0.0 ? std::max(0.0, face[i] - raised - before[i]) : 0.0;
    areas.ahead += chipped * width_;
    areas.cut += (std::max(0.0, face[i] - before[i]) - chipped) * width_;
    bottom_[i] = std::max(before[i], face[i]);
  }
  if (!(breakout.depth_share > 0.0)) return areas;
  const std::vector<double> groove = bottom_;
  for (std::size_t k = 0; k < y_.size(); ++k) {
    const double sign = y_[k] > middle ? 1.0 : -1.0, side_top = top[sign > 0.0 ? 1 : 0];
    if (!(face[k] > before[k]) || depth - face[k] < (1.0 - breakout.depth_share) * side_top)
      continue;
    for (std::size_t i = 0; i < y_.size(); ++i) {
      const double outwards = sign * (y_[i] - y_[k]);
      const double rise = side_top - (depth - face[k]);
      if (outwards > 0.0 && outwards < rise * std::tan(breakout.angle))
        bottom_[i] = std::max(bottom_[i], face[k] - outwards / std::tan(breakout.angle));
    }
  }
  for (std::size_t i = 0; i < y_.size(); ++i) areas.beside += (bottom_[i] - groove[i]) * width_;
  return areas;
}

}  // namespace tdbd::reference
