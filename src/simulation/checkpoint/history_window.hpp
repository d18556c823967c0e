#pragma once

#include <vector>

namespace tdbd::simulation {

/// The steps that the next row of a history stands for, as far as they were made. By number of a
/// row; empty before the first step.
struct HistoryWindow {
  long steps = 0;
  std::vector<double> sum, least, greatest;
};

}  // namespace tdbd::simulation
