#pragma once

#include <string>
#include <vector>

#include "sweep/design/design.hpp"

namespace tdbd::sweep {

/// Returns a word together with its number and unit, if it has them.
Level level_of(const ConfigWord& word);

/// Returns a number with a unit as a level: "7.5 mm".
Level level_at(double number, const std::string& unit);

/// Returns the interval of a factor with from and to. Records mistakes: ends that are not numbers,
/// have different units, or are not allowed on a logarithmic scale.
Interval interval_of(Config& factor, const FactorSettings& settings);

/// Returns the position at a fraction u of the interval, 0 <= u <= 1. The ends are exact.
double place_in(const Interval& i, double u);

/// Returns evenly spaced levels, including both ends. `count`: at least two.
std::vector<Level> levels_in(const Interval& i, long count);

/// Largest number of dimensions for which GSL has direction numbers.
inline constexpr long most_sobol_dimensions = 40;

/// Whether a factor has an interval instead of levels.
bool is_sampled(const Factor& f);

/// Returns the samples of a design: rows of fractions in [0, 1), with one column per sampled
/// factor. Each column of a Latin hypercube (McKay, Beckman and Conover 1979) has one value in each
/// of `samples` equal parts. Sobol's sequence (1967) begins with its first point, which is the
/// centre.
std::vector<std::vector<double>> samples_of(const Design& d);

/// The points of a design: all combinations of levels and samples. Samples vary fastest, then the
/// levels of the last factor.
struct Points {
  long count = 0;
  std::vector<std::vector<double>> samples;
};
Points points_of(const Design& d);

/// Returns the level of each factor at a point.
std::vector<Level> levels_at(const Design& d, const Points& points, long index);

/// Returns the overrides of a point: the fixed values, then those of the factors.
std::vector<std::string> overrides_at(const Design& d, const Points& points, long index);

}  // namespace tdbd::sweep
