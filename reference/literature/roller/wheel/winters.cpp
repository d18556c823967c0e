#include "reference/literature/roller/wheel/winters.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"

namespace tdbd::reference {
namespace {

constexpr double least_winters_condition = 1e-9;  ///< smallest over largest singular value

[[noreturn]] void refuse_winters(const std::string& why) {
  throw InputError("Winters, Warren and Onyia: " + why);
}

void winters_needs(double value, const char* what) {
  if (!(value > 0.0))
    refuse_winters("found " + std::string(what) + " " + std::to_string(value) +
                   ", expected a positive one");
}

void winters_needs_run(const WintersRun& run) {
  winters_needs(run.weight, "a weight of");
  winters_needs(run.diameter, "a diameter of");
  winters_needs(run.rotary_speed, "a rotary speed of");
}

/// N D, m/s: the rate of one diameter per turn.
double winters_speed(const WintersRun& run) {
  return run.rotary_speed / (2.0 * std::numbers::pi) * run.diameter;
}

/// Rows delta (1/w^2, 1/w, 1): their product with the constants is 1 if the fit is exact.
Eigen::MatrixXd winters_rows(const std::vector<WintersPoint>& points) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 3);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const WintersPoint& p = points[static_cast<std::size_t>(i)];
    winters_needs_run(p.run);
    winters_needs(p.strength, "a strength of");
    winters_needs(p.rate, "a rate of");
    const double delta = p.rate / winters_speed(p.run), w = winters_weight(p.run, p.strength);
    rows.row(i) << delta / (w * w), delta / w, delta;
  }
  return rows;
}

}  // namespace

WintersTerms winters_terms(const WintersConstants& constants, double w) {
  return {constants.ductility / (w * w), constants.offset / w, constants.teeth, constants.cleaning};
}

double winters_weight(const WintersRun& run, double strength) {
  return run.weight / (strength * run.diameter * run.diameter);
}

double winters_rate(const WintersConstants& constants, const WintersRun& run, double strength) {
  winters_needs_run(run);
  winters_needs(strength, "a strength of");
  const double sum = winters_terms(constants, winters_weight(run, strength)).sum();
  winters_needs(sum, "constants whose sum of terms is");
  return winters_speed(run) / sum;
}

double winters_strength(const WintersConstants& constants, const WintersRun& run, double rate) {
  winters_needs_run(run);
  winters_needs(rate, "a rate of");
  const double x = winters_speed(run) / rate - constants.teeth - constants.cleaning;
  if (!(x > 0.0))
    refuse_winters(
        "found a rate of " + std::to_string(rate) + " m/s, expected less than N D/(b + c) = " +
        std::to_string(winters_speed(run) / (constants.teeth + constants.cleaning)) + " m/s");
  // The root of q (1/w)^2 + phi/w = x, computed without cancellation.
  const double q = constants.ductility, phi = constants.offset;
  const double reciprocal = 2.0 * x / (phi + std::sqrt(phi * phi + 4.0 * q * x));
  if (!(reciprocal > 0.0 && std::isfinite(reciprocal)))
    refuse_winters("found constants with which no strength gives the rate");
  return run.weight * reciprocal / (run.diameter * run.diameter);
}

double winters_exponent(const WintersConstants& constants, double w) {
  const WintersTerms t = winters_terms(constants, w);
  return (2.0 * t.ductility + t.offset) / t.sum();
}

WintersFit fit_winters(const std::vector<WintersPoint>& points,
                       std::optional<double> teeth_and_cleaning) {
  const Eigen::Index unknowns = teeth_and_cleaning ? 2 : 3;
  if (static_cast<Eigen::Index>(points.size()) < unknowns)
    refuse_winters("found " + std::to_string(points.size()) + " rates, expected at least " +
                   std::to_string(unknowns));
  const Eigen::MatrixXd rows = winters_rows(points);
  Eigen::VectorXd right = Eigen::VectorXd::Ones(rows.rows());
  if (teeth_and_cleaning) right -= *teeth_and_cleaning * rows.col(2);
  const Eigen::VectorXd scale = rows.leftCols(unknowns).colwise().norm().transpose();
  const Eigen::MatrixXd scaled = rows.leftCols(unknowns) * scale.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const double smallest = svd.singularValues()(unknowns - 1), largest = svd.singularValues()(0);
  if (smallest <= least_winters_condition * largest)
    refuse_winters("found rates at too few different weights over strength, expected " +
                   std::to_string(unknowns) + " different W/(sigma D^2)");
  const Eigen::VectorXd x = svd.solve(right);
  WintersFit fit{
      .condition = largest / smallest,
      .residual = (scaled * x - right).norm() / std::sqrt(static_cast<double>(points.size()))};
  fit.constants = {.ductility = x(0) / scale(0),
                   .offset = x(1) / scale(1),
                   .teeth = teeth_and_cleaning.value_or(
                       unknowns == 3 ? x(unknowns - 1) / scale(unknowns - 1) : 0.0)};
  return fit;
}

}  // namespace tdbd::reference
