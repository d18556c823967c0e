#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "io/archive.hpp"
#include "simulation/step/simulation.hpp"

/// Whether two runs have the same bits in all that a checkpoint keeps.
namespace tdbd::simulation {

/// All values of a run. In which order vertices were touched follows the index.
inline Archive values_of(Simulation s) {
  std::ranges::sort(s.state.rock.touched_list);
  ArchiveWriter write;
  write(s.state, s.statistics);
  return std::move(write).archive();
}

/// Compares bytes, so that a NaN equals itself.
inline void expect_same_run(const Simulation& a, const Simulation& b) {
  const Archive x = values_of(a), y = values_of(b);
  EXPECT_TRUE(x.bytes == y.bytes);
  EXPECT_EQ(x.layout, y.layout);
}

}  // namespace tdbd::simulation
