#pragma once

#include <chrono>
#include <string>

namespace tdbd::app {

/// Progress on standard error: a bar with the remaining time on a terminal, otherwise a line every
/// two seconds.
class Progress {
 public:
  Progress();
  /// Whether to show the progress again; always true at the end.
  bool is_due(long done, long total) const;
  /// Shows the progress and the remaining time, followed by `detail`.
  void show(long done, long total, const std::string& detail);
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point started_, shown_;
  bool terminal_ = false;
};

}  // namespace tdbd::app
