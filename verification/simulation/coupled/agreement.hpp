#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

/// How a twin and the program are compared: each at three levels, within what both may err.
namespace tdbd::simulation {

/// A quantity at three levels of refinement, each halving the one before: coarse, middle, fine.
using Levels = std::array<double, 3>;

/// The numerical uncertainty of the finest level: its error, if errors halve from level to level or
/// fall faster, times the factor of safety 1.25 that Roache gives for three levels. The coarser
/// difference counts half, so that two levels which agree by chance do not pass for exact.
inline double uncertainty_of(const Levels& x) {
  constexpr double safety = 1.25;
  return safety * std::max(std::abs(x[2] - x[1]), 0.5 * std::abs(x[1] - x[0]));
}

/// What differences count relative to, and the largest combined uncertainty relative to it.
struct Measure {
  std::string quantity;
  double scale = 0.0;  ///< in the quantity's unit; 0: the twin's value
  double limit = 0.02;
};

/// The two agree within the combined uncertainty, and that is below its limit. Writes a row for
/// reports/studies/coupled-twin.
inline void expect_agreement(const Measure& m, const Levels& program, const Levels& twin) {
  const double difference = program[2] - twin[2];
  const double own = uncertainty_of(program), others = uncertainty_of(twin);
  const double scale = m.scale > 0.0 ? m.scale : std::abs(twin[2]);
  constexpr double rounding = 1e-9;  // of the scale
  const std::string row = fmt::format("{:.8g};{:.3g};{:.8g};{:.3g};{:.3g};{:.3g}", program[2], own,
                                      twin[2], others, difference, scale);
  testing::Test::RecordProperty(m.quantity, row);
  std::printf("row;%s;%s\n", m.quantity.c_str(), row.c_str());
  EXPECT_LE(std::abs(difference), own + others + rounding * scale)
      << m.quantity << ": program " << program[0] << " " << program[1] << " " << program[2]
      << ", twin " << twin[0] << " " << twin[1] << " " << twin[2];
  EXPECT_LE(own + others, m.limit * scale) << m.quantity << ": the uncertainty is too large";
}

}  // namespace tdbd::simulation
