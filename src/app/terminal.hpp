#pragma once

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <string>
#include <utility>

namespace tdbd::app {

/// Exit code of an interrupted command: 128 + SIGINT, the convention of shells.
inline constexpr int interrupted_code = 130;

/// Makes SIGINT (Ctrl-C), SIGTERM and SIGHUP end the program immediately, while there is nothing to
/// save.
void end_on_interrupt();

/// Makes the first of these signals set the returned flag, so that results can be saved. A second
/// signal ends the program immediately.
const std::atomic<bool>& save_on_interrupt();

/// The flag set by save_on_interrupt.
const std::atomic<bool>& interrupt_flag();

/// Writes to standard output. A failure does not end the command, whose files are more important;
/// after_output reports it.
void write_out(const std::string& text);

template <class... T>
void print_out(fmt::format_string<T...> text, T&&... values) {
  write_out(fmt::format(text, std::forward<T>(values)...));
}

/// The final exit code of a command: 1, with a message, if its output could not be written. A pipe
/// closed by its reader is not a failure.
int after_output(int exit_code);

/// Progress on standard error: a bar with the remaining time on a terminal, otherwise a line every
/// two seconds. The remaining time follows from the steps since the first call of is_due, so that
/// neither the preparation of a run nor the steps before it was resumed count; it is omitted until
/// enough of them are done.
class Progress {
 public:
  Progress();
  /// Whether to show the progress again; always true at the end.
  bool is_due(long done, long total);
  /// Shows the progress and the remaining time, followed by `detail`.
  void show(long done, long total, const std::string& detail);
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::string time_left(long done, long total) const;

  Clock::time_point started_, shown_;
  long first_ = -1;  ///< steps done at started_; -1: is_due was not called yet
  bool terminal_ = false;
};

}  // namespace tdbd::app
