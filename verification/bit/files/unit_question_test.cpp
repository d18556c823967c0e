#include "bit/files/unit_question.hpp"

#include <gtest/gtest.h>

namespace tdbd::bit::unit_question_test {
namespace {

/// The sizes at the ends of the range are still usual.
TEST(UnitQuestion, is_none_of_a_usual_size) {
  for (const double size : {0.02, 0.2, 1.2}) EXPECT_EQ(unit_question(size, 1.0, bit_across), "");
  EXPECT_NE(unit_question(0.0199, 1.0, bit_across), "");
  EXPECT_NE(unit_question(1.201, 1.0, bit_across), "");
}

/// Each unit in which the size would be usual, with that size.
TEST(UnitQuestion, asks_for_every_unit_that_would_fit) {
  EXPECT_EQ(unit_question(215.9, 1.0, bit_across),
            "a size of 215900 mm, where a bit has 20 to 1200 mm: is it in mm (unit = \"1 mm\": "
            "215.9 mm)?");
  EXPECT_EQ(unit_question(8.5e-3, 1e-3, bit_across),
            "a size of 8.5 mm, where a bit has 20 to 1200 mm: is it in cm (unit = \"1 cm\": 85 "
            "mm), in in (unit = \"1 in\": 215.9 mm)?");
  EXPECT_EQ(unit_question(0.2e-3, 1e-3, bit_across),
            "a size of 0.2 mm, where a bit has 20 to 1200 mm: is it in m (unit = \"1 m\": 200 "
            "mm)?");
  EXPECT_EQ(unit_question(1e9, 1.0, bit_across),
            "a size of 1e+12 mm, where a bit has 20 to 1200 mm: in what unit is it?");
}

/// In a unit of 25.4 mm, ends that the other unit just reaches count.
TEST(UnitQuestion, takes_a_unit_up_to_the_ends_of_the_range) {
  const SizeRange thing{"a thing", 0.25, 2.0};
  EXPECT_NE(unit_question(0.25e-3, 1e-3, thing).find("in m (unit = \"1 m\": 250 mm)"),
            std::string::npos);
  EXPECT_NE(unit_question(2e-3, 1e-3, thing).find("in m (unit = \"1 m\": 2000 mm)"),
            std::string::npos);
  EXPECT_EQ(unit_question(2.1e-3, 1e-3, thing),
            "a size of 2.1 mm, where a thing has 250 to 2000 mm: in what unit is it?");
}

}  // namespace
}  // namespace tdbd::bit::unit_question_test
