#pragma once

#include <string>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_store.hpp"

namespace tdbd::calibration {

/// A synthetic laboratory: a law with known coefficients drills bits, and noise is added. For
/// blind tests of a calibration, and to plan real ones: which tests would identify what. Ours.
struct LaboratoryCase {
  CalibrationCase setup;  ///< its law is the truth; its records have no readings yet
  std::uint64_t seed = 1;
};

/// Reads [laboratory], [truth], [bits], [rock], [time] and [noise]. Throws InputError.
LaboratoryCase read_laboratory(const std::string& path, const std::vector<std::string>& overrides);

/// Reads the records with their noise: each load its own, the rate of penetration as it was really
/// held (the record shows the rate that was asked for), and one factor a test. The same seed gives
/// the same records.
std::vector<Record> drill(const LaboratoryCase& c, const CutStore& cuts);

/// The records as read_records reads them, SI.
std::string records_csv(const std::vector<Record>& records);

}  // namespace tdbd::calibration
