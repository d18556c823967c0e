#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

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

/// A quantity at equal times, at three levels.
using Trajectories = std::array<std::vector<double>, 3>;

/// The root of the mean square of what two trajectories differ by.
inline double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  EXPECT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// The same for all times together: at a single time two levels may cross.
inline double uncertainty_of(const Trajectories& x) {
  const double coarse = distance(x[0], x[1]);
  return uncertainty_of(Levels{0.0, coarse, coarse + distance(x[1], x[2])});
}

/// What each has, and how far they are apart.
struct Compared {
  double program, own, twin, others, difference, scale;
};

/// Writes a row for reports/studies/coupled-twin.
inline void write_row(const Measure& m, const Compared& c) {
  fmt::print("row;{};{:.8g};{:.3g};{:.8g};{:.3g};{:.3g};{:.3g}\n", m.quantity, c.program, c.own,
             c.twin, c.others, c.difference, c.scale);
}

/// The two agree within the combined uncertainty, and that is below its limit.
inline void expect_agreement(const Measure& m, const Compared& c) {
  constexpr double rounding = 1e-9;  // of the scale
  write_row(m, c);
  EXPECT_LE(std::abs(c.difference), c.own + c.others + rounding * c.scale) << m.quantity;
  EXPECT_LE(c.own + c.others, m.limit * c.scale) << m.quantity << ": the uncertainty is too large";
}

inline Compared compared(const Measure& m, const Levels& program, const Levels& twin) {
  const double scale = m.scale > 0.0 ? m.scale : std::abs(twin[2]);
  return {program[2],           uncertainty_of(program), twin[2],
          uncertainty_of(twin), program[2] - twin[2],    scale};
}

/// Of trajectories their last values are written, and their distance.
inline void expect_agreement(const Measure& m, const Trajectories& program,
                             const Trajectories& twin) {
  expect_agreement(m, Compared{program[2].back(), uncertainty_of(program), twin[2].back(),
                               uncertainty_of(twin), distance(program[2], twin[2]), m.scale});
}

/// Three levels of what a side finds, `of` how much finer than the coarsest.
template <class Of>
auto levels(const Of& of) {
  return std::array{of(1), of(2), of(4)};
}

/// A number of what both sides found.
template <class Found, class Of>
void compare(const std::string& quantity, double scale, const std::array<Found, 3>& program,
             const std::array<Found, 3>& twin, const Of& of, double limit = 0.02) {
  const Measure m{quantity, scale, limit};
  expect_agreement(m, compared(m, {of(program[0]), of(program[1]), of(program[2])},
                               {of(twin[0]), of(twin[1]), of(twin[2])}));
}

/// A number in which the two are known to disagree: a row for the study, and no expectation.
template <class Found, class Of>
void report_disagreement(const std::string& quantity, const std::array<Found, 3>& program,
                         const std::array<Found, 3>& twin, const Of& of) {
  const Measure m{quantity};
  write_row(m, compared(m, {of(program[0]), of(program[1]), of(program[2])},
                        {of(twin[0]), of(twin[1]), of(twin[2])}));
}

/// A trajectory of what both sides found.
template <class Found>
void compare_ways(const std::string& quantity, double scale, const std::array<Found, 3>& program,
                  const std::array<Found, 3>& twin, std::vector<double> Found::*of,
                  double limit = 0.02) {
  expect_agreement({quantity, scale, limit},
                   Trajectories{program[0].*of, program[1].*of, program[2].*of},
                   Trajectories{twin[0].*of, twin[1].*of, twin[2].*of});
}

}  // namespace tdbd::simulation
