#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "bit/files/bit_file.hpp"
#include "simulation/step/wear.hpp"

namespace tdbd::simulation::wear_order_test {
namespace {

constexpr double wear_speed = 1e-4;  ///< m of height per s
constexpr double duration = 8.0;     ///< s: flats of 0.8 mm more than at the start

/// Under a steady stress and temperature a flat loses its height at a constant speed u, as in the
/// reference (wear_speed): V' = u A(V), with the exact solution V(t) = V(h0 + u t) of the mesh.
struct Problem {
  std::vector<bit::WearSolid> solids;
  double start = 0.4e-3;  ///< m, height h0 above that of the fresh cutter
};

Problem problem() {
  const auto file =
      bit::read_bit(TDBD_SOURCE_DIR "/cases/bits/bit-b.toml", bit::DirectionRule::hybrid,
                    bit::InsideRule::down, bit::Densities::as_given, {});
  return {bit::wear_solids(file.bit)};
}

/// The largest relative error of the worn volume at the end, over the cutters, with so many windows.
/// Windows of two lengths in turn, so that the method's weights for unequal windows count.
double error_of(const Problem& p, int windows) {
  WearState s;
  std::vector<bit::WearFlat> flats;
  for (const bit::WearSolid& solid : p.solids) {
    flats.push_back(bit::flat_at(solid, solid.start + p.start));
    s.cutters.push_back({.volume = flats.back().volume, .height = flats.back().height});
  }
  const double mean = duration / windows;
  for (int k = 0; k < windows; ++k) {
    const double time = (k % 2 == 0 ? 0.8 : 1.2) * mean;
    for (std::size_t i = 0; i < flats.size(); ++i)
      s.cutters[i].window = wear_speed * flats[i].area * time;
    s.window_time = time;
    take_wear_step(p.solids, s, flats);
  }
  double error = 0.0;
  for (std::size_t i = 0; i < flats.size(); ++i) {
    const bit::WearSolid& solid = p.solids[i];
    const double h0 = solid.start + p.start;
    const double exact = bit::flat_at(solid, h0 + wear_speed * duration).volume;
    error = std::max(error, std::abs(s.cutters[i].volume - exact) / exact);
  }
  return error;
}

/// Least squares of log error over log window, five levels.
TEST(WearOrder, is_2_in_the_length_of_a_window) {
  const Problem p = problem();
  constexpr std::array levels{16, 32, 64, 128, 256};
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const int n : levels) {
    const double x = -std::log(static_cast<double>(n)), y = std::log(error_of(p, n));
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double count = levels.size();
  const double order = (count * sxy - sx * sy) / (count * sxx - sx * sx);
  RecordProperty("order", std::to_string(order));
  EXPECT_GE(order, 1.8);
  EXPECT_LE(order, 2.2);
  EXPECT_LT(error_of(p, levels.back()), 1e-4);
}

}  // namespace
}  // namespace tdbd::simulation::wear_order_test
