#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "simulation/checkpoint/checkpoint.hpp"
#include "simulation/checkpoint/row_log.hpp"
#include "simulation/result/output_folder.hpp"

namespace tdbd::simulation {

/// Writes a run's checkpoints and keeps the last two. A checkpoint that cannot be written is warned
/// of once; the run goes on, and the last good one stays.
class CheckpointKeeper {
 public:
  using Warn = std::function<void(const std::string&)>;

  /// every: steps between checkpoints; 0: none; negative: as often as costs less than 1 % of the
  /// time.
  CheckpointKeeper(OutputFolder folder, long every, Warn warn);

  /// Begins the log of the history's rows; the first `kept` are there.
  void begin_rows(std::size_t width, long kept);
  RowLog* rows() { return log_ ? &*log_ : nullptr; }
  void append(std::span<const double> row);

  bool is_due(long steps_done) const;
  void keep(const Case& c, const Simulation& s, const WrittenSoFar& written);

  /// Once the run is complete.
  void remove();

 private:
  void replace(const Case& c, const Simulation& s, const WrittenSoFar& written) const;
  template <class Do>
  void attempt(Do&& act);

  using Clock = std::chrono::steady_clock;
  OutputFolder folder_;
  long every_;
  Warn warn_;
  std::optional<RowLog> log_;
  Clock::time_point last_ = Clock::now();
  std::chrono::duration<double> cost_{0.1};  ///< of one, s
  bool has_failed_ = false;
};

/// Removes a folder's checkpoints and the log of its rows.
void remove_checkpoints(const OutputFolder& folder);

/// The newest checkpoint of a folder that can be read; none: there is no file of one. Calls
/// `warn` for a torn one that an older one stands in for. Throws InputError if none can be read, or
/// they are of another case or another version of tdbd.
std::optional<Checkpoint> newest_checkpoint(const OutputFolder& folder, const Case& c,
                                            const CheckpointKeeper::Warn& warn);

}  // namespace tdbd::simulation
