#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>

#include "python/src/bindings.hpp"

namespace tdbd::python {

/// Monitors a computation that runs without the GIL: calls the user's progress(done, total), and
/// detects Ctrl-C. An exception from either sets a flag, so that the computation can end regularly;
/// rethrow() throws it again.
class Watch {
 public:
  /// `progress` is a callable or None; throws TypeError otherwise. Requires the GIL.
  explicit Watch(py::object progress);
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Set after the first exception.
  const std::atomic<bool>& interrupted() const { return interrupted_; }

  /// To be called after every step, from any thread, without the GIL. Acquires the GIL ten times
  /// per second, and at the end.
  void look(long done, long total);

  /// Throws the stored exception, if there is one. Requires the GIL.
  void rethrow() const;

 private:
  using Clock = std::chrono::steady_clock;
  bool is_due(long done, long total);

  py::object progress_;
  std::atomic<bool> interrupted_{false};
  std::exception_ptr raised_;
  std::mutex clock_;  ///< cut runs of a calibration report from several threads
  Clock::time_point looked_ = Clock::now();
};

}  // namespace tdbd::python
