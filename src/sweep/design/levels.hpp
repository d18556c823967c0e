#pragma once

#include "sweep/design/design.hpp"

namespace tdbd::sweep {

/// A word with the number and the unit in it, if it has them.
Level level_of(const ConfigWord& word);

/// A number in a unit, as a level: "7.5 mm".
Level level_at(double number, const std::string& unit);

/// Reads from, to and scale of a factor; notes ends that are no numbers, of two units, or that a
/// logarithm does not take.
Interval read_interval(Config& factor);

/// The place at a share u of the interval, 0 <= u <= 1: the ends are exact.
double place_in(const Interval& i, double u);

/// Evenly spread, ends included; at least two.
std::vector<Level> levels_in(const Interval& i, long count);

}  // namespace tdbd::sweep
