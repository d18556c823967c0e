#pragma once

#include <string>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_store.hpp"

namespace tdbd::calibration {

/// A synthetic laboratory: bits drill under a law with known coefficients, and noise is added. For
/// blind tests of a calibration, and to plan real tests: which of them identify what. An addition
/// of TDBD [+].
struct LaboratoryCase {
  CalibrationCase setup;  ///< its law is the true one; its records have no readings yet
  std::uint64_t seed = 1;
};

/// Reads [laboratory], [truth], [bits], [rock], [time] and [noise]. Throws InputError.
LaboratoryCase read_laboratory(const std::string& path, const std::vector<std::string>& overrides);

/// Computes the records with their noise: an error of each load, an error of the actual rate of
/// penetration (the record contains the requested one), and one factor per test. The same seed
/// gives the same records.
std::vector<Record> drill(const LaboratoryCase& c, const CutStore& cuts);

/// The records in the format of read_records, SI.
std::string records_csv(const std::vector<Record>& records);

}  // namespace tdbd::calibration
