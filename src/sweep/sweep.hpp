#pragma once

#include <atomic>
#include <filesystem>
#include <functional>

#include "sweep/table/table.hpp"

namespace tdbd::sweep {

/// Every n-th point, beginning with the i-th: shard i of n.
struct Shard {
  long i = 1, n = 1;
};

/// How a sweep is carried out.
struct SweepOptions {
  std::filesystem::path table;  ///< NAME.nc; its points are kept in NAME.points beside it
  Shard shard;
  int threads = 1;  ///< points at a time
  const std::atomic<bool>* interrupted =
      nullptr;  ///< set from outside: points under way are given up
  std::function<void(long, long)> progress = {};  ///< points done and in all, of this shard
  Keeping keeping = Keeping::on;  ///< changes the time that a sweep takes, nothing else
};

/// What came of it.
struct SweepResult {
  long points = 0;    ///< of the design
  long of_shard = 0;  ///< of this shard
  long found = 0;     ///< done before
  long failed = 0;    ///< of those done
  long done = 0;      ///< of the design, by all shards
  long on_front = 0;
  bool interrupted = false;
  bool written = false;  ///< the table: all points of the design are done
  std::string first_failure;
};

/// Runs the points of a shard that no journal has, several at a time, each on one thread, and writes
/// the table once every point of the design is done, whoever did it. Killed anywhere it loses the
/// points under way, and goes on when it is called again. Throws InputError and RunError.
SweepResult run_sweep(const Design& d, const SweepOptions& options);

/// What tells points apart: program, command, content of all files, figures, overrides.
std::vector<std::string> point_keys(const Design& d, const Points& points);

/// NAME.points beside NAME.nc.
std::filesystem::path points_folder(const std::filesystem::path& table);

}  // namespace tdbd::sweep
