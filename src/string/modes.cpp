#include "string/modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/types.hpp"

namespace tdbd::string {
namespace {

/// Number of frequencies below omega (square, 1/s2): the number of negative pivots if nodes are
/// eliminated from the end upwards.
int count_below(const std::vector<double>& k, const std::vector<double>& m, double square) {
  double below = 0.0;  // dynamic stiffness of the part below a node
  int negative = 0;
  for (std::size_t i = k.size(); i > 0; --i) {
    const double own = below - square * m[i];
    const double pivot = k[i - 1] + own;
    negative += pivot < 0.0;
    below = pivot == 0.0 ? -HUGE_VAL : k[i - 1] * (own / pivot);
  }
  return negative;
}

/// Mode shape below a fixed top, computed downwards from the force in the first element.
std::vector<double> shape_of(const std::vector<double>& k, const std::vector<double>& m,
                             double square) {
  std::vector<double> shape{0.0};
  double force = 1.0;
  for (std::size_t i = 0; i < k.size(); ++i) {
    shape.push_back(shape.back() + force / k[i]);
    force -= square * m[i + 1] * shape.back();
  }
  const auto largest = *std::max_element(
      shape.begin(), shape.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  for (double& x : shape) x /= largest;
  return shape;
}

}  // namespace

std::vector<Mode> lowest_modes(const std::vector<double>& k, const std::vector<double>& m,
                               int count) {
  double bound = 0.0;
  for (std::size_t i = 1; i <= k.size(); ++i)
    bound = std::max(bound, 2.0 * (k[i - 1] + (i < k.size() ? k[i] : 0.0)) / m[i]);
  std::vector<Mode> modes;
  for (int j = 0; j < std::min(count, static_cast<int>(k.size())); ++j) {
    double lo = 0.0, hi = std::sqrt(bound) * 1.001;
    for (double mid = 0.5 * hi; mid > lo && mid < hi; mid = 0.5 * (lo + hi))
      (count_below(k, m, mid * mid) > j ? hi : lo) = mid;
    modes.push_back({lo / (2.0 * std::numbers::pi), shape_of(k, m, lo * lo)});
  }
  return modes;
}

}  // namespace tdbd::string
