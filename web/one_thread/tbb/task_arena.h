#pragma once

// What simulation/step takes from TBB, for programs that have one thread.

namespace tbb::this_task_arena {

/// No task waits, so none could be taken up meanwhile.
template <class Body>
void isolate(const Body& body) {
  body();
}

}  // namespace tbb::this_task_arena
