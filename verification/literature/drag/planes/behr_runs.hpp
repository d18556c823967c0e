#pragma once

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "literature/drag/example_cutters.hpp"
#include "reference/literature/drag/planes/behr.hpp"
#include "reference/literature/drag/planes/bottom_harmonics.hpp"

namespace tdbd::reference {

inline constexpr double example_speed = 4 * std::numbers::pi;  ///< rad/s, 120 rpm
inline constexpr double example_advance = 3e-3;                ///< m per revolution
inline constexpr int steps_a_turn = 500;                       ///< of 1 ms

/// Two seconds, four revolutions, and one more that is reported.
struct FifthTurn {
  BehrState state;
  BehrRun run;
};

inline FifthTurn fifth_turn(char bit, const BitPath& path, const BehrOptions& options) {
  FifthTurn t{behr_start(example_cutters(bit), path(0.0), options), {}};
  const double turn = 2 * std::numbers::pi / example_speed, dt = turn / steps_a_turn;
  behr_run(t.state, path, 0.0, dt, 4 * steps_a_turn, rock_k(), options);
  t.run = behr_run(t.state, path, 4 * turn, dt, steps_a_turn, rock_k(), options);
  return t;
}

/// Bit B rolls backwards in a hole that is larger by `e` (m) all round.
inline FifthTurn whirl_turn(double e, int planes, ForceTime force_time = ForceTime::spread) {
  const RollingWhirl whirl{example_gage, e, example_speed};
  BehrOptions options;
  options.force_time = force_time;
  options.planes = planes;
  options.radius = whirl.hole_radius();
  return fifth_turn('b', whirl_path(whirl, example_advance), options);
}

inline double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

/// Where the whirl's pattern is looked at.
inline BottomHarmonics near_the_gage(const FifthTurn& t) {
  return bottom_harmonics(depth_on_circle(t.state.bottom, 100e-3));
}

/// Root mean square of a series about its mean, over its mean, after averaging `block` values.
inline double relative_noise(const std::vector<double>& series, std::size_t block) {
  const std::size_t count = series.size() / block;
  std::vector<double> mean(count);
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < block; ++k) mean[i] += series[i * block + k];
    sum += mean[i];
  }
  const double average = sum / static_cast<double>(count);
  for (const double m : mean) squares += (m - average) * (m - average);
  return std::sqrt(squares / static_cast<double>(count)) / average;
}

/// Torque of bit A in steady drilling, steps of 1 ms, two seconds after two revolutions.
inline std::vector<double> steady_torque(int planes, ForceTime force_time) {
  const BitPath path = steady_path(example_speed, example_advance);
  BehrOptions options;
  options.planes = planes;
  options.radius = example_gage;
  options.force_time = force_time;
  BehrState state = behr_start(example_cutters('a'), path(0.0), options);
  constexpr double dt = 1e-3;
  behr_run(state, path, 0.0, dt, 1000, rock_k(), options);
  return behr_run(state, path, 1.0, dt, 2000, rock_k(), options).torque;
}

}  // namespace tdbd::reference
