#include "reference/calibration/nonnegative_least_squares.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace tdbd::reference {
namespace {

using Set = std::vector<Eigen::Index>;

/// Least squares over the columns of a set; 0 elsewhere.
Eigen::VectorXd over(const Set& set, const Eigen::MatrixXd& N, const Eigen::VectorXd& c) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(c.size());
  if (set.empty()) return x;
  const Eigen::MatrixXd part = N(set, set);
  x(set) = part.fullPivLu().solve(Eigen::VectorXd(c(set)));
  return x;
}

/// The index outside the set whose increase reduces the sum of squares most, or -1.
Eigen::Index steepest(const Set& set, const Eigen::VectorXd& slope, double rounding) {
  Eigen::Index best = -1;
  for (Eigen::Index k = 0; k < slope.size(); ++k)
    if (std::ranges::find(set, k) == set.end() && slope[k] > rounding &&
        (best < 0 || slope[k] > slope[best]))
      best = k;
  return best;
}

/// Moves x towards y until an element of the set is 0, and removes the zero elements from the set.
void step_back(const Eigen::VectorXd& y, Eigen::VectorXd& x, Set& set) {
  double share = 1.0;
  Eigen::Index first = set.front();
  for (const Eigen::Index k : set)
    if (y[k] <= 0.0 && x[k] / (x[k] - y[k]) < share) {
      share = x[k] / (x[k] - y[k]);
      first = k;
    }
  x += share * (y - x);
  x[first] = 0.0;
  std::erase_if(set, [&](Eigen::Index k) { return x[k] <= 0.0; });
  for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = std::max(0.0, x[k]);
}

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  const Eigen::VectorXd scale = A.colwise().norm().cwiseMax(std::numeric_limits<double>::min());
  const Eigen::MatrixXd scaled = A * scale.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd N = scaled.transpose() * scaled;
  const Eigen::VectorXd c = scaled.transpose() * b;
  const double rounding = 1e-13 * b.norm();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  Set set;
  const Eigen::Index most = 10 * A.cols();
  for (Eigen::Index i = 0; i < most; ++i) {
    const Eigen::Index next = steepest(set, c - N * x, rounding);
    if (next < 0) break;
    set.push_back(next);
    Eigen::VectorXd y = over(set, N, c);
    while (!set.empty() && std::ranges::any_of(set, [&](Eigen::Index k) { return y[k] <= 0.0; })) {
      step_back(y, x, set);
      y = over(set, N, c);
    }
    x = y;
  }
  return x.cwiseQuotient(scale);
}

}  // namespace tdbd::reference
