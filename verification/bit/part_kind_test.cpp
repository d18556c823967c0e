#include "bit/part_kind.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tdbd::bit::part_kind_test {

TEST(PartKinds, have_one_name_in_three_spellings) {
  EXPECT_EQ(kind_words(PartKind::cutter_body), "cutter body");
  EXPECT_EQ(kind_name(PartKind::cutter_body), "cutter-body");
  EXPECT_EQ(kind_key(PartKind::cutter_body), "cutter_body");
  EXPECT_EQ(kind_name(PartKind::face), kind_key(PartKind::face));
}

TEST(PartKinds, are_all_in_the_list_in_order_under_names_of_their_own) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < part_kinds.size(); ++k) {
    EXPECT_EQ(static_cast<std::size_t>(part_kinds[k]), k);
    names.insert(kind_name(part_kinds[k]));
  }
  EXPECT_EQ(names.size(), part_kinds.size());
  EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace tdbd::bit::part_kind_test
