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

/// How the loss of a window is given to the wear step.
enum class Given { as_volume, as_height };

/// The largest relative error of the worn volume at the end, over the cutters, with so many windows.
/// Windows of two lengths in turn, so that the method's weights for unequal windows count.
double error_of(const Problem& p, int windows, Given given) {
  WearState s;
  std::vector<bit::WearFlat> flats;
  for (const bit::WearSolid& solid : p.solids) {
    flats.push_back(bit::flat_at(solid, solid.start + p.start));
    s.pieces.push_back({.volume = flats.back().volume, .height = flats.back().height});
  }
  const double mean = duration / windows;
  for (int k = 0; k < windows; ++k) {
    const double time = (k % 2 == 0 ? 0.8 : 1.2) * mean;
    for (std::size_t i = 0; i < flats.size(); ++i)
      s.pieces[i].window = given == Given::as_height
                               ? WearAmount{0.0, wear_speed * time}
                               : WearAmount{wear_speed * flats[i].area * time, 0.0};
    s.window_time = time;
    take_wear_step(p.solids, s, flats);
  }
  double error = 0.0;
  for (std::size_t i = 0; i < flats.size(); ++i) {
    const bit::WearSolid& solid = p.solids[i];
    const double h0 = solid.start + p.start;
    const double exact = bit::flat_at(solid, h0 + wear_speed * duration).volume;
    error = std::max(error, std::abs(s.pieces[i].volume - exact) / exact);
  }
  return error;
}

constexpr std::array levels{16, 32, 64, 128, 256};

/// Of errors over the length of windows: least squares of the logarithms, five levels.
template <class Error>
double order_of(Error error) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const int n : levels) {
    const double x = -std::log(static_cast<double>(n)), y = std::log(error(n));
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double count = levels.size();
  return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

TEST(WearOrder, is_2_in_the_length_of_a_window) {
  const Problem p = problem();
  const auto error = [&](int n) { return error_of(p, n, Given::as_volume); };
  const double order = order_of(error);
  RecordProperty("order", std::to_string(order));
  EXPECT_GE(order, 1.8);
  EXPECT_LE(order, 2.2);
  EXPECT_LT(error(levels.back()), 1e-4);
}

/// Where the flat bears, a steady stress takes height evenly: no step is too long.
TEST(WearOrder, has_no_error_but_rounding_where_flats_bear_under_a_steady_stress) {
  constexpr double rounding = 1e-13;
  EXPECT_LT(error_of(problem(), 4, Given::as_height), rounding);
}

/// A flat whose stress decreases as it grows, on a cutter that wears elsewhere, too:
///   V' = u/(1 + h/h1) A(h) + q
/// without a solution in closed form. Errors are differences to 16384 windows.
TEST(WearOrder, is_2_where_a_flat_bears_and_its_cutter_wears_elsewhere) {
  const Problem p = problem();
  const std::size_t cutter = 7;
  constexpr double elsewhere = 1e-11;     // m3/s, a third of what the flat loses
  constexpr double half_stress = 0.5e-3;  // m, h1
  const auto volume = [&](int windows) {
    WearState s;
    const bit::WearSolid& solid = p.solids[cutter];
    std::vector<bit::WearFlat> flats{bit::flat_at(solid, solid.start + p.start)};
    s.pieces.push_back({.volume = flats[0].volume, .height = flats[0].height});
    for (int k = 0; k < windows; ++k) {
      const double time = (k % 2 == 0 ? 0.8 : 1.2) * duration / windows;
      const double grown = s.pieces[0].height - solid.start;
      s.pieces[0].window = {elsewhere * time, wear_speed * time / (1.0 + grown / half_stress)};
      s.window_time = time;
      take_wear_step({solid}, s, flats);
    }
    return s.pieces[0].volume;
  };
  const double exact = volume(16384);
  const double order = order_of([&](int n) { return std::abs(volume(4 * n) - exact); });
  RecordProperty("order", std::to_string(order));
  EXPECT_GE(order, 1.8);
  EXPECT_LE(order, 2.2);
}

}  // namespace
}  // namespace tdbd::simulation::wear_order_test
