#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "simulation/checkpoint/row_log.hpp"
#include "simulation/result/output_folder.hpp"

namespace tdbd::simulation {

/// Which record rows are of.
enum class RowsOf {
  history,
  profiles,  ///< of a string on a chain
};

/// Writes a run's checkpoints and keeps the last two. A checkpoint that cannot be written is warned
/// of once; the run goes on, and the last good one stays.
class CheckpointKeeper {
 public:
  using Warn = std::function<void(const std::string&)>;
  /// Writes a checkpoint to this path, complete, or throws.
  using Write = std::function<void(const std::filesystem::path&)>;

  /// every: steps between checkpoints; 0: none; negative: as often as costs less than 1 % of the
  /// time.
  CheckpointKeeper(OutputFolder folder, long every, Warn warn);

  /// Begins the log of a record's rows; the first `kept` are there. Those of the history come first.
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

/// Reads the newest checkpoint of a folder that can be read: `read` returns the steps that it has behind it, and throws
/// RunError for a torn one. False: there is no file of one. Calls `warn` for a torn one that an older one stands in for.
/// Throws InputError if none can be read, and what `read` throws.
bool read_newest_checkpoint(const OutputFolder& folder,
                            const std::function<long(const std::filesystem::path&)>& read,
                            const CheckpointKeeper::Warn& warn);

}  // namespace tdbd::simulation
