#pragma once

#include <ctime>

namespace tdbd::reference {

/// CPU time of this process since the clock was constructed, s.
class CpuClock {
 public:
  double seconds() const { return now() - from_; }

 private:
  static double now() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }
  double from_ = now();
};

}  // namespace tdbd::reference
