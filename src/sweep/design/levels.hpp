#pragma once

#include "sweep/design/design.hpp"

namespace tdbd::sweep {

/// Returns a word together with its number and unit, if it has them.
Level level_of(const ConfigWord& word);

/// Returns a number with a unit as a level: "7.5 mm".
Level level_at(double number, const std::string& unit);

/// Reads from, to and scale of a factor. Records mistakes: ends that are not numbers, have
/// different units, or are not allowed on a logarithmic scale.
Interval read_interval(Config& factor);

/// Returns the position at a fraction u of the interval, 0 <= u <= 1. The ends are exact.
double place_in(const Interval& i, double u);

/// Returns evenly spaced levels, including both ends. `count`: at least two.
std::vector<Level> levels_in(const Interval& i, long count);

}  // namespace tdbd::sweep
