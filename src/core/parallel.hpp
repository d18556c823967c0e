#pragma once

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <cstddef>

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define TDBD_WATCHES_THREADS
#endif
#endif

#ifdef TDBD_WATCHES_THREADS
#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>
#endif

namespace tdbd {

/// Limits parallel loops to `threads` threads during its lifetime.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads)
      : limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}

 private:
  tbb::global_control limit_;
};

/// Buffers of parallel loops, reused between loops; local() is the buffer of the calling thread.
/// Results must not depend on their previous content.
template <class Scratch>
using PerThread = tbb::enumerable_thread_specific<Scratch>;

/// Calls body(i) for 0 <= i < n, in any order, on as many threads as ThreadLimit permits. The
/// result is deterministic if each call writes only to the data of its own i.
#ifdef TDBD_WATCHES_THREADS
// Under the thread sanitizer, the loop uses threads that the sanitizer can observe. The TBB of
// Debian is not instrumented, so the sanitizer would report every loop. A suppression for TBB would
// also hide errors in the loop bodies.
template <class Body>
void parallel_for(int n, Body&& body) {
  constexpr int threads = 4;
  std::atomic<int> next = 0;
  std::vector<std::jthread> running;
  for (int t = 0; t < std::min(n, threads); ++t)
    running.emplace_back([&] {
      for (int i = next++; i < n; i = next++) body(i);
    });
}
#else
template <class Body>
void parallel_for(int n, Body&& body) {
  tbb::parallel_for(tbb::blocked_range<int>(0, n), [&](const tbb::blocked_range<int>& range) {
    for (int i = range.begin(); i != range.end(); ++i) body(i);
  });
}
#endif

}  // namespace tdbd
