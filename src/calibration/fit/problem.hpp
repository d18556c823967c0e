#pragma once

#include <Eigen/Dense>
#include <array>
#include <map>
#include <span>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_run.hpp"
#include "calibration/cuts/cut_store.hpp"
#include "calibration/record/record.hpp"
#include "forces/law.hpp"

namespace tdbd::calibration {

/// The data from which the loads of one record are computed.
struct Sample {
  std::vector<forces::PartCut> cuts;  ///< of parts that use the law of the cutters
  std::vector<int> mix;               ///< mix of each cut (AreaLaws); empty: all 0
  Loads others{};                     ///< N and N m (cutter: N), of parts with their own laws
};

/// The mean cuts of a record's tool at its speed, in rock of this strength. The frame is that of
/// the tool. `mix_of_part` has one entry per part of the tool; empty: all 0.
Sample sample_of(const CutRun& run, const Record& record, const forces::Strength& strength,
                 const forces::Law& law, std::span<const int> mix_of_part = {});

/// A law, or one per mix of coefficients (AreaLaws).
using Laws = std::span<const forces::Law>;

/// Mean loads, calibration (1): the law is evaluated once for the mean cut of each part. Does not
/// allocate.
Loads mean_loads(Laws laws, const Sample& sample);
inline Loads mean_loads(const forces::Law& law, const Sample& sample) {
  return mean_loads(Laws(&law, 1), sample);
}

/// Flags for kinds of part, indexed by PartKind.
using Kinds = std::array<bool, bit::part_kinds.size()>;

/// Contribution to the mean loads of the parts of some kinds under the law.
Loads loads_of(Laws laws, const Sample& sample, const Kinds& kinds);

/// d log load / d log depth of each load: areas grow with the depth, edges and contacts are
/// constant. 0 if there is no load.
Loads depth_slopes(Laws laws, const Sample& sample);
inline Loads depth_slopes(const forces::Law& law, const Sample& sample) {
  return depth_slopes(Laws(&law, 1), sample);
}

/// The load and sample of a residual.
struct ReadingPlace {
  std::size_t sample = 0, load = axial;
};

/// Readings of one test, whose errors are correlated: rows first to first + size of the factor.
struct TestBlock {
  Eigen::Index first = 0;
  Eigen::MatrixXd factor;  ///< lower Cholesky factor of their covariance
};

/// A least-squares problem, calibration (3). Residuals are logarithms of the ratio of computed to
/// measured loads, whitened test by test, and one row per prior.
struct Problem {
  forces::Law law;                ///< with its fixed coefficients
  std::vector<Unknown> unknowns;  ///< the fitted coefficients
  std::vector<Sample> samples;    ///< one per record
  std::vector<Record> records;
  std::vector<ReadingPlace> places;  ///< in the order of the residuals, test by test
  std::vector<TestBlock> blocks;
  AreaLaws areas = {};  ///< parts with their own coefficients

  std::size_t readings() const { return places.size(); }
  Eigen::Index rows() const;  ///< number of readings and priors
};

/// Data of a fit; each replicate of a bootstrap has its own.
struct Data {
  Eigen::VectorXd log_loads;      ///< of the readings
  Eigen::VectorXd prior_centres;  ///< of all unknowns; ignored without a prior
};

/// The problem for these records. The relative errors of a reading are its own (Noise::reading, or
/// the deviation of its row), that of the rate times the slope of the load over the depth, which is
/// common to the loads of a record, and a factor common to all readings of a test. Slopes are
/// evaluated at the starting values.
Problem problem_of(const CalibrationCase& c, const CutStore& cuts,
                   const std::vector<Record>& records);

/// The data of the readings.
Data data_of(const Problem& problem);

/// The law of parts outside of all areas for these values of the unknowns.
forces::Law law_at(const Problem& problem, const Eigen::VectorXd& values);

/// The areas for these values of their unknowns.
AreaLaws areas_at(const Problem& problem, const Eigen::VectorXd& values);

/// The law of every mix of coefficients for these values.
std::vector<forces::Law> laws_at(const Problem& problem, const Eigen::VectorXd& values);

/// The cuts of a record with the coefficients of its parts.
Sample sample_of(const CalibrationCase& c, const CutStore& cuts, const Record& record);

/// Logarithms of the computed loads, in the order of the readings. Loads that are not positive are
/// replaced by 1e-300.
Eigen::VectorXd log_loads(const Problem& problem, Laws laws);
inline Eigen::VectorXd log_loads(const Problem& problem, const forces::Law& law) {
  return log_loads(problem, Laws(&law, 1));
}

/// Whitens residuals of the readings in place.
void whiten(const Problem& problem, Eigen::Ref<Eigen::VectorXd> residuals);

/// All rows: the whitened readings, then (value - centre)/prior_sd of each prior.
Eigen::VectorXd residuals_at(const Problem& problem, const Data& data,
                             const Eigen::VectorXd& values);

/// Residuals if one unknown changes and the others do not. Parts that it does not affect are
/// evaluated only once, which reduces the run time of derivatives.
class SingleChange {
 public:
  SingleChange(const Problem& problem, const Eigen::VectorXd& values);
  /// Rows without data (whitened logarithms of the loads) for this value of unknown k.
  Eigen::VectorXd residuals(Eigen::Index k, double value);

 private:
  const std::vector<Loads>& rest_of(const Kinds& moved);

  const Problem& problem_;
  Eigen::VectorXd values_;
  std::vector<Kinds> kinds_;                   ///< kinds of part that each unknown affects
  std::map<Kinds, std::vector<Loads>> rests_;  ///< loads of the samples without those kinds
};

/// Central differences, or one-sided ones with half the run time and half the digits.
enum class Difference { central, one_sided };

/// Derivatives of the rows with respect to the values, by differences inside the ranges.
Eigen::MatrixXd jacobian_at(const Problem& problem, const Eigen::VectorXd& values,
                            Difference difference = Difference::central);

/// Relative variance of a reading: its own, that of the rate and that of the test.
double reading_variance(const Noise& noise, const Reading& reading, double slope);

}  // namespace tdbd::calibration
