#pragma once

#include <tbb/parallel_for.h>

namespace tdbd {

/// Calls body(i) for 0 <= i < n, in any order and on as many threads as the process allows
/// (tbb::global_control). Deterministic when each call writes only what belongs to its own i.
template <class Body>
void parallel_for(int n, Body&& body) {
  tbb::parallel_for(tbb::blocked_range<int>(0, n), [&](const tbb::blocked_range<int>& range) {
    for (int i = range.begin(); i != range.end(); ++i) body(i);
  });
}

}  // namespace tdbd
