#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "io/archive.hpp"
#include "io/output_folder.hpp"
#include "io/record.hpp"

namespace tdbd {

/// Identifies the case of a checkpoint. Runs of other cases cannot be resumed from it.
struct CaseMark {
  std::string hash;  ///< Case::hash, RotateCase::hash
  std::string text;  ///< Case::resolved, RotateCase::resolved
};

/// Content of a checkpoint file, which has a seal (io/whole_file.hpp).
struct CheckpointFile {
  std::string version;  ///< of TDBD
  CaseMark of;
  Archive state;
};

/// Writes the file completely and forces it to the disk, or leaves no file. Throws RunError.
void write_checkpoint_file(const std::filesystem::path& path, const CheckpointFile& file);

/// Throws RunError if the file is not a checkpoint, is incomplete or was changed.
CheckpointFile read_checkpoint_file(const std::filesystem::path& path);

/// Returns the state in a checkpoint of this case and this version. Throws as read_checkpoint does.
Archive archive_of(const std::filesystem::path& path, const CaseMark& c);

/// Throws InputError with the message "checkpoint PATH: REASON".
[[noreturn]] void refuse_checkpoint(const std::filesystem::path& path, const std::string& reason);

/// Writes values as a checkpoint of a case. Throws RunError.
template <class... T>
void write_checkpoint(const std::filesystem::path& path, const CaseMark& c, const T&... values) {
  ArchiveWriter write;
  write(values...);
  write_checkpoint_file(path, {provenance().version, c, std::move(write).archive()});
}

/// Reads the values of a checkpoint. Throws RunError if the file cannot be read, is incomplete or
/// was changed. Throws InputError if another version of TDBD wrote it, if it contains other values,
/// or if it belongs to another case. If the case was changed, the message contains the first line
/// that differs.
template <class... T>
void read_checkpoint(const std::filesystem::path& path, const CaseMark& c, T&... values) {
  const Archive archive = archive_of(path, c);
  try {
    ArchiveReader read(archive.bytes);
    read(values...);
    read.require_end(archive.layout);
  } catch (const RunError& e) {
    refuse_checkpoint(path, e.what());
  }
}

/// The record to which rows belong.
enum class RowsOf {
  history,
  profiles,  ///< of a string on a chain
};

/// Writes the checkpoints of a run and keeps the last two. If a checkpoint cannot be written, warns
/// once; the run continues, and the last good checkpoint is kept.
class CheckpointKeeper {
 public:
  using Warn = std::function<void(const std::string&)>;
  /// Writes a complete checkpoint to this path, or throws.
  using Write = std::function<void(const std::filesystem::path&)>;

  /// `every`: steps between checkpoints. 0: no checkpoints; negative: as often as takes less than
  /// 1 % of the run time.
  CheckpointKeeper(OutputFolder folder, long every, Warn warn);

  /// Starts the log of a record's rows, of which the first `kept` exist. Must be called for the
  /// history first.
  void begin_rows(std::size_t width, long kept, RowsOf of = RowsOf::history);
  /// Returns null if no more checkpoints will be written.
  RowLog* rows(RowsOf of = RowsOf::history);
  void append(std::span<const double> row, RowsOf of = RowsOf::history);

  bool is_due(long steps_done) const;
  void keep(const Write& write);

  /// Removes the checkpoints. To be called when the run is complete.
  void remove();

 private:
  void replace(const Write& write) const;
  template <class Do>
  void attempt(Do&& act);
  template <class Do>
  void log_or_end(Do&& act);
  std::optional<RowLog>& log_of(RowsOf of) { return of == RowsOf::history ? log_ : profiles_; }
  void end_logs();

  using Clock = std::chrono::steady_clock;
  OutputFolder folder_;
  long every_;
  Warn warn_;
  std::optional<RowLog> log_, profiles_;
  Clock::time_point last_ = Clock::now();
  std::chrono::duration<double> cost_{0.1};  ///< run time of one checkpoint, s
  bool has_failed_ = false;
};

/// Removes the checkpoints of a folder and the logs of its rows.
void remove_checkpoints(const OutputFolder& folder);

/// Removes all checkpoints of a folder but the newest, and keeps the logs of its rows, so that a
/// complete run can continue to a later end.
void keep_newest_checkpoint(const OutputFolder& folder);

/// Reads the newest readable checkpoint of a folder. `read` returns the number of completed steps,
/// and throws RunError if the file is incomplete. Returns false if there is no checkpoint. Calls
/// `warn` if the newest one is incomplete and an older one is used. Throws InputError if none can
/// be read, and whatever `read` throws.
bool read_newest_checkpoint(const OutputFolder& folder,
                            const std::function<long(const std::filesystem::path&)>& read,
                            const CheckpointKeeper::Warn& warn);

}  // namespace tdbd
