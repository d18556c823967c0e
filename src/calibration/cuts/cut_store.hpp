#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "calibration/cuts/cut_run.hpp"

namespace tdbd::calibration {

/// Writes a cut run as NetCDF: one row per part of the bit that touches rock, all columns with
/// units. The file is written completely or not at all, and sealed (io/whole_file.hpp). `names` are
/// those of the bit's parts. Throws RunError.
void write_cut_run(const std::filesystem::path& file, const CutRun& run,
                   const std::vector<std::string>& names);

/// Reads a cut run, bitwise as it was written. Returns nothing if the file does not exist or is
/// incomplete, if another commit wrote it, or if the program was built after it.
std::optional<CutRun> read_cut_run(const std::filesystem::path& file);

/// The cut runs of a calibration, by tool and depth.
struct CutStore {
  std::map<std::pair<std::string, double>, CutRun> runs;
  std::vector<std::filesystem::path> files;  ///< of bits, each once, in the order of `runs`
  long made = 0, found = 0;                  ///< number of cut runs of bits
};

/// The cut run of a record.
const CutRun& cut_run_of(const CutStore& store, const Record& record);

/// Provides all cut runs that the records of a case need. Those of bits are stored in `folder` as
/// cuts-HASH.nc, where HASH is the hash of bit, grid and depth. Runs that are missing or from
/// another program are computed, on as many threads as ThreadLimit permits. `progress` is called
/// with the number of computed runs and the total. Throws InputError and RunError.
CutStore find_cuts(const CalibrationCase& c, const std::filesystem::path& folder,
                   const std::function<void(long, long)>& progress = {});

}  // namespace tdbd::calibration
