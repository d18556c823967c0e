#pragma once

#include <map>
#include <string>
#include <vector>

#include "calibration/laboratory/laboratory.hpp"
#include "calibration/result/calibrate.hpp"

/// The blind test of validation/blind in one process: a hidden law drills two bits, the calibration
/// fits them and predicts a third, and only then the hidden law drills that one.
namespace tdbd::claims {

/// Two bits that are fitted and the one that is not.
struct Pairing {
  std::string name;  ///< in the names of the cases: "bc-a"
  std::vector<std::string> fitted;
  std::string withheld;
};

const std::vector<Pairing>& pairings();

/// The true coefficients of a hidden law, SI.
std::map<std::string, double> truth_of(const std::string& law);

/// What is calibrated in a draw: the case lab-NAME + `suffix`, the fitted bits' readings under the
/// hidden law with the draw's noise, and the withheld bit's tests without readings.
calibration::CalibrationCase blind_case(const std::string& law, const Pairing& pairing,
                                        const std::string& suffix, int draw);

/// The calibrations of the draws 0 to count - 1; made once.
const std::vector<calibration::Calibration>& calibrated(const std::string& law,
                                                        const Pairing& pairing,
                                                        const std::string& suffix, int count);

/// How well the withheld bit was predicted.
struct Judged {
  std::vector<double> errors;  ///< computed over true load, less 1: both loads, all draws
  double coverage = 0.0;       ///< share of noisy readings inside their intervals
};

/// Drills the withheld bit, after all predictions of the draws were made.
Judged judged(const std::string& law, const Pairing& pairing, const std::string& suffix, int count);

}  // namespace tdbd::claims
