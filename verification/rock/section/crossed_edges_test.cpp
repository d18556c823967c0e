#include "rock/section/crossed_edges.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <utility>

#include "verification/battery/generators.hpp"

namespace tdbd::rock::crossed_edges_test {

/// Emptied now and then, and far more than it has room for at first.
RC_GTEST_PROP(CrossedEdges, are_a_set_that_grows_and_is_emptied, ()) {
  CrossedEdges edges;
  for (int k = 0; k < 4; ++k) {
    const int count = *rc::gen::element(0, 10, 1000, 3000), vertices = *battery::integer(1, 2000);
    const auto seed = static_cast<unsigned>(*battery::integer(0, 1 << 20));
    std::set<std::pair<int, int>> expected;
    for (unsigned j = 0; j < static_cast<unsigned>(count); ++j) {
      const unsigned mixed = (seed + j) * 2654435761U;
      const int v = static_cast<int>(mixed >> 4U) % vertices, i = static_cast<int>(mixed % 200U);
      RC_ASSERT(edges.contains(v, i) == expected.contains({v, i}));
      RC_ASSERT(edges.add(v, i) == expected.insert({v, i}).second);
    }
    for (const auto& [v, i] : expected) RC_ASSERT(edges.contains(v, i));
    for (const auto& [v, i] : expected) RC_ASSERT(!edges.is_done(v));
    for (const auto& [v, i] : expected)
      if (i < 64 && v % 2 == 0) edges.mark_done(v);
    for (int v = 0; v < vertices; ++v) {
      const auto first = expected.lower_bound({v, 0});
      const bool has_low = first != expected.end() && first->first == v && first->second < 64;
      RC_ASSERT(edges.is_done(v) == (has_low && v % 2 == 0));
    }
    edges.clear();
    for (const auto& [v, i] : expected) RC_ASSERT(!edges.is_done(v) && !edges.contains(v, i));
  }
}

}  // namespace tdbd::rock::crossed_edges_test
