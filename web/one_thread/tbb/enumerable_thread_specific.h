#pragma once

namespace tbb {

/// Of the one thread.
template <class Room>
class enumerable_thread_specific {
 public:
  Room& local() { return room_; }

 private:
  Room room_{};
};

}  // namespace tbb
