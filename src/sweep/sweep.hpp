#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sweep/table/table.hpp"

namespace tdbd::sweep {

/// Every n-th point, beginning with the i-th: shard i of n.
struct Shard {
  long i = 1, n = 1;
};

/// Options of a sweep.
struct SweepOptions {
  std::filesystem::path table;  ///< NAME.nc; its points are stored in NAME.points beside it
  Shard shard;
  int threads = 1;  ///< number of points that run at the same time
  const std::atomic<bool>* interrupted =
      nullptr;  ///< set by another thread: running points are abandoned
  std::function<void(long, long)> progress = {};  ///< points completed and in all, of this shard
  std::function<void(const std::string&)> warn =
      {};                         ///< a doubt about a number of the cases, before any point runs
  Keeping keeping = Keeping::on;  ///< affects the run time only
};

/// The result of a sweep.
struct SweepResult {
  long points = 0;    ///< of the design
  long of_shard = 0;  ///< of this shard
  long found = 0;     ///< completed before
  long failed = 0;    ///< among those completed
  long done = 0;      ///< of the design, by all shards
  long on_front = 0;
  bool interrupted = false;
  bool written = false;  ///< whether the table was written: all points of the design are completed
  std::string first_failure;
  long unsteady = 0;        ///< completed points that state that their means are not steady
  long without_values = 0;  ///< points that are done, with a figure that has no value (NaN)
  std::optional<FilterReport> filter;  ///< of a design with a filter, if the table was written
};

/// Runs the points of a shard that are in no journal, several at a time, each on one thread. Writes
/// the table once every point of the design is completed, by any shard. If the process is killed,
/// only the running points are lost, and another call resumes the sweep. Throws InputError and
/// RunError.
SweepResult run_sweep(const Design& d, const SweepOptions& options);

/// Runs a list of points, each the overrides of the design's case in place of its factors, like the
/// points of a shard: those of no journal beside `options.table`, several at a time, each on one
/// thread. Writes no table. Returns the records in the order of the list; a point that an
/// interruption prevented has none. Throws InputError and RunError.
std::vector<std::optional<PointRecord>> run_listed(
    const Design& d, const std::vector<std::vector<std::string>>& list,
    const SweepOptions& options);

/// Returns the keys that distinguish points: a hash of program, command, contents of all files,
/// figures and overrides.
std::vector<std::string> point_keys(const Design& d, const Points& points);

/// Returns NAME.points, beside NAME.nc.
std::filesystem::path points_folder(const std::filesystem::path& table);

}  // namespace tdbd::sweep
