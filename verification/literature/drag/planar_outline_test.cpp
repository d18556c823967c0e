#include "reference/literature/drag/planar_outline.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "bit/cutter/cutter_table.hpp"

namespace tdbd::reference::planar_outline_test {
namespace {

/// What is cut in a turn is the whole disc that the bit reaches, whatever its cutters' places.
TEST(PlanarOutline, cuts_a_whole_disc_in_a_turn) {
  const double advance = 3e-3, column = 0.01e-3, reach = 107.95e-3;
  const auto cutters =
      bit::read_cutter_table(TDBD_SOURCE_DIR "/cases/bits/bit-b.csv", bit::CutterDefaults{});
  const PlanarCut cut = planar_cut(cutters, advance, column);
  double area = 0.0, volume = 0.0;
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    area += cut.area[i];
    volume += cut.volume[i];
  }
  const double disc = std::numbers::pi * reach * reach * advance;
  EXPECT_NEAR(area, reach * advance, 2e-4 * reach * advance);
  EXPECT_NEAR(volume, disc, 2e-4 * disc);
}

}  // namespace
}  // namespace tdbd::reference::planar_outline_test
