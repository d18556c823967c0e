#include <gtest/gtest.h>

#include "core/provenance.hpp"

namespace tdbd::hash_test {

// The published test values (Fowler, Noll and Vo; draft-eastlake-fnv).
TEST(Hash, gives_the_published_values) {
  EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325u);
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8u);
  EXPECT_EQ(fnv1a_hex("foobar"), "85944171f73967e8");
}

TEST(Hash, bytes_above_127_count_as_positive_numbers) {
  EXPECT_EQ(fnv1a("\xff"), (0xcbf29ce484222325u ^ 0xffu) * 0x100000001b3u);
}

}  // namespace tdbd::hash_test
