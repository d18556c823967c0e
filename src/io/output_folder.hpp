#pragma once

#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/config/number_doubts.hpp"  // resolved_head, the first line of case.toml

namespace tdbd {

/// Locks a folder for one writer. The kernel releases the lock when the object is destroyed or the
/// process ends for any reason.
class FolderLock {
 public:
  /// Throws FolderError "output folder PATH: in use ..." if another writer has locked it, RunError
  /// if it cannot be opened. File systems that do not support locks are not locked.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_ = -1;  ///< open while it is locked
};

/// Whether results may replace older ones.
enum class Overwrite { no, force };

/// The kind of result, which determines the names of its files: a run (with pictures of its steps
/// in the folder `frames`), the rotation of a body, a drill string alone, a convergence study, a
/// bit exported by `tdbd bit`.
enum class ResultKind { run, rotate, chain, convergence, bit };

/// Creates a folder and its parents. The destructor removes those that it created, if they are
/// empty.
class MadeFolders {
 public:
  /// Throws std::filesystem::filesystem_error.
  explicit MadeFolders(const std::filesystem::path& folder);
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< the innermost first
};

/// A result folder, ready to be written to.
struct OutputFolder {
  std::filesystem::path path;
  std::shared_ptr<const FolderLock> lock = nullptr;   ///< locked as long as a copy of this exists
  std::shared_ptr<const MadeFolders> made = nullptr;  ///< destroyed before the lock

  std::filesystem::path summary() const { return path / "summary.json"; }
  std::filesystem::path timing() const { return path / "timing.json"; }
  std::filesystem::path history() const { return path / "history.nc"; }
  std::filesystem::path checkpoint() const { return path / "checkpoint.bin"; }
  std::filesystem::path new_checkpoint() const { return path / "checkpoint-new.bin"; }
  std::filesystem::path previous_checkpoint() const { return path / "checkpoint-previous.bin"; }
  std::filesystem::path rows() const { return path / "history.rows"; }
  std::filesystem::path profiles() const { return path / "string.nc"; }
  std::filesystem::path profile_rows() const { return path / "string.rows"; }
  std::filesystem::path failure() const { return path / "failure.txt"; }
  std::filesystem::path frames() const { return path / "frames"; }

  /// Returns frames/NAME-000123.vtp.
  std::filesystem::path frame(const std::string& name, long number) const;
};

/// Creates `path` and all its parents and locks it. This is done before the case is prepared, which
/// may take minutes, so that only one command at a time writes to a folder. An older result is not
/// removed yet. Throws RunError if the folder cannot be opened. Throws FolderError without changing
/// anything if the folder is locked, is not empty although `overwrite` is no, or cannot be written
/// to; if it or its `frames` is a file; if a file to be replaced is one of `inputs`; or if it
/// contains such files but not the one that TDBD writes first (case.toml, convergence.json, or
/// bit.toml for a bit).
OutputFolder claim(const std::filesystem::path& path, Overwrite overwrite,
                   const std::vector<std::string>& inputs = {}, ResultKind kind = ResultKind::run);

/// Removes from a claimed folder every file that the command may write, so that no file of an older
/// result is mistaken for one of this result. Files with other names stay; of parts/, only files of
/// the previously exported bit are removed. Creates `frames` if the kind of result uses it. Throws
/// like `claim`.
void clear(const OutputFolder& folder, const std::vector<std::string>& inputs = {},
           ResultKind kind = ResultKind::run);

/// Calls claim and clear.
OutputFolder prepare(const std::filesystem::path& path, Overwrite overwrite,
                     const std::vector<std::string>& inputs = {},
                     ResultKind kind = ResultKind::run);

/// Throws FolderError if any of `files` in the folder is itself a folder or is one of `inputs`,
/// because these may not be replaced.
void demand_replaceable(const std::filesystem::path& folder,
                        const std::vector<std::filesystem::path>& files,
                        const std::vector<std::string>& inputs);

/// Throws FolderError if a file of this name exists that does not begin like one of TDBD's.
void demand_own(const std::filesystem::path& folder, const std::string& name);

/// Removes the files that an interrupted or failed run wrote at its end, because the run is being
/// resumed. Throws RunError.
void forget_end(const OutputFolder& folder);

/// Returns the existing mesh files of parts with which the bit in this folder was exported: those
/// in its bit.toml, or, for a roller cone bit, whose bit.toml contains none, the parts of its
/// solids.toml in every format in which all of them exist. TDBD did not write any other file in
/// parts/. Empty if these files are no longer TDBD's.
std::vector<std::filesystem::path> exported_parts(const std::filesystem::path& folder);

/// Removes the files, and folders inside parts/ that become empty.
void remove_parts(const std::filesystem::path& folder,
                  const std::vector<std::filesystem::path>& files);

/// Calls `write` after a failure, and ignores a second failure (for example a full disk), because
/// the first one is the one to report.
template <class Write>
void ignore_failure(Write write) {
  try {
    write();
  } catch (const std::exception&) {
  }
}

}  // namespace tdbd
