#include "bit/profile/bit_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "bit/cutter/cutter_frame.hpp"

namespace tdbd::bit {

std::vector<double> overlaps(const std::vector<Cutter>& cutters) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < cutters.size(); ++k)
    if (cutters[k].under_exposure == 0.0) order.push_back(k);
  std::ranges::stable_sort(order, {}, [&](std::size_t k) {
    return std::tuple(cutters[k].tip_radius, cutters[k].tip_height);
  });
  std::vector<double> overlap(cutters.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 1; k < order.size(); ++k) {
    const Cutter &a = cutters[order[k - 1]], &b = cutters[order[k]];
    const double gap = std::hypot(b.tip_radius - a.tip_radius, b.tip_height - a.tip_height);
    overlap[order[k - 1]] = 1.0 - gap / (0.5 * (a.diameter + b.diameter));
  }
  return overlap;
}

Vec3 imbalance_vector(const std::vector<Cutter>& cutters, const std::vector<double>& areas) {
  Vec3 sum = Vec3::Zero();
  double total = 0.0;
  for (std::size_t k = 0; k < cutters.size(); ++k) {
    sum += areas[k] * profile_normal_B(cutters[k]);
    total += areas[k];
  }
  sum.z() = 0.0;
  return total > 0.0 ? Vec3(sum / total) : Vec3(Vec3::Zero());
}

double imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas) {
  return imbalance_vector(cutters, areas).norm();
}

double planar_imbalance(const std::vector<Cutter>& cutters, const std::vector<double>& areas,
                        double normal_ratio) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < cutters.size(); ++k) {
    const Vec3 way(-std::sin(cutters[k].azimuth), std::cos(cutters[k].azimuth), 0.0);
    sum -= areas[k] * (normal_ratio * profile_normal_B(cutters[k]) + way);
  }
  const double weight = -sum.z();
  return weight > 0.0 ? sum.head<2>().norm() / weight : std::numeric_limits<double>::quiet_NaN();
}

double mean_redundancy(const std::vector<int>& cutting) {
  double sum = 0.0, weight = 0.0;
  for (std::size_t k = 0; k < cutting.size(); ++k) {
    const double ring = 2.0 * static_cast<double>(k) + 1.0;
    sum += ring * cutting[k];
    weight += ring;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

}  // namespace tdbd::bit
