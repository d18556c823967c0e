#pragma once

#include <string>
#include <vector>

#include "calibration/fit/fit.hpp"
#include "core/random.hpp"
#include "forces/laws/hanson_hansen.hpp"

/// A laboratory that drills nothing: cut runs of three bits are made up by formulas, so that a test
/// of a fit takes milliseconds.
namespace tdbd::calibration {

/// A bit of cutters on a spiral; back rakes grow from the axis outwards.
struct MadeUpBit {
  std::string name;
  int cutters = 0;
  double diameter = 0.0;  ///< m
  double least_rake = 0.0, most_rake = 0.0;
  double chamfer = 0.0;  ///< m
};

/// Few blunt cutters (B), many that lean back (C), and one in between (A).
const std::vector<MadeUpBit>& made_up_bits();

CutRun made_up_run(const MadeUpBit& bit, double depth);

/// The hidden law of the laboratory.
forces::HansonHansen hidden_law();

/// A plan: tests of each bit at 3000 and 6000 psi, at four rates, without readings. B and C are
/// fitted, A is predicted; seven coefficients are free, without priors, and start elsewhere.
CalibrationCase made_up_case();

/// Only A1, A3, A5, A6 and pressure_share are free; A2 and A4 are the hidden law's.
CalibrationCase well_conditioned_case();

/// A case of these unknowns, one or all of them.
Unknown* unknown(CalibrationCase& c, const std::string& key);

/// The cuts that a case's records need.
CutStore made_up_cuts(const CalibrationCase& c);

/// Noise of readings, relative: own, and common to a test.
struct LaboratoryNoise {
  double reading = 0.0, test = 0.0;
};

/// Gives every record its loads under a law, with noise.
void read_loads(CalibrationCase& c, const CutStore& cuts, const forces::Law& law,
                const LaboratoryNoise& noise = {}, std::uint64_t seed = 1);

/// The case's law with coefficients drawn from the priors, within their ranges.
forces::Law drawn_from_priors(const CalibrationCase& c, Random& random);

/// The problem of the records of fit_bits.
Problem fitted_problem(const CalibrationCase& c, const CutStore& cuts);

/// The true values of a problem's unknowns.
Eigen::VectorXd truth_of(const Problem& p, forces::Law law);

/// Largest |a/b - 1|.
double relative_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace tdbd::calibration
