#include "reference/calibration/dense_covariance.hpp"

namespace tdbd::reference {

Eigen::MatrixXd covariance_of_readings(const std::vector<ReadingError>& readings,
                                       const SharedError& shared) {
  const auto n = static_cast<Eigen::Index>(readings.size());
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const ReadingError& a = readings[static_cast<std::size_t>(i)];
      const ReadingError& b = readings[static_cast<std::size_t>(j)];
      if (i == j) C(i, j) += a.own * a.own;
      if (a.test == b.test) C(i, j) += shared.test * shared.test;
      if (a.record == b.record) C(i, j) += shared.rate * shared.rate * a.slope * b.slope;
    }
  return C;
}

Eigen::MatrixXd inverse_by_elimination(Eigen::MatrixXd A) {
  const Eigen::Index n = A.rows();
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index pivot = 0;
    A.col(k).tail(n - k).cwiseAbs().maxCoeff(&pivot);
    A.row(k).swap(A.row(k + pivot));
    inverse.row(k).swap(inverse.row(k + pivot));
    const double over = 1.0 / A(k, k);
    A.row(k) *= over;
    inverse.row(k) *= over;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (i == k) continue;
      const double times = A(i, k);
      A.row(i) -= times * A.row(k);
      inverse.row(i) -= times * inverse.row(k);
    }
  }
  return inverse;
}

Eigen::MatrixXd covariance_of_coefficients(const Eigen::MatrixXd& J, const Eigen::MatrixXd& C,
                                           const Priors& priors) {
  Eigen::MatrixXd N = J.transpose() * inverse_by_elimination(C) * J;
  for (Eigen::Index k = 0; k < N.rows(); ++k)
    if (const auto& sd = priors[static_cast<std::size_t>(k)]) N(k, k) += 1.0 / (*sd * *sd);
  return inverse_by_elimination(N);
}

}  // namespace tdbd::reference
