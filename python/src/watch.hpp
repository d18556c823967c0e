#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>

#include "python/src/bindings.hpp"

namespace tdbd::python {

/// Looks after a computation that runs without Python's lock: calls the user's progress(done, total), and notices Ctrl-C.
/// An exception that either of them raises sets a flag, so that the computation ends in good order; rethrow() passes it on.
class Watch {
 public:
  /// `progress`: a callable, or None; throws TypeError for anything else. With Python's lock held.
  explicit Watch(py::object progress);
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Set from the first exception on.
  const std::atomic<bool>& interrupted() const { return interrupted_; }

  /// Called after every step, from any thread, without Python's lock: takes it ten times a second, and at the end.
  void look(long done, long total);

  /// Throws the exception, if there was one. With Python's lock held.
  void rethrow() const;

 private:
  using Clock = std::chrono::steady_clock;
  bool is_due(long done, long total);

  py::object progress_;
  std::atomic<bool> interrupted_{false};
  std::exception_ptr raised_;
  std::mutex clock_;  ///< cut runs of a calibration tell from several threads
  Clock::time_point looked_ = Clock::now();
};

}  // namespace tdbd::python
