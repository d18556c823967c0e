#pragma once

#include <Eigen/Dense>
#include <map>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_store.hpp"
#include "calibration/fit/sample.hpp"

namespace tdbd::calibration {

/// Which load of which sample a residual belongs to.
struct ReadingPlace {
  std::size_t sample = 0, load = axial;
};

/// Readings of one test, whose errors belong together: rows first to first + size of the factor.
struct TestBlock {
  Eigen::Index first = 0;
  Eigen::MatrixXd factor;  ///< lower Cholesky factor of their covariance
};

/// A least-squares problem, calibration (3): residuals are logarithms of computed over measured
/// loads, whitened test by test, and one row for each prior.
struct Problem {
  forces::Law law;                ///< its fixed coefficients
  std::vector<Unknown> unknowns;  ///< what is free
  std::vector<Sample> samples;    ///< one per record
  std::vector<Record> records;
  std::vector<ReadingPlace> places;  ///< in the order of the residuals, test by test
  std::vector<TestBlock> blocks;
  AreaLaws areas = {};  ///< parts with coefficients of their own

  std::size_t readings() const { return places.size(); }
  Eigen::Index rows() const;  ///< readings and priors
};

/// What is fitted: another one for each replicate of a bootstrap.
struct Data {
  Eigen::VectorXd log_loads;      ///< of the readings
  Eigen::VectorXd prior_centres;  ///< of all unknowns; those without a prior do not count
};

/// The problem of these records. The errors of a reading, relative: its own (Noise::reading, or the
/// deviation of its row), the rate's times the slope of the load over the depth, shared by the loads
/// of a record, and a factor shared by a test. Slopes are those at the starts.
Problem problem_of(const CalibrationCase& c, const CutStore& cuts,
                   const std::vector<Record>& records);

/// The readings themselves.
Data data_of(const Problem& problem);

/// The law of parts in no area with these values of the unknowns.
forces::Law law_at(const Problem& problem, const Eigen::VectorXd& values);

/// The areas with these values of their unknowns.
AreaLaws areas_at(const Problem& problem, const Eigen::VectorXd& values);

/// The law of every mix of coefficients with these values.
std::vector<forces::Law> laws_at(const Problem& problem, const Eigen::VectorXd& values);

/// The cuts of a record, with the coefficients that its parts have.
Sample sample_of(const CalibrationCase& c, const CutStore& cuts, const Record& record);

/// Logarithms of the computed loads, in the order of the readings. Loads that are not positive
/// count as 1e-300.
Eigen::VectorXd log_loads(const Problem& problem, Laws laws);
inline Eigen::VectorXd log_loads(const Problem& problem, const forces::Law& law) {
  return log_loads(problem, Laws(&law, 1));
}

/// Whitens residuals of the readings in place.
void whiten(const Problem& problem, Eigen::Ref<Eigen::VectorXd> residuals);

/// All rows, whitened readings first, then (value - centre)/prior_sd of each prior.
Eigen::VectorXd residuals_at(const Problem& problem, const Data& data,
                             const Eigen::VectorXd& values);

/// Residuals where one unknown moves and the others stay. Parts on which it does not act are
/// evaluated once, so that a derivative costs what the coefficient acts on.
class OneMoves {
 public:
  OneMoves(const Problem& problem, const Eigen::VectorXd& values);
  /// Rows without data (logarithms of the loads, whitened), with this value of unknown k.
  Eigen::VectorXd residuals(Eigen::Index k, double value);

 private:
  const std::vector<Loads>& rest_of(const Kinds& moved);

  const Problem& problem_;
  Eigen::VectorXd values_;
  std::vector<Kinds> kinds_;                   ///< on which each unknown acts
  std::map<Kinds, std::vector<Loads>> rests_;  ///< loads of the samples without those kinds
};

/// Central differences, or one-sided ones for half the price and half the digits.
enum class Difference { central, one_sided };

/// Their derivatives with respect to the values, by differences inside the ranges.
Eigen::MatrixXd jacobian_at(const Problem& problem, const Eigen::VectorXd& values,
                            Difference difference = Difference::central);

/// Relative variance of a reading: own, rate's and test's.
double reading_variance(const Noise& noise, const Reading& reading, double slope);

}  // namespace tdbd::calibration
