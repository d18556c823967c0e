#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "calibration/cuts/cut_run.hpp"

namespace tdbd::calibration {

/// The cut runs of a calibration, by tool and depth.
struct CutStore {
  std::map<std::pair<std::string, double>, CutRun> runs;
  std::vector<std::filesystem::path> files;  ///< of bits, each once, in the order of `runs`
  long made = 0, found = 0;                  ///< cut runs of bits
};

/// The cut run of a record.
const CutRun& cut_run_of(const CutStore& store, const Record& record);

/// All cut runs that the records of a case need. Those of bits lie in `folder` as cuts-HASH.nc, HASH
/// being that of the bit, the grid and the depth; what is missing or of another program is made
/// there, on as many threads as ThreadLimit allows. `progress` hears how many of how many are made.
/// Throws InputError and RunError.
CutStore find_cuts(const CalibrationCase& c, const std::filesystem::path& folder,
                   const std::function<void(long, long)>& progress = {});

}  // namespace tdbd::calibration
