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

/// The case that a checkpoint belongs to: a run of another case is not resumed from it.
struct CaseMark {
  std::string hash;  ///< Case::hash, RotateCase::hash
  std::string text;  ///< Case::resolved, RotateCase::resolved
};

/// Content of a checkpoint's file, which has a seal (io/whole_file.hpp).
struct CheckpointFile {
  std::string version;  ///< of tdbd
  CaseMark of;
  Archive state;
};

/// Writes it complete and forced to the disk, or not at all. Throws RunError.
void write_checkpoint_file(const std::filesystem::path& path, const CheckpointFile& file);

/// Throws RunError if the file is not a checkpoint, is torn or was changed.
CheckpointFile read_checkpoint_file(const std::filesystem::path& path);

/// The state of a checkpoint of this case and this version. Throws as read_checkpoint does.
Archive archive_of(const std::filesystem::path& path, const CaseMark& c);

/// "checkpoint PATH: REASON".
[[noreturn]] void refuse_checkpoint(const std::filesystem::path& path, const std::string& reason);

/// Writes values as the checkpoint of a case. Throws RunError.
template <class... T>
void write_checkpoint(const std::filesystem::path& path, const CaseMark& c, const T&... values) {
  ArchiveWriter write;
  write(values...);
  write_checkpoint_file(path, {provenance().version, c, std::move(write).archive()});
}

/// Reads them. Throws RunError if the file cannot be read, is torn or was changed, and InputError if
/// another version of tdbd wrote it, if it has other values, or if it belongs to another case: of a
/// case that changed since, the message names the first line that did.
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

/// Which record rows are of.
enum class RowsOf {
  history,
  profiles,  ///< of a string on a chain
};

/// Writes a run's checkpoints and keeps the last two. Warns once of a checkpoint that cannot be
/// written; the run continues, and the last good one stays.
class CheckpointKeeper {
 public:
  using Warn = std::function<void(const std::string&)>;
  /// Writes a checkpoint to this path, complete, or throws.
  using Write = std::function<void(const std::filesystem::path&)>;

  /// every: steps between checkpoints; 0: none; negative: as often as takes less than 1 % of the
  /// time.
  CheckpointKeeper(OutputFolder folder, long every, Warn warn);

  /// Begins the log of a record's rows; the first `kept` exist. The history's comes first.
  void begin_rows(std::size_t width, long kept, RowsOf of = RowsOf::history);
  /// None where no checkpoint follows.
  RowLog* rows(RowsOf of = RowsOf::history);
  void append(std::span<const double> row, RowsOf of = RowsOf::history);

  bool is_due(long steps_done) const;
  void keep(const Write& write);

  /// Once the run is complete.
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
  std::chrono::duration<double> cost_{0.1};  ///< of one, s
  bool has_failed_ = false;
};

/// Removes a folder's checkpoints and the log of its rows.
void remove_checkpoints(const OutputFolder& folder);

/// Reads the newest checkpoint of a folder that can be read: `read` returns the number of steps that
/// were done, and throws RunError for a torn file. Returns false if there is no checkpoint. Calls
/// `warn` for a torn one that an older one replaces. Throws InputError if none can be read, and what
/// `read` throws.
bool read_newest_checkpoint(const OutputFolder& folder,
                            const std::function<long(const std::filesystem::path&)>& read,
                            const CheckpointKeeper::Warn& warn);

}  // namespace tdbd
