#include "reference/literature/drag/drag_input.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace tdbd::reference::drag_input_test {
namespace {

TEST(DragInput, rejects_cones_by_the_models_name) {
  bit::Bit bit;
  bit.cones.resize(3);
  try {
    require_drag_bit("Glowka", bit);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "Glowka: found a bit with 3 cones, expected a drag bit: its cutters are fixed "
                 "to it");
  }
}

TEST(DragInput, rejects_cutters_without_a_size) {
  bit::Bit bit;
  EXPECT_THROW(require_drag_bit("Glowka", bit), InputError);
  bit.cutters.resize(1);
  EXPECT_THROW(require_drag_bit("Glowka", bit), InputError);
  bit.cutters[0].diameter = 13e-3;
  EXPECT_NO_THROW(require_drag_bit("Glowka", bit));
}

TEST(DragInput, takes_numbers_for_none_or_all) {
  EXPECT_NO_THROW(require_one_each("Glowka", "flats", 0, 5));
  EXPECT_NO_THROW(require_one_each("Glowka", "flats", 5, 5));
  EXPECT_THROW(require_one_each("Glowka", "flats", 4, 5), InputError);
}

}  // namespace
}  // namespace tdbd::reference::drag_input_test
