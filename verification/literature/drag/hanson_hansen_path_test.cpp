#include "reference/literature/drag/hanson_hansen_path.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <numbers>

#include "bit/cutter/cutter_table.hpp"
#include "core/error.hpp"
#include "reference/literature/drag/planar_outline.hpp"

namespace tdbd::reference::hanson_hansen_path_test {
namespace {

constexpr double pi = std::numbers::pi, turn_rate = 4.0 * pi;  // 120 rpm
constexpr double advance = 3e-3, reach = 107.95e-3;

HansonHansenRock rock_k() {
  HansonHansenRock rock;
  rock.shared = {100e6, 0.8, 0.0, 0.0};
  return rock;
}

std::vector<bit::Cutter> example(const std::string& letter) {
  return bit::read_cutter_table(TDBD_SOURCE_DIR "/cases/bits/bit-" + letter + ".csv",
                                bit::CutterDefaults{});
}

TEST(HansonHansenPath, cuts_what_the_radial_plane_says_when_it_cannot_move_sideways) {
  for (const char* letter : {"a", "b", "c"})
    for (const double spacing : {0.5e-3, 1e-3, 2e-3}) {
      const auto cutters = example(letter);
      HansonHansenDrilling d;
      d.rotary_speed = turn_rate;
      d.advance = advance;
      d.layout.spacing = spacing;
      const auto t0 = std::chrono::steady_clock::now();
      const PathRun run = hanson_hansen_steady(cutters, rock_k(), d);
      const double secs =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
      const PlanarCut plane = planar_cut(cutters, advance, 0.01e-3);
      double worst = 0.0, sa = 0.0;
      int which = 0;
      for (std::size_t i = 0; i < cutters.size(); ++i) {
        sa += run.area[i];
        if (plane.area[i] > 1e-6 && std::abs(run.area[i] / plane.area[i] - 1.0) > worst)
          worst = std::abs(run.area[i] / plane.area[i] - 1.0), which = static_cast<int>(i);
      }
      std::printf(
          "%s %.1f: WOB %.1f TOB %.2f (%.2f) worst %.4f (%d: %.3f) lateral %.2f%% area %.5f; %.2f "
          "s\n",
          letter, spacing * 1e3, run.wob, run.tob, 100e6 * reach * reach * advance / 2, worst,
          which, plane.area[which] * 1e6, 100 * run.lateral_B.norm() / run.wob,
          sa / (reach * advance), secs);
    }
}

}  // namespace
}  // namespace tdbd::reference::hanson_hansen_path_test
