#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "simulation/checkpoint/state_fields.hpp"
#include "simulation/checkpoint/statistics_fields.hpp"

/// Whether two runs have the same bits in all that a checkpoint keeps.
namespace tdbd::simulation {

/// All numbers of a run. In which order vertices were touched follows the index.
inline Tape numbers_of(Simulation s) {
  std::ranges::sort(s.state.rock.touched_list);
  Tape tape;
  TapeWriter write(tape);
  write("state", s.state);
  write("statistics", s.statistics);
  return tape;
}

/// Compares bytes, so that a NaN equals itself.
template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline void expect_same_run(const Simulation& a, const Simulation& b) {
  const Tape x = numbers_of(a), y = numbers_of(b);
  EXPECT_TRUE(same_bytes(x.reals, y.reals));
  EXPECT_TRUE(same_bytes(x.wholes, y.wholes));
  EXPECT_TRUE(same_bytes(x.ints, y.ints));
  EXPECT_TRUE(same_bytes(x.bytes, y.bytes));
  EXPECT_EQ(x.names, y.names);
}

}  // namespace tdbd::simulation
