#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "calibration/cuts/cut_store.hpp"
#include "io/output_folder.hpp"

namespace tdbd::calibration {

/// A synthetic laboratory: bits drill under a law with known coefficients, and noise is added. For
/// blind tests of a calibration, and to plan real tests: which of them identify what. An addition
/// of TDBD [+].
struct LaboratoryCase {
  CalibrationCase setup;  ///< its law is the true one; its records have no readings yet
  std::uint64_t seed = 1;
};

/// The tables of a synthetic laboratory that are not tables of a calibration, for `tdbd keys`.
std::vector<KeyTable> laboratory_tables();

/// Reads [laboratory], [truth], [bits], [rock], [time] and [noise]. Throws InputError.
LaboratoryCase read_laboratory(const std::string& path, const std::vector<std::string>& overrides);

/// Computes the records with their noise: an error of each load, an error of the actual rate of
/// penetration (the record contains the requested one), and one factor per test. The same seed
/// gives the same records.
std::vector<Record> drill(const LaboratoryCase& c, const CutStore& cuts);

/// The records in the format of read_records, SI.
std::string records_csv(const std::vector<Record>& records);

/// Options for the records of a laboratory.
struct LaboratoryOptions {
  std::filesystem::path file;  ///< output file, csv
  std::filesystem::path cuts;  ///< folder of cut runs; default: `cuts` next to the records
  Overwrite overwrite = Overwrite::no;
  int threads = 1;                                ///< has no effect on the records
  std::function<void(long, long)> progress = {};  ///< called with the number of computed cut runs
                                                  ///< and the total
};

/// Computes or finds the cut runs and writes the records. Throws InputError if the file must not be
/// written, RunError later.
void write_records(const LaboratoryCase& c, const LaboratoryOptions& options);

}  // namespace tdbd::calibration
