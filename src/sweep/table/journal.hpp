#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "io/output_folder.hpp"
#include "sweep/point/run_point.hpp"

namespace tdbd::sweep {

/// A point as a journal holds it.
struct PointRecord {
  PointOutcome outcome;
  double seconds = 0.0;  ///< of the clock on the wall
};

/// Points by their key (point_keys).
using PointRecords = std::map<std::string, PointRecord>;

/// The points that one process adds: a line each, sealed by a hash of its bytes, in
/// FOLDER/I-of-N/points.jsonl. A process that is killed leaves at most one torn line, at the end,
/// which the next one to write there cuts off.
class Journal {
 public:
  /// Takes the folder; makes it where it is missing. Throws InputError when another process writes
  /// there, RunError when it cannot be written.
  explicit Journal(const std::filesystem::path& folder);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Appends one line, all of it or nothing. Throws RunError.
  void add(const std::string& key, const PointRecord& record);

  /// Where no other process writes as long as this lives.
  std::filesystem::path folder() const { return file_.parent_path(); }

 private:
  std::filesystem::path file_;
  FolderLock lock_;
  int descriptor_ = -1;
};

/// All points of the journals below a folder, whoever wrote them. A torn last line is left out.
/// Throws RunError that names the file and line of any other line that is not as it was written.
PointRecords read_journals(const std::filesystem::path& folder);

}  // namespace tdbd::sweep
