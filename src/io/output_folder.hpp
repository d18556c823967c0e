#pragma once

#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tdbd {

/// Locks a folder for one writer. The kernel releases it when the object is destroyed or the
/// process ends, however it ends.
class FolderLock {
 public:
  /// Throws FolderError "output folder PATH: in use ..." when another writer has it, RunError when
  /// it cannot be opened. On a file system without locks nothing is locked.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_ = -1;  ///< open while it is held
};

/// Whether results may take the place of older ones.
enum class Overwrite { no, force };

/// The kind of result, which decides the names of its files: a run (with pictures of its steps in a
/// folder `frames`), a case to rotate, a drill string alone, a study of convergence, a bit as `tdbd
/// bit` exports it.
enum class ResultKind { run, rotate, chain, convergence, bit };

/// Makes a folder with its parents. The destructor removes those that it made and that are empty.
class MadeFolders {
 public:
  /// Throws std::filesystem::filesystem_error.
  explicit MadeFolders(const std::filesystem::path& folder);
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< from the innermost
};

/// A result folder, ready to be written to.
struct OutputFolder {
  std::filesystem::path path;
  std::shared_ptr<const FolderLock> lock = nullptr;   ///< as long as a copy of this lives
  std::shared_ptr<const MadeFolders> made = nullptr;  ///< goes before the lock

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

  /// frames/NAME-000123.vtp
  std::filesystem::path frame(const std::string& name, long number) const;
};

/// First line of the resolved case in a result folder: it distinguishes that folder's
/// case.toml from one that a user wrote.
inline constexpr const char* resolved_head =
    "# Resolved by tdbd: every default written out, in SI.";

/// Makes `path` with all parents and locks it, before a start that may take minutes: one command at
/// a time writes to a folder. An older result stays. Throws RunError when the folder cannot be
/// opened. Throws FolderError, and changes nothing, when it is locked; when it is not empty and
/// `overwrite` is no; when it or its `frames` is a file; when it cannot be written to; when a file
/// to be replaced is one of `inputs`; or when it holds such files without one that TDBD began it
/// with: case.toml or convergence.json, bit.toml for a bit.
OutputFolder claim(const std::filesystem::path& path, Overwrite overwrite,
                   const std::vector<std::string>& inputs = {}, ResultKind kind = ResultKind::run);

/// Removes from a claimed folder every file that the command may write (files of other names stay;
/// of parts/ those go that the bit before was exported with), so that nothing of an older result is
/// taken for a part of this one, and makes its `frames` when it has some. Throws like `claim`.
void clear(const OutputFolder& folder, const std::vector<std::string>& inputs = {},
           ResultKind kind = ResultKind::run);

/// Claims and clears.
OutputFolder prepare(const std::filesystem::path& path, Overwrite overwrite,
                     const std::vector<std::string>& inputs = {},
                     ResultKind kind = ResultKind::run);

/// Throws FolderError unless `files` of the folder may be replaced: one that is a folder, or one of
/// `inputs`, may not.
void demand_replaceable(const std::filesystem::path& folder,
                        const std::vector<std::filesystem::path>& files,
                        const std::vector<std::string>& inputs);

/// Throws FolderError when there is a file of this name, and not one that begins as TDBD's do.
void demand_own(const std::filesystem::path& folder, const std::string& name);

/// Removes what an interrupted or failed run wrote at its end: the run is resumed. Throws RunError.
void forget_end(const OutputFolder& folder);

/// The meshes of parts that the bit in this folder was exported with, as far as they exist: those
/// that its bit.toml names, and, of a roller cone bit, whose bit.toml names none, the parts of its
/// solids.toml in every format in which all of them exist. TDBD did not write any other file in
/// parts/. Empty where these files are no longer TDBD's.
std::vector<std::filesystem::path> exported_parts(const std::filesystem::path& folder);

/// Removes the files, and the folders below parts/ that this empties.
void remove_parts(const std::filesystem::path& folder,
                  const std::vector<std::filesystem::path>& files);

/// Writes what can still be written after a failure; a second failure (the disk is full) leaves the
/// rest unwritten, since the first one is the one to report.
template <class Write>
void ignore_failure(Write write) {
  try {
    write();
  } catch (const std::exception&) {
  }
}

}  // namespace tdbd
