#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "io/output_folder.hpp"
#include "sweep/point/run_point.hpp"

namespace tdbd::sweep {

/// A point as stored in a journal.
struct PointRecord {
  PointOutcome outcome;
  double seconds = 0.0;  ///< wall time
};

/// Points by key (point_keys).
using PointRecords = std::map<std::string, PointRecord>;

/// The points that one process adds to FOLDER/I-of-N/points.jsonl, each as a line with a hash of
/// its bytes. A process that is killed leaves at most one incomplete line, at the end, which the
/// next process to write there removes.
class Journal {
 public:
  /// Locks the folder, and creates it if it is missing. Throws InputError if another process writes
  /// there, RunError if it cannot be written.
  explicit Journal(const std::filesystem::path& folder);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Appends one whole line or nothing. Throws RunError.
  void add(const std::string& key, const PointRecord& record);

  /// A folder to which no other process writes during the lifetime of this object.
  std::filesystem::path folder() const { return file_.parent_path(); }

 private:
  std::filesystem::path file_;
  FolderLock lock_;
  int descriptor_ = -1;
};

/// Reads the points of all journals below a folder, by any process. An incomplete last line is
/// ignored. Throws RunError with the file and line of any other line that is incomplete or was
/// changed.
PointRecords read_journals(const std::filesystem::path& folder);

}  // namespace tdbd::sweep
