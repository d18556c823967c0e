#include "sweep/point/kept.hpp"

#include <gtest/gtest.h>

namespace tdbd::sweep::kept_test {

/// A store of numbers that counts how many were made.
struct Store {
  explicit Store(double most) : kept(most) {}

  int get(const std::string& key, int value, double weight = 1.0) {
    const auto make = [&] {
      ++made;
      return value;
    };
    return *kept.get(key, make, [&](int) { return weight; });
  }

  Kept<int> kept;
  int made = 0;
};

TEST(Kept, makes_a_value_once) {
  Store s(4.0);
  EXPECT_EQ(s.get("a", 1), 1);
  EXPECT_EQ(s.get("b", 2), 2);
  EXPECT_EQ(s.get("a", 3), 1);
  EXPECT_EQ(s.made, 2);
}

TEST(Kept, lets_the_oldest_go_that_weigh_too_much_together) {
  Store s(4.0);
  s.get("a", 1, 1.0);
  s.get("b", 2, 2.0);
  s.get("c", 3, 3.0);  // a and b go
  EXPECT_EQ(s.get("c", 0), 3);
  EXPECT_EQ(s.get("d", 4, 1.0), 4);  // all of 4.0 is used
  EXPECT_EQ(s.get("c", 0), 3);
  EXPECT_EQ(s.made, 4);
  EXPECT_EQ(s.get("b", 5, 1.0), 5);  // c goes
  EXPECT_EQ(s.get("d", 0), 4);
  EXPECT_EQ(s.get("c", 6, 1.0), 6);
}

TEST(Kept, does_not_keep_what_weighs_more_than_it_holds) {
  Store s(4.0);
  s.get("a", 1, 1.0);
  EXPECT_EQ(s.get("b", 2, 5.0), 2);
  EXPECT_EQ(s.get("b", 3, 5.0), 3);
  EXPECT_EQ(s.get("a", 4), 1);
}

TEST(Kept, does_not_keep_what_has_no_key) {
  Store s(4.0);
  EXPECT_EQ(s.get("", 1), 1);
  EXPECT_EQ(s.get("", 2), 2);
}

}  // namespace tdbd::sweep::kept_test
