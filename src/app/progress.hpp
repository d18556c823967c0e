#pragma once

#include <chrono>
#include <string>

namespace tdbd::app {

/// A bar with the time left on a terminal, a line every few seconds otherwise. Standard error.
class Progress {
 public:
  Progress();
  /// Whether it is time to show something: after a while, and at the end.
  bool is_due(long done, long total) const;
  /// Shows how much is done, the time left, and `detail` behind them.
  void show(long done, long total, const std::string& detail);
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point started_, shown_;
  bool terminal_ = false;
};

}  // namespace tdbd::app
