#pragma once

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#include <optional>

namespace tdbd::bench {

/// A hardware counter of the processor for this program's own code (without the kernel), including
/// threads that start later. Many shared machines have none.
class Counter {
 public:
  /// `event`: PERF_COUNT_HW_...
  explicit Counter(std::uint64_t event) {
    perf_event_attr wish{};
    wish.size = sizeof wish;
    wish.type = PERF_TYPE_HARDWARE;
    wish.config = event;
    wish.inherit = 1;
    wish.exclude_kernel = 1;
    wish.exclude_hv = 1;
    file_ = static_cast<int>(syscall(SYS_perf_event_open, &wish, 0, -1, -1, 0));
  }
  ~Counter() {
    if (file_ >= 0) close(file_);
  }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  /// The count since the constructor. Nothing if the machine does not have this counter.
  std::optional<double> value() const {
    std::uint64_t n = 0;
    if (file_ < 0 || read(file_, &n, sizeof n) != sizeof n) return std::nullopt;
    return static_cast<double>(n);
  }

 private:
  int file_ = -1;
};

struct Counters {
  Counter instructions{PERF_COUNT_HW_INSTRUCTIONS};
  Counter cycles{PERF_COUNT_HW_CPU_CYCLES};
};

}  // namespace tdbd::bench
