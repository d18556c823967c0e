#pragma once

#include <chrono>

#include "simulation/simulation.hpp"

namespace tdbd::app {

/// A bar with the time left on a terminal, a line every few seconds otherwise. Standard error.
class Progress {
 public:
  Progress();
  void show(const simulation::Simulation& s, long total);
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point started_, shown_;
  bool terminal_ = false;
};

}  // namespace tdbd::app
